#pragma once
// What `morula render` is asked for, read strictly.
#include <string>
#include <vector>

#include "options/options.h"
#include "pictures/picture_maker.h"

namespace morula::cli {

struct RenderOptions {
  std::string file, run, time, style = "solid", view, size = "900", supersample = "2", colour = "substance",
                               clip, labels;
  std::string turntable, frames, perSecond, beside, output;
  std::vector<std::string> opacity, forces;
  bool transparent = false, normals = false, connections = false, axes = false, scaleBar = false;
  InputOptions input;
  ExecutionOptions execution;
  OutputOptions messages;
};

void add(class Verb& verb, RenderOptions& options);

struct PictureSize {
  int width, height;  // [pixel] 64 to 8192
};
/// "900": a square; "1920x1080". Throws UsageError.
PictureSize sizeOption(const RenderOptions& options);

/// Throws UsageError for an option that says nothing of a lineage tree.
void checkTreeOptions(const RenderOptions& options);

/// Throws UsageError that names the option for what cannot be.
PictureWishes wishesOf(const RenderOptions& options);

/// How many pictures are asked for: of one time all around (turntable), or of so many times (frames). 0: not asked
/// for; not both. Throws UsageError.
struct Motion {
  int turntable = 0, frames = 0;
  double perSecond = 25;
  bool any() const { return turntable > 0 || frames > 0; }
};
Motion motionOf(const RenderOptions& options);

/// Throws UsageError unless `output` has an ending that can be written: films only of what moves, and where ffmpeg is.
void checkOutput(const RenderOptions& options, const Motion& motion);

}  // namespace morula::cli
