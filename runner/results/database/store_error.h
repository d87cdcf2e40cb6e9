#pragma once
// Errors of a file of results. The runner turns these into exit codes.
#include <string>

#include "base/error.h"

namespace morula {

/// An error of a file or database that cannot be used. The text names the file, the reason and a remedy. Exit 6.
struct StoreError : FileError {
  using FileError::FileError;
};

/// The error if another process held the file longer than the patience of this one. Exit 6.
struct BusyError : StoreError {
  using StoreError::StoreError;
};

/// The error if one scenario, seed and build gave two different results. The earlier result stays in the database. It
/// counts as a check that differs (exit 1); code that catches only FileErrors reports it as exit 6.
struct NondeterminismError : StoreError {
  NondeterminismError(const std::string& text, std::string runId, std::string stored, std::string computed)
      : StoreError(text), runId(std::move(runId)), stored(std::move(stored)), computed(std::move(computed)) {}
  std::string runId;
  std::string stored, computed;  // state hashes, or the status of a run that has none
};

}  // namespace morula
