#include "render/organism_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "render/camera.h"
#include "render/gl_objects.h"
#include "render/shaders.h"
#include "render/surface.h"

namespace morula {
namespace {

constexpr int maxLayers = 16;  // of translucent surfaces, one behind the other

struct LineVertex {
  float here[3], there[3], side, light[3];
};

/// Two triangles that the vertex shader spreads apart on the screen. At the far end "along" points backward,
/// so the sides swap.
void addRibbon(std::vector<LineVertex>& to, const LineMark& line, const EyeAxes& axes, const Point& centre) {
  const Vector a = axes.of(line.from - centre), b = axes.of(line.to - centre);
  const auto vertex = [&](const Vector& p, const Vector& q, float side) {
    to.push_back({{float(p.x), float(p.y), float(p.z)},
                  {float(q.x), float(q.y), float(q.z)},
                  side,
                  {float(linearLight(line.colour.r)), float(linearLight(line.colour.g)),
                   float(linearLight(line.colour.b))}});
  };
  vertex(a, b, -1), vertex(b, a, 1), vertex(a, b, 1);
  vertex(a, b, 1), vertex(b, a, 1), vertex(b, a, -1);
}

/// The mean distance of a vertex from its cell's middle: how far shadows between cells should reach.
double meanCellSize(const OrganismPicture& picture) {
  double sum = 0;
  std::size_t count = 0;
  for (const CellShape& cell : picture.cells) {
    Point middle;
    for (const Point& p : cell.vertices) middle += p / double(cell.vertices.size());
    for (const Point& p : cell.vertices) sum += norm(p - middle), ++count;
  }
  return count ? sum / double(count) : 1;
}

/// The directions in which the occlusion shader looks: steps of the golden angle, and sixteen turns of them.
void setSpiral(const Program& program) {
  constexpr int taps = 14;  // as in the shader
  float spiral[2 * taps], turns[2 * 16];
  for (int i = 0; i < taps; ++i)
    spiral[2 * i] = float(std::cos(2.399963 * i)), spiral[2 * i + 1] = float(std::sin(2.399963 * i));
  for (int i = 0; i < 16; ++i) {
    const double turn = 6.283185 * (i + 0.5) / 16;
    turns[2 * i] = float(std::cos(turn)), turns[2 * i + 1] = float(std::sin(turn));
  }
  program.setPairs("spiral", spiral, taps);
  program.setPairs("turns", turns, 16);
}

void setPaper(const Program& program) {
  program.set("paperLight", float(linearLight(paper.r)), float(linearLight(paper.g)),
              float(linearLight(paper.b)));
}

}  // namespace

struct OrganismRenderer::Programs {
  Program cell{cellVertexShader(), cellFragmentShader(false)};
  Program peel{cellVertexShader(), cellFragmentShader(true)};
  Program line{lineVertexShader(), lineFragmentShader()};
  Program occlusion{screenVertexShader(), occlusionShader()};
  Program blur{screenVertexShader(), occlusionBlurShader()};
  Program layer{screenVertexShader(), layerShader()};
  Program resolve{screenVertexShader(), resolveShader()};
  VertexBuffer screen{nullptr, 0, 0, {}};  // the shader knows its three corners by number
};

/// Everything that is as large as the picture or its sample grid.
struct OrganismRenderer::Targets {
  struct Layer {  // what the cells' shader writes; a veil needs no shapes, as it gets no ambient occlusion
    Texture lights, owners, depth;
    std::unique_ptr<Texture> shapes;
    Framebuffer framebuffer;
    Layer(int w, int h, bool shaped)
        : lights(w, h, GL_RGBA32F),
          owners(w, h, GL_R32UI),
          depth(w, h, GL_DEPTH_COMPONENT32F),
          shapes(shaped ? std::make_unique<Texture>(w, h, GL_RGBA32F) : nullptr),
          framebuffer({&lights, &owners, shapes.get()}, &depth) {}
  };
  struct Veils {  // only with translucent cells
    Layer first, second;
    Texture sum;
    Framebuffer framebuffer;
    Veils(int w, int h)
        : first(w, h, false), second(w, h, false), sum(w, h, GL_RGBA32F), framebuffer({&sum}, nullptr) {}
  };

  int width, height, samples;
  Layer solid;
  std::unique_ptr<Veils> veils;
  Texture firstVisible, secondVisible, result;
  Framebuffer firstVisibleBuffer, secondVisibleBuffer, resultBuffer;

  Targets(int w, int h, int s)
      : width(w),
        height(h),
        samples(s),
        solid(w * s, h * s, true),
        firstVisible(w, h, GL_R32F),
        secondVisible(w, h, GL_R32F),
        result(w, h, GL_RGBA8),
        firstVisibleBuffer({&firstVisible}, nullptr),
        secondVisibleBuffer({&secondVisible}, nullptr),
        resultBuffer({&result}, nullptr) {}
};

struct OrganismRenderer::Frame {
  const OrganismPicture& picture;
  Style style;
  EyeAxes axes;
  Framing framing;
  int width, height, samples;
  Aperture aperture;
  std::array<float, 16> matrix;
  float pixel;  // [sample] the unit of line widths: a pixel of a 900-pixel picture
  Surface surface;
  const VertexBuffer* cells = nullptr;

