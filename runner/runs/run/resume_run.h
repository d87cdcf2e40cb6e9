#pragma once
// Going on with a stopped run from its last checkpoint.
#include <cstdint>
#include <optional>

#include "loop/run.h"
#include "loop/samples.h"
#include "store/store.h"

namespace morula {

/// Puts the run and its observers where its last checkpoint left them, or else a run that this one goes on from
/// [mother.h], and returns the step. `from`: the id of that run; "": any of the file. The run is then begun, and
/// `record` names its mother. Without a checkpoint nothing changes, and stderr says why there is none: which runs there
/// are, and what differs. Throws FileError for a checkpoint that cannot be used, UsageError if it was made with other
/// records, or if `from` is given and the run cannot go on from there.
std::optional<std::uint64_t> resumeRun(Store& store, RunRecord& record, Run& run, const RecordOptions& recording,
                                       const std::string& from, bool quiet);

}  // namespace morula
