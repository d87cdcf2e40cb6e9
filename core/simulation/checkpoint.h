#pragma once
// A world's state on file, and back: what goes on from a checkpoint is bit for bit what would have gone on
// without one, on any machine, instruction set and number of threads.
//
//   "MORULACP" · version · length · fields (base/fields.h) · XXH3-128 of version and fields
//
// The fields are listed in state_fields.h. What a scene has not is not in its checkpoints.
#include <string>
#include <string_view>

#include "simulation/world.h"

namespace morula {

/// The format that this program writes and reads.
constexpr std::uint64_t checkpointVersion = 4;

/// A world between two steps. Not one whose step has failed: what it holds may be no numbers, which is
/// a BugError otherwise.
std::string saveState(const World& world);

/// Puts the state back into a world that makeWorld has made of the same scene; the scene's stop conditions
/// and the execution may be others. Throws InputError, and leaves the world as it is, for what is not a whole
/// checkpoint of this version and of this scene.
void restoreState(World& world, std::string_view checkpoint);

}  // namespace morula