  int gridWidth() const { return width * samples; }
  int gridHeight() const { return height * samples; }

  /// What every shader knows.
  void describe(const Program& program) const {
    program.use();
    program.setSize("size", gridWidth(), gridHeight());
    program.set("aperture", float(aperture.x), float(aperture.y));
    program.set("eyeDistance", float(framing.distance));
    program.set("samples", samples);
    program.set("outlineReach", std::max(1, int(std::lround(0.5f * pixel))));
    program.setMatrix("projection", matrix.data());
  }
};

OrganismRenderer::OrganismRenderer() : context_(new OffscreenContext), programs_(new Programs) {}

OrganismRenderer::~OrganismRenderer() { context_->makeCurrent(); }

Image OrganismRenderer::draw(const OrganismPicture& picture, Style style, const Framing& framing, int width,
                             int height) {
  context_->makeCurrent();
  const EyeAxes axes = eyeAxes(picture.camera);
  const Aperture aperture = apertureOf(width, height);
  double nearest = framing.distance * 0.9, farthest = framing.distance * 1.1;
  const auto keep = [&](const Point& p) {
    const double depth = framing.distance - axes.of(p - framing.centre).z;
    nearest = std::min(nearest, 0.98 * depth);
    farthest = std::max(farthest, 1.02 * depth);
  };
  for (const CellShape& cell : picture.cells) std::for_each(cell.vertices.begin(), cell.vertices.end(), keep);
  for (const LineMark& line : picture.lines) keep(line.from), keep(line.to);
  nearest = std::max(nearest, 0.02 * framing.distance);

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
              .surface = makeSurface(picture, axes, framing)};
  const VertexBuffer cells(frame.surface.vertices.data(),
                           frame.surface.vertices.size() * sizeof(SurfaceVertex), sizeof(SurfaceVertex),
                           {{3, GL_FLOAT, false, false, offsetof(SurfaceVertex, position)},
                            {3, GL_FLOAT, false, false, offsetof(SurfaceVertex, normal)},
                            {3, GL_FLOAT, false, false, offsetof(SurfaceVertex, corner)},
                            {4, GL_UNSIGNED_SHORT, false, true, offsetof(SurfaceVertex, light)},
                            {1, GL_UNSIGNED_INT, true, false, offsetof(SurfaceVertex, owner)}},
                           frame.surface.corners);
  frame.cells = &cells;
  if (!targets_ || targets_->width != width || targets_->height != height ||
      targets_->samples != picture.samples) {
    targets_.reset();
    targets_ = std::make_unique<Targets>(width, height, picture.samples);
  }
  drawSolid(frame);
  drawLines(frame);
  findOcclusion(frame);
  const bool veiled = drawVeils(frame);
  return resolve(frame, veiled);
}

namespace {

void clearLayer(float eyeDistance) {
  const float none[4] = {0, 0, 0, 0}, faraway[4] = {0, 0, 0, -20 * eyeDistance}, one = 1;
  const GLuint nobody[4] = {0, 0, 0, 0};
  glClearBufferfv(GL_COLOR, 0, none);
  glClearBufferuiv(GL_COLOR, 1, nobody);
  glClearBufferfv(GL_COLOR, 2, faraway);
  glClearBufferfv(GL_DEPTH, 0, &one);
}

}  // namespace

void OrganismRenderer::fillScreen(const Framebuffer& target, int width, int height) {
  target.bind();
  glViewport(0, 0, width, height);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  programs_->screen.drawTriangles(0, 3);
}

void OrganismRenderer::drawSolid(const Frame& frame) {
  targets_->solid.framebuffer.bind();
  glViewport(0, 0, frame.gridWidth(), frame.gridHeight());
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  clearLayer(float(frame.framing.distance));
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glEnable(GL_CULL_FACE);
  for (const Program* program : {&programs_->peel, &programs_->cell}) {
    frame.describe(*program);
    program->set("wireframe", frame.style == Style::wireframe ? 1 : 0);
    program->set("wireWidth", 1.0f * frame.pixel);
    setPaper(*program);
  }
  if (frame.surface.solid > 0) frame.cells->drawTriangles(0, frame.surface.solid);
}

