#pragma once
// What the shaders have in common; for the files of shaders.h only.

namespace morula::shader {

inline constexpr char version[] = "#version 430 core\n";

// Owners: 0 nothing, 1 and up a cell, lineOwner a line mark.
inline constexpr char common[] = R"(
const uint lineOwner = 0x80000000u;
uniform ivec2 size;          // of the sample grid
uniform vec2 aperture;       // half of the picture at distance 1
uniform float eyeDistance;

// The point in eye space that a sample sees at depth z.
vec3 eyePoint(vec2 sampleAt, float z) {
  vec2 ray = (2.0 * (sampleAt + 0.5) / vec2(size) - 1.0) * aperture;
  return vec3(ray * (eyeDistance - z), z);
}
)";

}  // namespace morula::shader
