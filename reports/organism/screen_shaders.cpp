// What runs over the whole picture.
#include "organism/shader_parts.h"
#include "organism/shaders.h"

namespace morula {
using namespace shader;

std::string screenVertexShader() {
  return std::string(version) + R"(
void main() {  // one triangle that covers the picture
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";
}

// Scalable ambient obscurance [McGuire, Mara, Luebke 2012]: points nearby that rise above the tangent plane
// take light away, more the nearer they are; beyond `radius` none.
std::string occlusionShader() {
  return std::string(version) + common + R"(
uniform sampler2D normals, heights;
uniform usampler2D owners;
uniform int samples;
uniform float radius;
uniform vec2 spiral[18];  // directions of the taps
uniform vec2 turns[16];   // cosine and sine of each pixel's turn
layout(location = 0) out uvec4 visible;  // bits of a float; the owner of the pixel's middle
const int taps = 18;
const int spread[16] = int[16](0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5);  // [Bayer 1973]
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 at = pixel * samples + samples / 2;
  uint own = texelFetch(owners, at, 0).r;
  int wanted = own == 0u || own == lineOwner ? 0 : taps;  // as in outlineShade
  vec3 normal = texelFetch(normals, at, 0).xyz;
  vec3 p = eyePoint(vec2(at), texelFetch(heights, at, 0).r);
  float reach = 0.5 * float(size.y) * radius / ((eyeDistance - p.z) * aperture.y);  // [sample]
  // Each pixel of a 4 x 4 block looks in other directions and at other distances; the blur takes the pattern out again.
  int place = spread[(pixel.y & 3) * 4 + (pixel.x & 3)];
  vec2 turn = turns[place];
  float sum = 0.0;
  for (int i = 0; i < wanted; ++i) {
    float share = (float(i) + (float(place) + 0.5) / 16.0) / float(taps);
    vec2 way = vec2(spiral[i].x * turn.x - spiral[i].y * turn.y, spiral[i].x * turn.y + spiral[i].y * turn.x);
    ivec2 there = at + ivec2(round(reach * share * way));
    there = clamp(there, ivec2(0), size - 1);
    vec3 to = eyePoint(vec2(there), texelFetch(heights, there, 0).r) - p;
    float gap = max(0.0, 1.0 - dot(to, to) / (radius * radius));
    sum += gap * gap * gap * max(0.0, dot(to, normal) - 0.02 * radius) / (dot(to, to) + 0.0004 * radius * radius);
  }
  visible = uvec4(floatBitsToUint(max(0.0, 1.0 - 2.2 * radius * sum / float(taps))), own, 0u, 0u);
}
)";
}

std::string occlusionBlurShader() {
  return std::string(version) + common + R"(
uniform usampler2D raw;
uniform ivec2 last;  // pixel
layout(location = 0) out uvec4 visible;
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint own = texelFetch(raw, pixel, 0).g;
  float sum = 0.0, weight = 0.0;
  for (int dy = -2; dy < 2; ++dy)
    for (int dx = -2; dx < 2; ++dx) {
      uvec2 there = texelFetch(raw, clamp(pixel + ivec2(dx, dy), ivec2(0), last), 0).rg;
      sum += there.g == own ? uintBitsToFloat(there.r) : 0.0;
      weight += there.g == own ? 1.0 : 0.0;
    }
  visible = uvec4(floatBitsToUint(sum / weight), own, 0u, 0u);
}
)";
}

std::string resolveShader(int samples) {
  return std::string(version) + "const int samples = " + std::to_string(samples) + ";\n" + common + R"(
uniform sampler2D lights, heights, veils;
uniform usampler2D owners, visibles;  // of samples; of pixels (occlusionShader)
uniform int outlineReach;             // in samples
uniform ivec2 last;                   // pixel
uniform int veiled, shelled;
uniform int groundless;  // what nothing is drawn on is transparent; light is then that of what is drawn alone
uniform vec3 paperLight;
uniform mat4 toShell;     // eye space to the space in which the shell is the unit sphere
uniform mat4 fromNormal;  // a normal of that sphere to eye space
layout(location = 0) out vec4 pixel;

// The pixel's own, or for a sample whose cell is not that of the pixel's middle, the mean of the neighbours on this side
// of the edge.
float occlusion(ivec2 home, uint own, uint homeOwner, float homeVisible) {
  float sum = 0.0, weight = 0.0;
  int turns = own == homeOwner || own == 0u ? 0 : 9;
  for (int i = 0; i < turns; ++i) {
    uvec2 there = texelFetch(visibles, clamp(home + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last), 0).rg;
    sum += there.g == own ? uintBitsToFloat(there.r) : 0.0;
    weight += there.g == own ? 1.0 : 0.0;
  }
  return own == homeOwner ? homeVisible : weight > 0.0 ? sum / weight : 0.7;
}

// True if the corners of the pixel's surroundings belong to one cell: no outline can run here, and nearly all pixels
// are spared the search for one.
bool plain(ivec2 corner, uint own) {
  ivec2 low = max(corner - outlineReach, ivec2(0)), high = min(corner + samples - 1 + outlineReach, size - 1);
  return texelFetch(owners, low, 0).r == own && texelFetch(owners, high, 0).r == own &&
         texelFetch(owners, ivec2(low.x, high.y), 0).r == own && texelFetch(owners, ivec2(high.x, low.y), 0).r == own;
}

// Dark lines where one cell ends and another thing begins, as a draughtsman would set them: 1 inside, less at an edge.
// llvmpipe runs both sides of an `if`, but leaves a loop at once when no pixel wants a turn: hence the number of them.
const ivec2 around[4] = ivec2[4](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1));
float outlineShade(ivec2 at, uint own, bool wanted) {
  float edges = 0.0;
  int turns = wanted && own != 0u && own != lineOwner ? 4 : 0;
  for (int i = 0; i < turns; ++i) {
    ivec2 there = clamp(at + outlineReach * around[i], ivec2(0), size - 1);
    uint other = texelFetch(owners, there, 0).r;
    if (other != own && other != lineOwner) edges = 1.0;
  }
  return 1.0 - 0.72 * edges;
}

