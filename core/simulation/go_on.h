#pragma once
// Goes on from the state of another run, to a later stop or with further experiments.
#include <cstddef>
#include <string_view>

#include "state/world.h"

namespace morula {

/// Puts the state into a world that makeWorld has made of the same scene with another stop, and with `added` further
/// experiments at the end of its list. The world then goes on as if its scene had been computed from the start.
///
/// Throws InputError, and leaves the world as it is, where that would not hold: the checkpoint is damaged or of another
/// scene, or a stop or a further experiment of the world's scene may have been due by then.
void goOnFrom(World& world, std::string_view checkpoint, std::size_t added);

}  // namespace morula
