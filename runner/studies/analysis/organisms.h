#pragma once
// The organisms of a study's conditions at some moments, as one picture.
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/study_results.h"
#include "drawing/drawing.h"
#include "values/units.h"
#include "views/picture_maker.h"

namespace morula {

/// The moments at which organisms are drawn, by one of the three fields, and the meaning of their colours.
struct GridMoments {
  std::size_t count = 5;           // moments from the start to the longest run's end; 1: the end of each run
  std::vector<double> times;       // [time] rising
  std::vector<std::size_t> cells;  // rising numbers of cells; the moments at which so many first live
  Colouring colouring{};
  Camera camera{};
  bool hasView = false;  // the camera is another than the usual one
  Labels labels = Labels::none;
  FigureSize figure{};
  /// Returns true if the pictures that a study keeps look as is wished.
  bool isUsual() const {
    return colouring.by == Colouring::By::substance && !hasView && labels == Labels::none && figure.width == 0;
  }
};

/// Draws a row for each condition and a column for each moment, from runs with one seed: the first with which the most
/// conditions have a finished run. For the end alone (count 1) the levels of the last of several axes are columns. If
/// the study keeps pictures of all these ends, in equal shells and so at one scale, they are used. Otherwise each
/// distinct run is computed again, with one thread. A run that does not reach a moment shows its end instead, and then
/// nothing. Throws UsageError if runs have no bodies or are too many for a picture; NondeterminismError if a run does
/// not reach its stored state; Interrupted if a signal comes.
std::vector<Drawing> drawOrganisms(const StudyResults& results, const std::filesystem::path& study,
                                   const GridMoments& moments, bool quiet);

/// Returns why drawOrganisms refuses these conditions and moments; "" if it does not.
std::string whyTooMany(const StudyResults& results, const GridMoments& moments);

/// Returns the units in which people see the study's lengths and times: those of its scenarios, or the scenes' own if
/// scenarios differ or no run has finished. `study`: the merged database.
Units unitsOf(const StudyResults& results, const std::filesystem::path& study);

struct StoredPictures {
  std::size_t seed = 0;  // the seed's number in the study
  /// Pictures of the ends of the conditions, in their order; conditions that share a run share a picture.
  std::vector<std::filesystem::path> files = {};
};
/// Returns the pictures of the first seed of which all conditions have one; absent without such a seed.
std::optional<StoredPictures> storedPictures(const StudyResults& results, const std::filesystem::path& study);

}  // namespace morula
