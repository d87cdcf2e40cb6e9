// The passes over solid cells and lines; organism_compose.cpp and organism_veils.cpp have the others.
#include "organism/organism_renderer.h"

#include <sys/utsname.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "drawing/palette.h"
#include "organism/gl_context.h"
#include "organism/organism_passes.h"

namespace morula {
namespace {

struct LineVertex {
  float here[3], there[3], side, light[3];
};

/// Adds two triangles that the vertex shader spreads on the screen. At the far end "along" points backward, so the
/// sides swap.
void addRibbon(std::vector<LineVertex>& to, const LineMark& line, const EyeAxes& axes, const Point& centre,
               double headLength) {
  constexpr float headSide = 5;  // [half widths of the line]
  const Vector a = axes.of(line.from - centre), b = axes.of(line.to - centre);
  const auto vertex = [&](const Vector& p, const Vector& q, float side) {
    to.push_back(
        {{float(p.x), float(p.y), float(p.z)},
         {float(q.x), float(q.y), float(q.z)},
         side,
         {float(linearLight(line.colour.r)), float(linearLight(line.colour.g)), float(linearLight(line.colour.b))}});
  };
  vertex(a, b, -1), vertex(b, a, 1), vertex(a, b, 1);
  vertex(a, b, 1), vertex(b, a, 1), vertex(b, a, -1);
  if (!line.arrow) return;
  // The head: a triangle that is at most two fifths of the arrow long.
  const Vector base = b - (b - a) * std::min(0.4, headLength / std::max(norm(b - a), 1e-300));
  vertex(base, b, -headSide), vertex(base, b, headSide), vertex(b, base, 0);
}

/// Returns the range of depths to draw: everything in the picture, and its middle in any case.
std::pair<double, double> clipDepths(const OrganismPicture& picture, const EyeAxes& axes, const Framing& framing) {
  double nearest = framing.distance * 0.9, farthest = framing.distance * 1.1;
  const auto keep = [&](const Point& p) {
    const double depth = framing.distance - axes.of(p - framing.centre).z;
    nearest = std::min(nearest, 0.98 * depth);
    farthest = std::max(farthest, 1.02 * depth);
  };
  for (const CellShape& cell : picture.cells) std::for_each(cell.vertices.begin(), cell.vertices.end(), keep);
  for (const LineMark& line : picture.lines) keep(line.from), keep(line.to);
  return {std::max(nearest, 0.02 * framing.distance), farthest};
}

/// Returns Mesa's version: "3.3 (Core Profile) Mesa 22.3.6" → "22.3.6".
std::string mesaVersion() {
  const OffscreenContext context;
  const auto* text = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  const std::string version = text ? text : "unknown";
  return version.substr(version.rfind(' ') + 1);
}

}  // namespace

void clearLayer(float eyeDistance) {
  const float faraway[4] = {-20 * eyeDistance, 0, 0, 0}, one = 1;
  const GLuint noCell[4] = {0, 0, 0, 0};
  glClearBufferuiv(GL_COLOR, 1, noCell);
  glClearBufferfv(GL_COLOR, 3, faraway);
  glClearBufferfv(GL_DEPTH, 0, &one);
}

OrganismRenderer::OrganismRenderer() : context_(new OffscreenContext), programs_(new Programs) {}
OrganismRenderer::~OrganismRenderer() { context_->makeCurrent(); }

Image OrganismRenderer::draw(const OrganismPicture& picture, Style style, const Framing& framing, int width,
                             int height) {
  context_->makeCurrent();
  const EyeAxes axes = eyeAxes(picture.camera);
  const Aperture aperture = apertureOf(width, height);
  const auto [nearest, farthest] = clipDepths(picture, axes, framing);
  Frame frame{.picture = picture,
              .style = style,
              .axes = axes,
              .framing = framing,
              .width = width,
              .height = height,
              .samples = picture.samples,
              .aperture = aperture,
              .matrix = projection(aperture, framing.distance, nearest, farthest),
              .pixel = float(picture.samples * std::max(1.0, std::min(width, height) / 900.0)),
              .surface = makeSurface(picture, axes, framing, style == Style::wireframe)};
  const VertexBuffer cells(frame.surface.vertices.data(), frame.surface.vertices.size() * sizeof(SurfaceVertex),
                           sizeof(SurfaceVertex),
                           {{3, GL_FLOAT, false, false, offsetof(SurfaceVertex, position)},
                            {3, GL_FLOAT, false, false, offsetof(SurfaceVertex, normal)},
                            {3, GL_FLOAT, false, false, offsetof(SurfaceVertex, corner)},
                            {4, GL_UNSIGNED_SHORT, false, true, offsetof(SurfaceVertex, light)},
                            {1, GL_UNSIGNED_INT, true, false, offsetof(SurfaceVertex, owner)},
                            {1, GL_FLOAT, false, false, offsetof(SurfaceVertex, share)}},
                           frame.surface.corners);
  frame.cells = &cells;
  if (picture.clip) {
    const double length = norm(picture.clip->normal);
    const Vector normal = axes.of(picture.clip->normal / length);
    const double beyond = picture.clip->offset / length - dot(framing.centre, picture.clip->normal / length);
    frame.clip = {float(normal.x), float(normal.y), float(normal.z), float(beyond)};
  }
  if (!targets_ || targets_->read.width != width || targets_->read.height != height ||
      targets_->read.along != picture.samples || targets_->counted != picture.clip.has_value()) {
    targets_.reset();
    // Bytes of Targets' textures and of the samples read back, translucent parts included.
    constexpr double ofSample = 68, ofPixel = 24, ofThreads = 100e6;
    requireMemoryToDraw(double(width) * height * (ofSample * picture.samples * picture.samples + ofPixel) + ofThreads,
                        "; draw a smaller picture, with less --supersample, or on a machine with more memory");
    targets_ = std::make_unique<Targets>(width, height, picture.samples, picture.clip.has_value());
  }
  drawSolid(frame);
  if (picture.clip) drawCuts(frame);
  drawLines(frame);
  Samples& samples = readSamples(frame);
  drawVeils(frame, samples.veils);
  return compose(frame);
}

const Program& OrganismRenderer::cellProgram(const Frame& frame, CellPass pass) {
  const CellProgram kind{pass, frame.picture.clip.has_value(), frame.surface.mapped};
  auto& program = programs_->cells[kind];
  if (!program) program = std::make_unique<Program>(cellVertexShader(kind.mapped), cellFragmentShader(kind));
  frame.describe(*program);
  program->set("wireframe", frame.style == Style::wireframe ? 1 : 0);
  program->set("wireWidth", 1.0f * frame.pixel);
  program->set("paperLight", float(linearLight(paper.r)), float(linearLight(paper.g)), float(linearLight(paper.b)));
  if (!kind.mapped) return *program;
  if (!programs_->scale) {
    std::vector<float> colours;
    for (int i = 0; i < scaleSteps; ++i) {
      const Colour c = scaleColour(double(i) / (scaleSteps - 1));
      for (const double light : {linearLight(c.r), linearLight(c.g), linearLight(c.b), 1.0})
        colours.push_back(float(light));
    }
    programs_->scale = std::make_unique<Texture>(scaleSteps, 1, GL_RGBA32F);
    programs_->scale->setRows(0, 1, colours.data());
  }
  program->set("scale", *programs_->scale, 0);
  return *program;
}

void OrganismRenderer::drawSolid(const Frame& frame) {
  targets_->solid.framebuffer.bind();
  glViewport(0, 0, frame.gridWidth(), frame.gridHeight());
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  clearLayer(float(frame.framing.distance));
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  if (frame.picture.clip) glDisable(GL_CULL_FACE);  // insides of cut cells are visible, where drawCuts draws the cut
  else glEnable(GL_CULL_FACE);
  cellProgram(frame, CellPass::whole);
  if (frame.surface.solid > 0) frame.cells->drawTriangles(0, frame.surface.solid);
}

void OrganismRenderer::drawCuts(const Frame& frame) {
  const ClipPlane& clip = *frame.picture.clip;
  struct Cut {
    const CellCorners* corners;
    double size;
  };
  std::vector<Cut> cuts;
  for (const CellCorners& corners : frame.surface.cells) {
    if (corners.first >= frame.surface.solid) continue;
    double low = INFINITY, high = -INFINITY;
    for (const Point& p : frame.picture.cells[corners.cell].vertices) {
      low = std::min(low, dot(p, clip.normal));
      high = std::max(high, dot(p, clip.normal));
    }
    const double bulge = 0.2 * (high - low);  // faces bend outwards between their vertices
    if (low - bulge < clip.offset && high + bulge > clip.offset) cuts.push_back({&corners, high - low});
  }
  // The smaller of two cells that overlap is drawn last, so that a cell within a cell is seen.
  std::stable_sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.size > b.size; });
  const Program &cell = cellProgram(frame, CellPass::whole), &cut = cellProgram(frame, CellPass::cut);
  const GLint zero = 0;
  glClearBufferiv(GL_STENCIL, 0, &zero);
  glEnable(GL_STENCIL_TEST);
  // A ray that meets the plane inside a cell leaves the cell once more often than it enters, behind the plane.
  const auto count = [&](const Cut& what, GLenum front, GLenum back) {
    cell.use();
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glStencilFunc(GL_ALWAYS, 0, 0xff);
    glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, front);
    glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, back);
    frame.cells->drawTriangles(what.corners->first, what.corners->count);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  };
  for (const Cut& what : cuts) {
    count(what, GL_DECR_WRAP, GL_INCR_WRAP);
    cut.use();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);  // the inner sides cover the cut's pixels
    glStencilFunc(GL_EQUAL, 1, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    frame.cells->drawTriangles(what.corners->first, what.corners->count);
    count(what, GL_INCR_WRAP, GL_DECR_WRAP);
  }
  glDisable(GL_STENCIL_TEST);
  glCullFace(GL_BACK);
  glDepthFunc(GL_LESS);
  glEnable(GL_DEPTH_TEST);
}

