// The passes of OrganismRenderer that read back OpenGL's samples and compose the picture.
#include <algorithm>
#include <type_traits>

#include "base/parallel.h"
#include "organism/organism_passes.h"
#include "organism/shell_wall.h"

namespace morula {
namespace {

/// Returns how far shadows between cells reach: 0.8 of the mean distance of a vertex from its cell's middle, at most
/// `maxInPicture`.
double occlusionRadius(const OrganismPicture& picture, double maxInPicture) {
  return std::min(0.8 * meanRadius(picture, picture.cells.size()), maxInPicture);
}

/// Calls body(y, samples) for each row of pixels with its samples of a colour attachment of the solid layer, `numbers`
/// per sample. Rows are read in strips that fit the cache.
template <class Number, class Body>
void eachRow(const Samples& samples, GLenum attachment, GLenum format, int numbers, Body&& body) {
  const std::size_t ofRow = std::size_t(numbers) * samples.columns() * samples.along;
  const int rowsAtOnce = int(std::clamp<std::size_t>((1 << 20) / ofRow, 1, samples.height));
  std::vector<Number> texels(ofRow * rowsAtOnce);
  const GLenum type = std::is_same_v<Number, float> ? GL_FLOAT : GL_UNSIGNED_INT;
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadBuffer(attachment);
  for (int first = 0; first < samples.height; first += rowsAtOnce) {
    const int rows = std::min(rowsAtOnce, samples.height - first);
    glReadPixels(0, first * samples.along, samples.columns(), rows * samples.along, format, type, texels.data());
    parallelFor(rows, threadsToDraw(), [&](int row) { body(first + row, &texels[ofRow * row]); });
  }
  glReadBuffer(GL_COLOR_ATTACHMENT0);
}

}  // namespace

Samples& OrganismRenderer::readSamples(const Frame& frame) {
  Samples& samples = targets_->read;
  samples.outlineReach = frame.outlineReach(), samples.eyeDistance = float(frame.framing.distance);
  samples.apertureX = float(frame.aperture.x), samples.apertureY = float(frame.aperture.y);
  const std::size_t pixels = std::size_t(frame.width) * frame.height;
  samples.owners.resize(pixels * samples.along * samples.along);
  samples.middles.resize(pixels), samples.heights.resize(pixels), samples.visible.resize(pixels), samples.veils.clear();
  const auto middle = [&](int x) { return samples.at(samples.middleOf(x), samples.along / 2); };  // in a row of pixels
  targets_->solid.framebuffer.bind();
  eachRow<std::uint32_t>(samples, GL_COLOR_ATTACHMENT1, GL_RED_INTEGER, 1, [&](int y, const std::uint32_t* owners) {
    std::copy_n(owners, samples.at(0, samples.along), &samples.owners[samples.at(0, y * samples.along)]);
    for (int x = 0; x < frame.width; ++x) samples.middles[samples.pixelAt(x, y)] = owners[middle(x)];
  });
  eachRow<float>(samples, GL_COLOR_ATTACHMENT3, GL_RED, 1, [&](int y, const float* heights) {
    for (int x = 0; x < frame.width; ++x) samples.heights[samples.pixelAt(x, y)] = heights[middle(x)];
  });
  return samples;
}

std::vector<std::uint32_t> OrganismRenderer::owners() const {
  const Samples& samples = targets_->read;
  std::vector<std::uint32_t> owners;
  for (int y = samples.height - 1; y >= 0; --y)
    for (int x = 0; x < samples.width; ++x) {
      const std::uint32_t owner = samples.middles[samples.pixelAt(x, y)];
      owners.push_back(isCell(owner) ? owner : noOwner);
    }
  return owners;
}

Image OrganismRenderer::compose(const Frame& frame) {
  Samples& samples = targets_->read;
  const float radius = float(occlusionRadius(frame.picture, 0.4 * frame.framing.distance * frame.aperture.y));
  targets_->solid.framebuffer.bind();
  eachRow<float>(samples, GL_COLOR_ATTACHMENT2, GL_RGBA, 4, [&](int y, const float* normals) {
    findOcclusion(samples, radius, y, normals + 4 * samples.at(0, samples.along / 2));
  });
  // Two passes, because along an edge the first one covers only half of the pattern.
  for (int pass = 0; pass < 2; ++pass) evenOut(samples, threadsToDraw());
  std::optional<GlassShell> shell;
  if (frame.picture.shell) shell = {*frame.picture.shell * shellThickness, frame.axes, frame.framing.centre};
  Image image(frame.width, frame.height, paper);
  if (frame.picture.transparent) image.opacity.resize(image.pixels.size());
  eachRow<float>(samples, GL_COLOR_ATTACHMENT0, GL_RGBA, 4,
                 [&](int y, const float* lights) { resolve(samples, shell, y, lights, image); });
  return image;
}

}  // namespace morula
