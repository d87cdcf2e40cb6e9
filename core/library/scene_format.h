#pragma once
// A scene as text, for programs that have the simulator but know no scenario files: run_scene of the tests, the
// simulator in reports' pages, and others. A scenario is for people. The text of a scene holds exactly what decides a
// run, with the bits of all numbers.
//
//   morula-scene 3
//   11 unique-four         a text: its bytes, a blank, and the text
//   20080617               a number: whole, or the 64 bits of a double
//   …                      the members of Scene in order; 0 or 1 before an optional member, the length before a list
//   hash 0f1e…             XXH3-128 of all that stands above
#include <string>
#include <string_view>

#include "state/scene.h"

namespace morula {

inline constexpr int sceneFormat = 3;

std::string writeScene(Scene scene);

/// Reads a text of writeScene. Throws InputError "NAME:line: what is wrong; what would be right" for anything else:
/// another version, a byte changed, cut off or added, or a value that a member of Scene cannot have.
Scene readScene(std::string_view text, const std::string& name);

}  // namespace morula
