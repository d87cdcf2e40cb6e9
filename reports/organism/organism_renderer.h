#pragma once
// The passes that make an organism's picture, with everything that stays on the graphics side from one
// picture to the next. One per thread.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "organism/organism.h"
#include "organism/shaders.h"

namespace morula {

/// The shell's wall is drawn outside of it, up to so many times its semi-axes: cells that touch it stay whole.
inline constexpr double shellThickness = 1.02;

class OrganismRenderer {
 public:
  OrganismRenderer();
  ~OrganismRenderer();
  OrganismRenderer(const OrganismRenderer&) = delete;
  OrganismRenderer& operator=(const OrganismRenderer&) = delete;

  /// The scene alone, without words, width × height pixels. The input is checked already.
  Image draw(const OrganismPicture& picture, Style style, const Framing& framing, int width, int height);

  /// The solid cell that each pixel's middle shows in the picture drawn last, row by row from the top: its number from
  /// 1; 0: none.
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
  /// Light and opacity of translucent cells, four numbers a sample; nothing where there are none.
  void drawVeils(const Frame& frame, std::vector<float>& seen);
  Image compose(const Frame& frame);

  std::unique_ptr<class OffscreenContext> context_;
  std::unique_ptr<Programs> programs_;
  std::unique_ptr<Targets> targets_;
};

/// The renderer of organisms, "mesa-22.3.6/x86_64", as one word: only pictures of one renderer, without words, are the
/// same to the pixel.
std::string rendererName();

}  // namespace morula
