#pragma once
// What the passes of OrganismRenderer share; for its own files only.
#include <algorithm>
#include <array>
#include <map>
#include <memory>

#include "organism/camera.h"
#include "organism/gl_objects.h"
#include "organism/organism_renderer.h"
#include "organism/shaders.h"
#include "organism/surface.h"

namespace morula {

struct OrganismRenderer::Programs {
  std::map<CellProgram, std::unique_ptr<Program>> cells;  // those that were needed so far
  Program line{lineVertexShader(), lineFragmentShader()};
  Program occlusion{screenVertexShader(), occlusionShader()};
  Program blur{screenVertexShader(), occlusionBlurShader()};
  std::map<int, Program> resolve;          // by samples; those that were needed so far
  std::unique_ptr<Texture> scale;          // of maps
  VertexBuffer screen{nullptr, 0, 0, {}};  // the shader knows its three corners by number
};

/// Everything that is as large as the picture or its sample grid.
struct OrganismRenderer::Targets {
  struct Layer {  // what the cells' shader writes
    Texture lights, owners, depth, normals, heights;
    Framebuffer framebuffer;
    Layer(int w, int h, bool counted)
        : lights(w, h, GL_RGBA32F),
          owners(w, h, GL_R32UI),
          depth(w, h, counted ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F),
          normals(w, h, GL_RGBA32F),
          heights(w, h, GL_R32F),
          framebuffer({&lights, &owners, &normals, &heights}, &depth, counted) {}
  };

  int width, height, samples;
  bool counted;  // surfaces before each sample can be, for a clip plane
  Layer solid;
  std::unique_ptr<Texture> veils;  // light and opacity of translucent cells
  Texture firstVisible, secondVisible, result;
  Framebuffer firstVisibleBuffer, secondVisibleBuffer, resultBuffer;

  Targets(int w, int h, int s, bool clip)
      : width(w),
        height(h),
        samples(s),
        counted(clip),
        solid(w * s, h * s, clip),
        firstVisible(w, h, GL_RG32UI),
        secondVisible(w, h, GL_RG32UI),
        result(w, h, GL_RGBA8),
        firstVisibleBuffer({&firstVisible}, nullptr),
        secondVisibleBuffer({&secondVisible}, nullptr),
        resultBuffer({&result}, nullptr) {}
};

/// One picture while it is drawn.
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
  std::array<float, 4> clip{};  // as the shaders take it; 0: nothing is cut away

  int gridWidth() const { return width * samples; }
  int gridHeight() const { return height * samples; }
  int outlineReach() const { return std::max(1, int(0.5f * pixel + 0.5f)); }  // [sample]

  /// What every shader knows.
  void describe(const Program& program) const {
    program.use();
    program.setSize("size", gridWidth(), gridHeight());
    program.set("aperture", float(aperture.x), float(aperture.y));
    program.set("eyeDistance", float(framing.distance));
    program.set("samples", samples);
    program.setSize("last", width - 1, height - 1);
    program.set("outlineReach", outlineReach());
    program.setMatrix("projection", matrix.data());
    program.set("clip", clip[0], clip[1], clip[2], clip[3]);
  }
};

/// Nothing anywhere: no owner, depths beyond everything. Lights and normals are read only where there is an owner.
void clearLayer(float eyeDistance);

void setPaper(const Program& program);

}  // namespace morula
