#pragma once
#include <stdexcept>

namespace morula {

/// The error of a wrong command line. The program ends with exit code 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace morula