void OrganismRenderer::drawLines(const Frame& frame) {
  if (frame.picture.lines.empty()) return;
  std::vector<LineVertex> vertices;
  std::size_t hidden = 0;  // number of vertices of lines that cells hide
  const double length = 9 * frame.pixel * 2 * frame.aperture.y * frame.framing.distance / frame.gridHeight();
  for (const bool through : {false, true}) {
    for (const LineMark& line : frame.picture.lines)
      if (line.throughCells == through) addRibbon(vertices, line, frame.axes, frame.framing.centre, length);
    if (!through) hidden = vertices.size();
  }
  const VertexBuffer buffer(vertices.data(), vertices.size() * sizeof(LineVertex), sizeof(LineVertex),
                            {{3, GL_FLOAT, false, false, offsetof(LineVertex, here)},
                             {3, GL_FLOAT, false, false, offsetof(LineVertex, there)},
                             {1, GL_FLOAT, false, false, offsetof(LineVertex, side)},
                             {3, GL_FLOAT, false, false, offsetof(LineVertex, light)}});
  frame.describe(programs_->line);
  programs_->line.set("width", 1.3f * frame.pixel);
  glDisable(GL_CULL_FACE);
  if (hidden > 0) buffer.drawTriangles(0, hidden);
  glDepthFunc(GL_ALWAYS);
  if (hidden < vertices.size()) buffer.drawTriangles(hidden, vertices.size() - hidden);
  glDepthFunc(GL_LESS);
}

std::string rendererName() {
  utsname machine{};
  const std::string kind = uname(&machine) == 0 ? machine.machine : "unknown";
  return "mesa-" + mesaVersion() + '/' + kind;
}

}  // namespace morula
