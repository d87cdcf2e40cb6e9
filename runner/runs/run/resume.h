#pragma once
// morula run --resume: a run that was stopped goes on from its last checkpoint.
#include <cstdint>
#include <optional>

#include "pictures/pictures.h"
#include "store/recorder.h"
#include "store/store.h"

namespace morula {

/// Puts world, recorder and frames where the run's last checkpoint left them, and returns its step. Without a
/// checkpoint nothing changes, and stderr says why there is none: which runs there are, and what differs.
/// Throws FileError for a checkpoint that cannot be used, UsageError if it was made with other records.
std::optional<std::uint64_t> resumeRun(Store& store, const RunRecord& record, World& world, Recorder& recorder,
                                       FrameCollector& frames, bool quiet);

}  // namespace morula
