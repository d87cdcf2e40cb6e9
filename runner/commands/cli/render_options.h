#pragma once
// The options of `morula render`, read strictly.
#include <string>
#include <vector>

#include "options/options.h"
#include "views/picture_maker.h"

namespace morula::cli {

enum class PictureStyle { solid, wireframe, both, lineage };

struct RenderOptions {
  std::string file, run, beside, output;
  std::string compared;  // the picture that the picture `file` is compared with; "": the file is drawn
  PictureStyle style = PictureStyle::solid;
  std::optional<double> time;
  FigureOptions figure;
  PictureWishes wishes;
  std::vector<std::vector<ForceKind>> forces;
  /// Number of pictures: of one time all around (turntable), or of so many times (frames). At most one is not 0.
  int turntable = 0, frames = 0;
  std::optional<double> perSecond;  // pictures of a film
  InputOptions input;
  ExecutionOptions execution;
  OutputOptions messages;
  bool moves() const { return turntable > 0 || frames > 0; }
};

void add(Verb& verb, RenderOptions& options);

/// Returns the wishes for the picture. Throws UsageError for pictures that take too much memory.
PictureWishes wishesOf(const RenderOptions& options);

/// Throws UsageError if `output` has an unknown ending, or one for films if nothing moves or ffmpeg is missing.
void checkOutput(const RenderOptions& options);

}  // namespace morula::cli

namespace morula {
template <>
inline constexpr auto choices<cli::PictureStyle> = std::to_array<Choice<cli::PictureStyle>>({
    {cli::PictureStyle::solid, "solid", "surfaces"},
    {cli::PictureStyle::wireframe, "wireframe", "edges"},
    {cli::PictureStyle::both, "both", "one beside the other"},
    {cli::PictureStyle::lineage, "lineage", "the tree of cells"},
});
}  // namespace morula
