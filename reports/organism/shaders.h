#pragma once
// The programs that run per vertex and per pixel, as GLSL text. Space is eye space relative to the framing's
// centre: x right, y up, z to the eye, the eye itself at z = eyeDistance. Light is linear until the last
// pass.
#include <string>

namespace morula {

/// Surfaces of cells: lit colour, normal and depth, and which cell it is, for each sample. A layer of `peel`
/// is the nearest surface behind the one before it. `clipped`: what lies beyond a plane is cut away. `cut`: instead of
/// the surface itself, the plane before it is drawn.
enum class CellPass { whole, peel, clipped, clippedPeel, cut };
std::string cellVertexShader();
std::string cellFragmentShader(CellPass pass);

/// Line marks as flat ribbons that face the eye.
std::string lineVertexShader();
std::string lineFragmentShader();

/// Passes over the whole picture.
std::string screenVertexShader();
std::string occlusionShader();      // how much of the sky a pixel's surface sees, from depths around it
std::string occlusionBlurShader();  // evens out that pattern inside each cell
std::string layerShader();          // one translucent layer, under those before it
std::string resolveShader();        // outlines, shading, shell, mean of the samples, sRGB

}  // namespace morula
