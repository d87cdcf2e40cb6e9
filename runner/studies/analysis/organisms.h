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
#include "views/cell_colours.h"

namespace morula {

/// When organisms are looked at: one of the three; and what their colours tell.
struct GridMoments {
  std::size_t count = 5;           // evenly from the start to the end of the longest run; 1: the end of each
  std::vector<double> times;       // [time] rising
  std::vector<std::size_t> cells;  // rising: when so many cells first live
  Colouring colouring{};
};

/// A row a condition and a column a moment, from runs with the same seed: the first that the most conditions have a
/// finished run with. Of the end alone (count 1) the levels of the last axis stand beside each other, where there are
/// more axes. Where the study keeps pictures of all of these ends, in equal shells and so at one scale, they are taken;
/// otherwise each of these runs is computed again, with one thread; equal ones once. A run that has no such moment
/// shows its end in place of the first one that it does not reach, and then nothing. Throws UsageError if the runs have
/// no bodies or are too many for a picture, NondeterminismError if a run does not come to the state that the study has
/// of it, Interrupted if a signal comes.
std::vector<Drawing> drawOrganisms(const StudyResults& results, const std::filesystem::path& study,
                                   const GridMoments& moments, bool quiet);

/// Why drawOrganisms refuses these conditions and moments; "" if it does not.
std::string whyTooMany(const StudyResults& results, const GridMoments& moments);

/// The units in which people see the study's lengths and times: those of its scenarios, or the scenes' own where
/// scenarios differ or no run has finished. `study`: the merged database.
Units unitsOf(const StudyResults& results, const std::filesystem::path& study);

struct StoredPictures {
  std::size_t seed = 0;  // its number in the study
  /// Pictures of the ends of the conditions, in their order; conditions that share a run share a picture.
  std::vector<std::filesystem::path> files = {};
};
/// Returns the pictures of the first seed of which all conditions have one; absent without such a seed.
std::optional<StoredPictures> storedPictures(const StudyResults& results, const std::filesystem::path& study);

}  // namespace morula
