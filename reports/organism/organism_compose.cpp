// The last pass of OrganismRenderer: everything together.
#include "organism/organism_passes.h"

namespace morula {
namespace {

/// How the shader gets from eye space to the world in units of the shell's semi-axes, and with normals of
/// that unit sphere back, whose inverse transpose has the same factors.
void setShell(const Program& program, const Vector& wall, const EyeAxes& axes, const Point& centre) {
  const Vector rows[3] = {axes.x, axes.y, axes.z};
  const double semi[3] = {wall.x, wall.y, wall.z};
  const double middle[3] = {centre.x, centre.y, centre.z};
  float toShell[16] = {}, fromNormal[16] = {};
  for (int eye = 0; eye < 3; ++eye) {
    const double parts[3] = {rows[eye].x, rows[eye].y, rows[eye].z};
    for (int world = 0; world < 3; ++world) {
      toShell[4 * eye + world] = float(parts[world] / semi[world]);
      fromNormal[4 * world + eye] = float(parts[world] / semi[world]);
    }
  }
  for (int world = 0; world < 3; ++world) toShell[12 + world] = float(middle[world] / semi[world]);
  toShell[15] = fromNormal[15] = 1;
  program.setMatrix("toShell", toShell);
  program.setMatrix("fromNormal", fromNormal);
}

/// The pixels of the framebuffer in use.
Image readBack(int width, int height, bool transparent) {
  std::vector<std::uint8_t> rgba(std::size_t(4) * width * height);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  Image image(width, height, paper);
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* row = &rgba[std::size_t(4) * width * (height - 1 - y)];  // OpenGL counts upward
    for (int x = 0; x < width; ++x) image.at(x, y) = {row[4 * x], row[4 * x + 1], row[4 * x + 2]};
    for (int x = 0; transparent && x < width; ++x) image.opacity.push_back(row[4 * x + 3]);
  }
  return image;
}

}  // namespace

Image OrganismRenderer::resolve(const Frame& frame, bool veiled) {
  const Program& program =
      programs_->resolve.try_emplace(frame.samples, screenVertexShader(), resolveShader(frame.samples)).first->second;
  frame.describe(program);
  setPaper(program);
  if (frame.picture.transparent) program.set("paperLight", 0, 0, 0);
  program.set("groundless", frame.picture.transparent ? 1 : 0);
  program.set("veiled", veiled ? 1 : 0);
  program.set("shelled", frame.picture.shell ? 1 : 0);
  program.set("lights", targets_->solid.lights, 0);
  program.set("heights", targets_->solid.heights, 1);
  program.set("owners", targets_->solid.owners, 2);
  program.set("visibles", targets_->firstVisible, 3);
  if (veiled) program.set("veils", *targets_->veils, 4);
  if (frame.picture.shell) setShell(program, *frame.picture.shell * shellThickness, frame.axes, frame.framing.centre);
  fillScreen(targets_->resultBuffer, frame.width, frame.height);
  return readBack(frame.width, frame.height, frame.picture.transparent);
}

}  // namespace morula
