// The shaders of cells and lines.
#include "organism/shaders.h"

namespace morula {
namespace {

constexpr char version[] = "#version 430 core\n", common[] = R"(
const uint lineOwner = 0x80000000u;  // as in samples.h
uniform ivec2 size;                  // of the sample grid
uniform vec2 aperture;               // half of the picture at distance 1
uniform float eyeDistance;
)";

}  // namespace

std::string cellVertexShader(bool mapped) {
  return std::string(version) + (mapped ? "#define MAP\n" : "") + R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 direction;
layout(location = 2) in vec3 corner;   // barycentric in the mesh's face
layout(location = 3) in vec4 pigment;  // linear colour and opacity
layout(location = 4) in uint cell;
uniform mat4 projection;
out vec3 eyeNormal, eyePosition, faceCorner;
flat out vec4 cellPigment;
flat out uint cellOwner;
#ifdef MAP
layout(location = 5) in float share;  // below 0: the cell has one colour
out float mapShare;
#endif
void main() {
  eyePosition = position;
  eyeNormal = direction;
  faceCorner = corner;
  cellPigment = pigment;
  cellOwner = cell;
#ifdef MAP
  mapShare = share;
#endif
  gl_Position = projection * vec4(position, 1.0);
}
)";
}

std::string cellFragmentShader(const CellProgram& program) {
  const bool lists = program.pass == CellPass::count || program.pass == CellPass::list;
  std::string parts = lists ? "#define LIST\n" : "";
  if (program.pass == CellPass::count) parts += "#define COUNT\n";
  if (program.pass == CellPass::cut) parts += "#define CUT\n";
  if (program.clipped) parts += "#define CLIP\n";
  if (program.mapped) parts += "#define MAP\n";
  return std::string(version) + parts + common + R"(
in vec3 eyeNormal, eyePosition, faceCorner;
flat in vec4 cellPigment;
flat in uint cellOwner;
#ifdef LIST
layout(early_fragment_tests) in;  // solid cells hide what is behind them
layout(std430, binding = 0) buffer Cursors { uint cursors[]; };  // of each sample of the rows that are drawn
layout(std430, binding = 1) buffer Fragments { uvec4 fragments[]; };
uniform int firstRow;
#else
layout(location = 0) out vec4 light;
layout(location = 1) out uint owner;
layout(location = 2) out vec4 normal;
layout(location = 3) out float height;  // z in eye space
#endif
uniform int wireframe;
uniform float wireWidth;  // [sample]
uniform vec3 paperLight;
#ifdef CLIP
uniform vec4 clip;  // in eye space: what has dot(clip.xyz, place) > clip.w is cut away
uniform mat4 projection;
#endif
#ifdef MAP
in float mapShare;
uniform sampler2D scale;  // its colours in linear light, from the least share to the greatest
#endif

const vec3 keyLight = normalize(vec3(-0.55, 0.75, 0.70));
const vec3 fillLight = normalize(vec3(0.85, -0.10, 0.55));

// A large lamp: it reaches a little round the edge and fades out there without a visible border.
float soft(float cosine, float reach) {
  float share = max(0.0, (cosine + reach) / (1.0 + reach));
  return share * share;
}

vec3 lit(vec3 pigment, vec3 n, vec3 v) {
  float key = soft(dot(n, keyLight), 0.70), fill = soft(dot(n, fillLight), 0.50);
  vec3 sky = mix(vec3(0.25, 0.24, 0.25), vec3(0.40, 0.42, 0.45), 0.5 + 0.5 * n.y);
  vec3 light = sky + key * vec3(0.76, 0.74, 0.70) + fill * vec3(0.14, 0.15, 0.18);
  float facing = max(0.0, dot(n, v));
  float rim = (1.0 - facing) * (1.0 - facing) * (1.0 - facing);
  float shine = max(0.0, dot(n, normalize(keyLight + v)));
  shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine;  // to the 32nd
  return pigment * light + rim * 0.30 * (0.6 * pigment + 0.4 * vec3(0.8, 0.85, 0.95)) + 0.10 * shine;
}

// How much of the sample a mesh edge covers, with the lines thinned out where faces are only a few samples wide.
float wire() {
  vec3 perSample = vec3(length(vec2(dFdx(faceCorner.x), dFdy(faceCorner.x))),
                        length(vec2(dFdx(faceCorner.y), dFdy(faceCorner.y))),
                        length(vec2(dFdx(faceCorner.z), dFdy(faceCorner.z))));
  vec3 away = faceCorner / max(perSample, vec3(1e-9));  // [sample] from each edge
  float nearest = min(away.x, min(away.y, away.z));
  float height = 1.0 / max(1e-9, max(perSample.x, max(perSample.y, perSample.z)));  // the face's smallest
  return clamp(0.5 * wireWidth + 0.5 - nearest, 0.0, 1.0) * clamp(height / (4.0 * wireWidth), 0.25, 1.0);
}

vec3 pigmentHere() {
#ifdef MAP
  int last = textureSize(scale, 0).x - 1;
  if (mapShare > -0.5) return texelFetch(scale, ivec2(clamp(int(mapShare * float(last) + 0.5), 0, last), 0), 0).rgb;
#endif
  return cellPigment.rgb;
}

void main() {
#ifdef CLIP
  if (dot(clip.xyz, eyePosition) > clip.w) discard;
#endif
#ifdef LIST
  ivec2 at = ivec2(gl_FragCoord.xy);
  uint place = atomicAdd(cursors[(at.y - firstRow) * size.x + at.x], 1u);
#endif
#ifndef COUNT
  vec3 n = normalize(eyeNormal);
  vec3 v = normalize(vec3(0.0, 0.0, eyeDistance) - eyePosition);
  vec3 pigment = pigmentHere();
  vec4 seen;
  if (wireframe == 0) {
    seen = vec4(lit(pigment, n, v), cellPigment.a);
  } else {
    float facing = max(0.0, dot(n, v));
    float lines = wire();
    vec3 fill = mix(paperLight, pigment, 0.16) * (0.82 + 0.18 * facing);
    vec3 ink = pigment * (0.40 + 0.35 * facing);
    seen = vec4(mix(fill, ink, lines), mix(cellPigment.a, 1.0, lines));
  }
#ifdef LIST
  // Light may be a little more than 1, and never reaches 2.
  fragments[place] = uvec4(floatBitsToUint(gl_FragCoord.z), cellOwner, packUnorm2x16(0.5 * seen.rg),
                           packUnorm2x16(vec2(0.5 * seen.b, seen.a)));
#else
  light = seen;
  normal = vec4(n, 0.0);
  height = eyePosition.z;
  owner = cellOwner;
#endif
#endif
#ifdef CUT
  // From the pixel alone, so that cells that overlap have one depth there, to the bit.
  vec2 ray = (2.0 * gl_FragCoord.xy / vec2(size) - 1.0) * aperture;
  float slope = dot(clip.xy, ray);
  float z = (clip.w - slope * eyeDistance) / (clip.z - slope);
  vec3 place = vec3(ray * (eyeDistance - z), z);
  light = vec4(lit(pigment, clip.xyz, v), 1.0);
  normal = vec4(clip.xyz, 0.0);
  height = place.z;
  vec4 shown = projection * vec4(place, 1.0);
  gl_FragDepth = 0.5 + 0.5 * shown.z / shown.w;
#endif
}
)";
}