void OrganismRenderer::drawLines(const Frame& frame) {
  if (frame.picture.lines.empty()) return;
  std::vector<LineVertex> vertices;
  std::size_t hidden = 0;  // vertices of lines that cells hide
  for (const bool through : {false, true}) {
    for (const LineMark& line : frame.picture.lines)
      if (line.throughCells == through) addRibbon(vertices, line, frame.axes, frame.framing.centre);
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

void OrganismRenderer::findOcclusion(const Frame& frame) {
  frame.describe(programs_->occlusion);
  // As far as a cell is large, but not so far that the taps would lie too thin in the picture.
  const double radius =
      std::min(0.8 * meanCellSize(frame.picture), 0.25 * frame.framing.distance * frame.aperture.y);
  programs_->occlusion.set("radius", float(radius));
  setSpiral(programs_->occlusion);
  programs_->occlusion.set("shapes", 0);
  programs_->occlusion.set("owners", 1);
  targets_->solid.shapes->bind(0);
  targets_->solid.owners.bind(1);
  fillScreen(targets_->firstVisibleBuffer, frame.width, frame.height);
  // Twice: along an edge the first pass lacks half of the pattern that it should even out.
  frame.describe(programs_->blur);
  programs_->blur.set("raw", 0);
  programs_->blur.set("owners", 1);
  targets_->firstVisible.bind(0);
  fillScreen(targets_->secondVisibleBuffer, frame.width, frame.height);
  targets_->secondVisible.bind(0);
  fillScreen(targets_->firstVisibleBuffer, frame.width, frame.height);
}

bool OrganismRenderer::drawVeils(const Frame& frame) {
  const std::size_t count = frame.surface.corners.size() - frame.surface.solid;
  if (count == 0) return false;
  // Depth peeling [Everitt 2001]: each turn draws the nearest surfaces behind those of the last turn, so
  // whatever the cells' order and however they interpenetrate, each sample meets its surfaces from front to
  // back.
  if (!targets_->veils)
    targets_->veils = std::make_unique<Targets::Veils>(frame.gridWidth(), frame.gridHeight());
  Targets::Veils& veils = *targets_->veils;
  const float none[4] = {0, 0, 0, 0}, zero = 0;
  veils.framebuffer.bind();
  glClearBufferfv(GL_COLOR, 0, none);
  veils.second.framebuffer.bind();
  glClearBufferfv(GL_DEPTH, 0, &zero);  // the first layer lies behind nothing
  GLuint query = 0;
  glGenQueries(1, &query);
  for (int turn = 0; turn < maxLayers; ++turn) {
    const Targets::Layer &here = turn % 2 ? veils.second : veils.first,
                         &last = turn % 2 ? veils.first : veils.second;
    here.framebuffer.bind();
    glViewport(0, 0, frame.gridWidth(), frame.gridHeight());
    clearLayer(float(frame.framing.distance));
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    programs_->peel.use();
    programs_->peel.set("opaqueDepth", 0);
    programs_->peel.set("lastDepth", 1);
    targets_->solid.depth.bind(0);
    last.depth.bind(1);
    glBeginQuery(GL_SAMPLES_PASSED, query);
    frame.cells->drawTriangles(frame.surface.solid, count);
    glEndQuery(GL_SAMPLES_PASSED);
    GLuint passed = 0;
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &passed);
    if (passed == 0) break;
    frame.describe(programs_->layer);
    programs_->layer.set("lights", 0);
    programs_->layer.set("owners", 1);
    here.lights.bind(0);
    here.owners.bind(1);
    glEnable(GL_BLEND);  // under: only what the layers before let through
    glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    fillScreen(veils.framebuffer, frame.gridWidth(), frame.gridHeight());
    glDisable(GL_BLEND);
  }
  glDeleteQueries(1, &query);
  return true;
}

Image OrganismRenderer::resolve(const Frame& frame, bool veiled) {
  const Program& program = programs_->resolve;
  frame.describe(program);
  setPaper(program);
  program.set("lights", 0);
  program.set("shapes", 1);
  program.set("owners", 2);
  program.set("visibles", 3);
  program.set("veils", 4);
  program.set("veiled", veiled ? 1 : 0);
  program.set("shelled", frame.picture.shell ? 1 : 0);
  targets_->solid.lights.bind(0);
  targets_->solid.shapes->bind(1);
  targets_->solid.owners.bind(2);
  targets_->firstVisible.bind(3);
  if (veiled) targets_->veils->sum.bind(4);
  if (frame.picture.shell) {
    // From eye space to the world and into units of the semi-axes, and for normals the way back (whose
    // inverse transpose has the same factors).
    const Vector rows[3] = {frame.axes.x, frame.axes.y, frame.axes.z};
    const Vector wall = *frame.picture.shell * shellThickness;
    const double semi[3] = {wall.x, wall.y, wall.z};
    const Point& centre = frame.framing.centre;
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
  fillScreen(targets_->resultBuffer, frame.width, frame.height);

  std::vector<std::uint8_t> rgba(std::size_t(4) * frame.width * frame.height);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, frame.width, frame.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  Image image(frame.width, frame.height, paper);
  for (int y = 0; y < frame.height; ++y) {
    const std::uint8_t* row =
        &rgba[std::size_t(4) * frame.width * (frame.height - 1 - y)];  // OpenGL counts upward
    for (int x = 0; x < frame.width; ++x) image.at(x, y) = {row[4 * x], row[4 * x + 1], row[4 * x + 2]};
  }
  return image;
}

}  // namespace morula
