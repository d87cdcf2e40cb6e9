#pragma once
// Types that the passes of OrganismRenderer share; for its own files only.
#include <algorithm>
#include <array>
#include <map>
#include <memory>

#include "organism/camera.h"
#include "organism/drawn_samples.h"
#include "organism/gl_objects.h"
#include "organism/organism_renderer.h"
#include "organism/shaders.h"
#include "organism/surface.h"

namespace morula {

struct OrganismRenderer::Programs {
  std::map<CellProgram, std::unique_ptr<Program>> cells;  // compiled when first needed
  Program line{lineVertexShader(), lineFragmentShader()};
  std::unique_ptr<Texture> scale;  // the colours of maps
};

/// All textures and buffers whose size depends on the picture.
struct OrganismRenderer::Targets {
  struct Layer {  // the outputs of the cells' shader
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

  bool counted;  // has a stencil that counts surfaces, for a clip plane
  Layer solid;
  Samples read;
  Targets(int w, int h, int s, bool clip)
      : counted(clip), solid(w * s, h * s, clip), read{.width = w, .height = h, .along = s} {}
};

/// The state of one picture while it is drawn.
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
  std::array<float, 4> clip{};  // in eye space, as the shaders take it; 0: nothing is cut away

  int gridWidth() const { return width * samples; }
  int gridHeight() const { return height * samples; }
  int outlineReach() const { return std::max(1, int(0.5f * pixel + 0.5f)); }  // [sample]

  /// Sets the uniforms that every shader has.
  void describe(const Program& program) const {
    program.use();
    program.setSize("size", gridWidth(), gridHeight());
    program.set("aperture", float(aperture.x), float(aperture.y));
    program.set("eyeDistance", float(framing.distance));
    program.setMatrix("projection", matrix.data());
    program.set("clip", clip[0], clip[1], clip[2], clip[3]);
  }
};

/// Clears the layer: no owner, depths beyond everything. Lights and normals need no clearing, for they are read only
/// where there is an owner.
void clearLayer(float eyeDistance);
}  // namespace morula
