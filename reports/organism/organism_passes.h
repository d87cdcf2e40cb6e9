#pragma once
// What the passes of OrganismRenderer share; for its own files only.
#include <algorithm>
#include <array>
#include <memory>

#include "organism/camera.h"
#include "organism/gl_objects.h"
#include "organism/organism_renderer.h"
#include "organism/shaders.h"
#include "organism/surface.h"

namespace morula {

struct OrganismRenderer::Programs {
  Program cell{cellVertexShader(), cellFragmentShader(CellPass::whole)};
  Program peel{cellVertexShader(), cellFragmentShader(CellPass::peel)};
  struct Clipped {  // made for the first picture with a clip plane
    Program cell{cellVertexShader(), cellFragmentShader(CellPass::clipped)};
    Program peel{cellVertexShader(), cellFragmentShader(CellPass::clippedPeel)};
    Program cut{cellVertexShader(), cellFragmentShader(CellPass::cut)};
  };
  std::unique_ptr<Clipped> clipped;
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
    Layer(int w, int h, bool shaped, bool counted = false)
        : lights(w, h, GL_RGBA32F),
          owners(w, h, GL_R32UI),
          depth(w, h, counted ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F),
          shapes(shaped ? std::make_unique<Texture>(w, h, GL_RGBA32F) : nullptr),
          framebuffer({&lights, &owners, shapes.get()}, &depth, counted) {}
  };
  struct Veils {  // only with translucent cells
    Layer first, second;
    Texture sum;
    Framebuffer framebuffer;
    Veils(int w, int h)
        : first(w, h, false), second(w, h, false), sum(w, h, GL_RGBA32F), framebuffer({&sum}, nullptr) {}
  };

  int width, height, samples;
  bool counted;  // surfaces before each sample can be, for a clip plane
  Layer solid;
  std::unique_ptr<Veils> veils;
  Texture firstVisible, secondVisible, result;
  Framebuffer firstVisibleBuffer, secondVisibleBuffer, resultBuffer;

  Targets(int w, int h, int s, bool clip)
      : width(w),
        height(h),
        samples(s),
        counted(clip),
        solid(w * s, h * s, true, clip),
        firstVisible(w, h, GL_R32F),
        secondVisible(w, h, GL_R32F),
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
  std::array<float, 4> clip{};                     // as the shaders take it; 0: nothing is cut away
  const Program *cell = nullptr, *peel = nullptr;  // of the cells

  int gridWidth() const { return width * samples; }
  int gridHeight() const { return height * samples; }

  /// What every shader knows.
  void describe(const Program& program) const {
    program.use();
    program.setSize("size", gridWidth(), gridHeight());
    program.set("aperture", float(aperture.x), float(aperture.y));
    program.set("eyeDistance", float(framing.distance));
    program.set("samples", samples);
    program.set("outlineReach", std::max(1, int(0.5f * pixel + 0.5f)));
    program.setMatrix("projection", matrix.data());
    program.set("clip", clip[0], clip[1], clip[2], clip[3]);
  }
};

/// Nothing anywhere: no light, no owner, depths beyond everything.
void clearLayer(float eyeDistance);

void setPaper(const Program& program);

}  // namespace morula
