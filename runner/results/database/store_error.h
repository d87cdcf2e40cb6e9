#pragma once
// Errors of a file of results. The runner turns these into exit codes.
#include <string>

#include "base/error.h"

namespace morula {

/// The file or the database cannot be used: the text names the file, the reason and what would help. Exit 6.
struct StoreError : FileError {
  using FileError::FileError;
};

/// Another process held the file for longer than this one waits. Exit 6.
struct BusyError : StoreError {
  using StoreError::StoreError;
};

/// One scenario, seed and build gave two different results. The earlier result stays in the database. A check
/// that differs, so exit 1; code that catches FileErrors alone reports it as exit 6.
struct NondeterminismError : StoreError {
  NondeterminismError(const std::string& text, std::string runId, std::string stored, std::string computed)
      : StoreError(text), runId(std::move(runId)), stored(std::move(stored)), computed(std::move(computed)) {}
  std::string runId;
  std::string stored, computed;  // state hashes, or the status of a run that has none
};

}  // namespace morula