// A thin glass shell: nearly nothing where one looks straight through it, more towards its rim. Once per pixel; its
// edge is softened by how fast the discriminant changes from pixel to pixel.
vec4 withShell(vec4 before, vec2 at) {
  vec3 behind = before.rgb;
  vec3 eye = (toShell * vec4(0.0, 0.0, eyeDistance, 1.0)).xyz;
  vec3 toPoint = eyePoint(at, 0.0) - vec3(0.0, 0.0, eyeDistance);
  vec3 ray = (toShell * vec4(toPoint, 0.0)).xyz;
  float a = dot(ray, ray), b = dot(eye, ray), c = dot(eye, eye) - 1.0;
  float d = b * b - a * c;
  float edge = clamp(0.5 + d / max(1e-12, length(vec2(dFdx(d), dFdy(d)))), 0.0, 1.0);
  float t = (-b - sqrt(max(d, 0.0))) / a;
  float cell = texelFetch(heights, ivec2(at), 0).r;
  vec3 seen = (toShell * vec4(eyePoint(at, cell), 1.0)).xyz;
  bool outside = dot(seen, seen) > 1.02 && cell > eyeDistance * (1.0 - t);  // a cell that has broken out
  if (edge == 0.0 || t <= 0.0 || outside) return before;
  vec3 n = normalize((fromNormal * vec4(eye + t * ray, 0.0)).xyz);
  vec3 v = -normalize(toPoint);
  float slant = 1.0 - max(0.0, dot(n, v));
  float s2 = slant * slant;
  float cover = 0.02 + 0.12 * s2 + 0.46 * s2 * s2 * s2;
  vec3 glass = mix(vec3(0.66, 0.74, 0.82), vec3(0.30, 0.38, 0.47), s2);
  float shine = max(0.0, dot(n, normalize(normalize(vec3(-0.55, 0.75, 0.70)) + v)));
  shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine;
  return vec4(mix(behind, mix(behind, glass, cover) + 0.14 * shine, edge),
              mix(before.a, min(1.0, mix(before.a, 1.0, cover) + 0.14 * shine), edge));
}

void main() {
  ivec2 home = ivec2(gl_FragCoord.xy), corner = home * samples;
  uvec2 middle = texelFetch(visibles, home, 0).rg;
  uint homeOwner = middle.g;
  float homeVisible = uintBitsToFloat(middle.r);
  bool amidst = plain(corner, homeOwner), alike = amidst && veiled == 0;
  // Nearly all pixels belong to one cell, or to none, and are done after this.
  float homeShade = homeOwner != 0u && homeOwner != lineOwner ? homeVisible : 1.0;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < samples * samples; ++i) {
    ivec2 at = corner + ivec2(i % samples, i / samples);
    alike = alike && texelFetch(owners, at, 0).r == homeOwner;
    vec3 light = homeOwner != 0u ? texelFetch(lights, at, 0).rgb : paperLight;
    sum += min(light * homeShade, vec3(1.0));
  }
  sum = alike ? sum : vec3(0.0);
  float covered = alike && homeOwner != 0u ? float(samples * samples) : 0.0;
  int turns = alike ? 0 : samples * samples;
  for (int i = 0; i < turns; ++i) {
    ivec2 at = corner + ivec2(i % samples, i / samples);
    uint own = texelFetch(owners, at, 0).r;
    vec3 light = own != 0u ? texelFetch(lights, at, 0).rgb : paperLight;
    bool cell = own != 0u && own != lineOwner;
    float shade = occlusion(home, own, homeOwner, homeVisible) * outlineShade(at, own, !amidst || own != homeOwner);
    light *= cell ? shade : 1.0;
    if (veiled != 0) {
      vec4 veil = texelFetch(veils, at, 0);
      light = veil.rgb + (1.0 - veil.a) * light;
      covered += own == 0u ? veil.a : 0.0;
    }
    covered += own != 0u ? 1.0 : 0.0;
    sum += min(light, vec3(1.0));
  }
  vec3 mean = sum / float(samples * samples);
  float opacity = covered / float(samples * samples);
  if (shelled != 0) {
    vec4 seen = withShell(vec4(mean, opacity), vec2(corner) + 0.5 * float(samples - 1));
    mean = min(seen.rgb, vec3(1.0));
    opacity = seen.a;
  }
  if (groundless != 0) mean = min(mean / max(opacity, 1e-6), vec3(1.0));
  vec3 encoded = mix(12.92 * mean, 1.055 * pow(mean, vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), mean));
  pixel = vec4(encoded, groundless != 0 ? opacity : 1.0);
}
)";
}

}  // namespace morula
