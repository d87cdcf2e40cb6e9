#pragma once
// Going on with a stopped run from its last checkpoint.
#include <cstdint>
#include <optional>

#include "loop/run.h"
#include "loop/samples.h"
#include "store/store.h"

namespace morula {

/// Puts the run and its observers where its last checkpoint left them, and returns the step. Without a checkpoint
/// nothing changes, and stderr says why there is none: which runs there are, and what differs. Throws FileError for a
/// checkpoint that cannot be used, UsageError if it was made with other records.
std::optional<std::uint64_t> resumeRun(Store& store, const RunRecord& record, Run& run, const RecordOptions& recording,
                                       bool quiet);

}  // namespace morula
