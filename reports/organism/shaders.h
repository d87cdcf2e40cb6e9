#pragma once
// GLSL sources of the shaders. Space is eye space relative to the framing's centre: x right, y up, z to the eye, which
// is at z = eyeDistance. Light is linear until the last pass.
#include <compare>
#include <string>

namespace morula {

/// Passes over the surfaces of cells, which write lit colour, normal, depth and cell of each sample. `cut` draws the
/// clip plane in place of the surface. `count` counts the translucent surfaces at each sample, `list` lists them
/// (veil_lists.h).
enum class CellPass { whole, cut, count, list };
struct CellProgram {
  CellPass pass = CellPass::whole;
  bool clipped = false;  // parts beyond a plane are cut away
  bool mapped = false;   // some cells have a colour per vertex
  friend auto operator<=>(const CellProgram&, const CellProgram&) = default;
};
std::string cellVertexShader(bool mapped);
std::string cellFragmentShader(const CellProgram& program);
inline constexpr int scaleSteps = 1024;  // number of colours in the texture for maps

/// Line marks are flat ribbons that face the eye.
std::string lineVertexShader();
std::string lineFragmentShader();

}  // namespace morula
