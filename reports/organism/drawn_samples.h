#pragma once
// The samples that OpenGL drew, read back, and the passes over the whole picture. Rows go upward, as in OpenGL.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "image/image.h"
#include "organism/camera.h"

namespace morula {

/// The owner of a sample: a cell's number from 1, or one of these values.
inline constexpr std::uint32_t noOwner = 0, lineOwner = 0x80000000u;  // as in cell_shaders.cpp
inline bool isCell(std::uint32_t owner) { return owner != noOwner && owner != lineOwner; }
inline constexpr float outlineShade = 1 - 0.72f;  // the share of its light that a cell keeps at its outline

struct Samples {
  int width = 0, height = 0;  // [pixel] of the picture
  int along = 1;              // samples along a pixel's side
  int outlineReach = 1;       // [sample]
  float eyeDistance = 1, apertureX = 1, apertureY = 1;
  std::vector<std::uint32_t> owners = {};  // one per sample
  std::vector<float> veils = {};           // light and opacity of translucent cells, four numbers a sample; empty: none
  std::vector<std::uint32_t> middles = {};  // one per pixel: the owner of the middle sample
  std::vector<float> heights = {};          // one per pixel: z of the middle sample in eye space
  std::vector<float> visible = {};          // one per pixel: the share of the sky it sees, 0 to 1

  int columns() const { return width * along; }
  int rows() const { return height * along; }
  std::size_t at(int column, int row) const { return std::size_t(row) * columns() + column; }
  std::size_t pixelAt(int x, int y) const { return std::size_t(y) * width + x; }
  int middleOf(int pixel) const { return pixel * along + along / 2; }
  /// Return the slopes x/depth and y/depth of the ray through a place of the sample grid. 0 is the middle of the first
  /// sample; places between middles are allowed.
  float rayX(float column) const { return (2 * (column + 0.5f) / float(columns()) - 1) * apertureX; }
  float rayY(float row) const { return (2 * (row + 0.5f) / float(rows()) - 1) * apertureY; }
};

/// Finds how much of the sky a row's pixels see, from the heights around them up to `radius` [length]; 1 where there is
/// no cell. `normals`: of the middle samples, four numbers each. Each pixel of a 4 × 4 block samples other directions
/// and distances; evenOut() removes the pattern.
void findOcclusion(Samples& samples, float radius, int y, const float* normals);

/// Gives each pixel the mean over those of the 4 × 4 around it that show the same owner.
void evenOut(Samples& samples, int threads);

/// The shell as thin glass: an ellipsoid about the origin.
struct GlassShell {
  Vector semiAxes;  // [length]
  EyeAxes axes;
  Point centre;  // the point that the eye looks at
};

struct Seen {
  float light[3], opacity;  // of one pixel
};

/// Covers a row of pixels with the shell. Glass is almost clear where one looks straight through, and denser towards
/// its rim.
void coverWithGlass(const Samples& samples, const GlassShell& shell, int y, std::vector<Seen>& row);

/// Resolves a row of pixels: outlines, shading, the mean of the samples, the shell if any, and linear light to sRGB.
/// `lights`: of the row's samples, four numbers each. In an image with opacity, pixels without anything drawn are
/// transparent, and the light of a pixel is that of its drawn samples.
void resolve(const Samples& samples, const std::optional<GlassShell>& shell, int y, const float* lights, Image& image);

}  // namespace morula
