#pragma once
// A world's state on file; simulation/restore.h puts it back into a world. A run from a checkpoint goes on bit for bit
// as it would have without one, on any machine, instruction set and number of threads.
//
//   "MORULACP" · version · length · fields (base/fields.h) · XXH3-128 of version and fields
//
// The fields are listed in state_fields.h. Parts that a scene lacks are not in its checkpoints.
#include <string>
#include <string_view>

#include "state/world.h"

namespace morula {

/// The format that this program writes and reads.
constexpr std::uint64_t checkpointVersion = 4;

/// Returns the state of a world between two steps. Throws BugError for numbers that are not finite, as a world may hold
/// whose step has failed.
std::string saveState(const World& world);

}  // namespace morula
