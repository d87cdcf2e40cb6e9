#pragma once
// A scene as a text of its own, for programs that have the simulator and know no scenario files: run_scene of the
// tests, pages that run again, other programs. A scenario is for people; this holds exactly what decides a run, all
// numbers as their bits.
//
//   morula-scene 3
//   11 unique-four         a text: its bytes, a blank, and the text
//   20080617               a number: whole, or the 64 bits of a double
//   …                      the members of Scene, one after the other; before what may be absent 0 or 1, before a list its length
//   hash 0f1e…             XXH3-128 of all that stands above
#include <string>
#include <string_view>

#include "simulation/scene.h"

namespace morula {

inline constexpr int sceneFormat = 3;

std::string writeScene(Scene scene);

/// Reads just what writeScene writes. Throws InputError "NAME:line: what is wrong; what would be right" for anything
/// else: another version, a byte that was changed, cut off or added, a number that its member cannot be.
Scene readScene(std::string_view text, const std::string& name);

}  // namespace morula
