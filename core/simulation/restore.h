#pragma once
// Takes a world back to the state of a checkpoint.
#include <string_view>

#include "state/checkpoint.h"

namespace morula {

/// Puts the state back into a world that makeWorld has made of the same scene; the scene's stop conditions and the
/// execution may differ. Throws InputError, and leaves the world as it is, unless the checkpoint is whole, of this
/// version and of this scene.
void restoreState(World& world, std::string_view checkpoint);

struct SavedState;
/// Puts a state that was read for this world [readCheckpoint] into it.
void takeState(World& world, SavedState state);

}  // namespace morula
