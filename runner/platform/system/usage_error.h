#pragma once
#include <stdexcept>

namespace morula {

/// The command line is wrong. Exit 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace morula
