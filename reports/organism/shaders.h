#pragma once
// The programs that run per vertex and per pixel, as GLSL text. Space is eye space relative to the framing's centre: x
// right, y up, z to the eye, the eye itself at z = eyeDistance. Light is linear until the last pass.
#include <compare>
#include <string>

namespace morula {

/// Surfaces of cells: lit colour, normal and depth, and which cell it is, for each sample. `cut`: instead of the
/// surface itself, the clip plane before it. `count` and `list`: how many translucent surfaces each sample meets, and
/// their list (veil_lists.h).
enum class CellPass { whole, cut, count, list };
struct CellProgram {
  CellPass pass = CellPass::whole;
  bool clipped = false;  // what lies beyond a plane is cut away
  bool mapped = false;   // some cells have a colour that changes from vertex to vertex
  friend auto operator<=>(const CellProgram&, const CellProgram&) = default;
};
std::string cellVertexShader(bool mapped);
std::string cellFragmentShader(const CellProgram& program);
inline constexpr int scaleSteps = 1024;  // colours of the scale for maps that the cells' shader is given

/// Line marks as flat ribbons that face the eye.
std::string lineVertexShader();
std::string lineFragmentShader();

}  // namespace morula