std::string lineVertexShader() {
  return std::string(version) + common + R"(
layout(location = 0) in vec3 here;
layout(location = 1) in vec3 there;  // the other end
layout(location = 2) in float side;  // -1 or 1
layout(location = 3) in vec3 pigment;
uniform mat4 projection;
uniform float width;  // [sample]
flat out vec3 linePigment;
out vec3 eyeAt;
void main() {
  vec4 a = projection * vec4(here, 1.0), b = projection * vec4(there, 1.0);
  vec2 along = (b.xy / b.w - a.xy / a.w) * vec2(size);
  float reach = length(along);
  vec2 across = reach > 1e-6 ? vec2(-along.y, along.x) / reach : vec2(1.0, 0.0);
  linePigment = pigment;
  eyeAt = here;
  gl_Position = a + vec4(across * side * width / vec2(size) * a.w, 0.0, 0.0);
}
)";
}

std::string lineFragmentShader() {
  return std::string(version) + common + R"(
flat in vec3 linePigment;
in vec3 eyeAt;
uniform vec4 clip;  // as in the cells' shader; 0: nothing is cut away
layout(location = 0) out vec4 light;
layout(location = 1) out uint owner;
layout(location = 2) out vec4 normal;
layout(location = 3) out float height;
void main() {
  if (dot(clip.xyz, eyeAt) > clip.w) discard;
  light = vec4(linePigment, 1.0);
  normal = vec4(0.0, 0.0, 1.0, 0.0);
  height = eyeAt.z;
  owner = lineOwner;
}
)";
}

}  // namespace morula
