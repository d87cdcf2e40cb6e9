#pragma once
// The passes that draw an organism, with the OpenGL objects that stay from one picture to the next. Each thread has its
// own renderer.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "organism/organism.h"
#include "organism/shaders.h"

namespace morula {

class OrganismRenderer {
 public:
  OrganismRenderer();
  ~OrganismRenderer();
  OrganismRenderer(const OrganismRenderer&) = delete;
  OrganismRenderer& operator=(const OrganismRenderer&) = delete;

  /// Draws the scene without words, width × height pixels. The input must be checked already.
  Image draw(const OrganismPicture& picture, Style style, const Framing& framing, int width, int height);

  /// Returns the solid cell at the middle of each pixel of the last picture, row by row from the top, as its number
  /// from 1; 0: none.
  std::vector<std::uint32_t> owners() const;

 private:
  struct Programs;
  struct Targets;
  struct Frame;
  /// Returns the program for this pass over the cells, in use and with the frame's values set.
  const class Program& cellProgram(const Frame& frame, CellPass pass);
  void drawSolid(const Frame& frame);
  void drawCuts(const Frame& frame);
  void drawLines(const Frame& frame);
  struct Samples& readSamples(const Frame& frame);
  /// Fills `seen` with light and opacity of translucent cells, four numbers a sample; leaves it empty without such
  /// cells.
  void drawVeils(const Frame& frame, std::vector<float>& seen);
  Image compose(const Frame& frame);

  std::unique_ptr<class OffscreenContext> context_;
  std::unique_ptr<Programs> programs_;
  std::unique_ptr<Targets> targets_;
};

/// Returns the renderer's name in one word, "mesa-22.3.6/x86_64". Only pictures of one renderer, without words, have
/// equal pixels.
std::string rendererName();

}  // namespace morula
