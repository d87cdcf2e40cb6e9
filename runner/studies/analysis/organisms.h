#pragma once
// The organisms of a study's conditions at some moments, as one picture.
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/study_results.h"
#include "drawing/drawing.h"

namespace morula {

/// When organisms are looked at: one of the three.
struct GridMoments {
  std::size_t count = 5;           // evenly from the start to the end of the longest run; 1: the end of each
  std::vector<double> times;       // [time] rising
  std::vector<std::size_t> cells;  // rising: when so many cells first live
};

/// A row a condition and a column a moment, from runs with the same seed: the first that the most conditions have a
/// finished run with. Of the end alone (count 1) the levels of the last axis stand beside each other, where there are more
/// axes. Shapes are not stored, so each of these runs is computed again, with one thread; equal ones once. A run that has no such
/// moment shows its end in place of the first one that it does not reach, and then nothing. Throws UsageError if the
/// runs have no bodies or are too many for a picture, NondeterminismError if a run does not come to the state that the
/// study has of it, Interrupted if a signal comes.
Drawing drawOrganisms(const StudyResults& results, const std::filesystem::path& study,
                      const GridMoments& moments, bool quiet);

/// Why drawOrganisms refuses these conditions and moments; "" if they fit into one picture.
std::string whyTooMany(const StudyResults& results, const GridMoments& moments);

}  // namespace morula
