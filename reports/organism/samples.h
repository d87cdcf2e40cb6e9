#pragma once
// The samples that OpenGL drew, read back, and the passes over the whole picture. Rows go upward, as OpenGL counts
// them.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "image/image.h"
#include "organism/camera.h"

namespace morula {

/// The owner of a sample: the cell that it shows, by its number from 1, or one of these.
inline constexpr std::uint32_t noOwner = 0, lineOwner = 0x80000000u;  // as in cell_shaders.cpp
inline bool isCell(std::uint32_t owner) { return owner != noOwner && owner != lineOwner; }
inline constexpr float outlineShade = 1 - 0.72f;  // what a cell keeps of its light where its outline runs

struct Samples {
  int width = 0, height = 0;  // of the picture [pixel]
  int along = 1;              // samples along a pixel's side
  int outlineReach = 1;       // [sample]
  float eyeDistance = 1, apertureX = 1, apertureY = 1;
  std::vector<std::uint32_t> owners = {};  // of samples
  std::vector<float> veils = {};           // light and opacity of translucent cells, four numbers a sample; empty: none
  std::vector<std::uint32_t> middles = {};  // of pixels: the owner of the middle sample,
  std::vector<float> heights = {};          // its z in eye space,
  std::vector<float> visible = {};          // and how much of the sky it sees, 0 to 1

  int columns() const { return width * along; }
  int rows() const { return height * along; }
  std::size_t at(int column, int row) const { return std::size_t(row) * columns() + column; }
  std::size_t pixelAt(int x, int y) const { return std::size_t(y) * width + x; }
  int middleOf(int pixel) const { return pixel * along + along / 2; }
  /// The direction in which the eye sees a place between the middles of the first sample, 0, and the last one, for each
  /// length towards the picture.
  float rayX(float column) const { return (2 * (column + 0.5f) / float(columns()) - 1) * apertureX; }
  float rayY(float row) const { return (2 * (row + 0.5f) / float(rows()) - 1) * apertureY; }
};

/// How much of the sky a row's pixels see, from the heights around them up to `radius` [length]; 1 where there is no
/// cell. `normals`: of the samples in the middle of the row of pixels, four numbers each. Each pixel of a 4 × 4 block
/// looks in other directions and at other distances; evenOut() takes the pattern out again.
void findOcclusion(Samples& samples, float radius, int y, const float* normals);

/// Gives each pixel the mean of the 4 × 4 around it that show the same.
void evenOut(Samples& samples, int threads);

/// The shell as thin glass: an ellipsoid about the origin.
struct GlassShell {
  Vector semiAxes;  // [length]
  EyeAxes axes;
  Point centre;  // at which the eye looks
};

struct Seen {
  float light[3], opacity;  // of a pixel
};

/// A row of pixels, seen through the shell. Nearly nothing is lost where one looks straight through it, more towards
/// its rim.
void coverWithGlass(const Samples& samples, const GlassShell& shell, int y, std::vector<Seen>& row);

/// Outlines, shading, the mean of the samples, the shell if there is one, linear light to sRGB: a row of pixels.
/// `lights`: of its samples, row by row, four numbers each. Of an image with opacity what nothing is drawn on is
/// transparent, and light that of what is drawn alone.
void resolve(const Samples& samples, const std::optional<GlassShell>& shell, int y, const float* lights, Image& image);

}  // namespace morula
