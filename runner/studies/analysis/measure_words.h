#pragma once
// Words for measures in plain sentences.
#include <cstddef>
#include <string>

#include "values/units.h"

namespace morula {

struct MeasureWords {
  std::string noun;        // "clone radius"
  std::string more, less;  // "wider", "tighter": for larger and for smaller values
  /// Value from which the measure varies. Shares and percentages are of the distance from there: 0.94 and 0.97 of a
  /// measure whose zero is 1 differ by half.
  double zero = 0;
  std::string scale = {};  // "1 − sphericity", in words; "" if zero is 0
};

/// Returns the words for a measure as results call it: "clone_radius", "cell.volume". A measure without words of its
/// own has its name, "higher" and "lower".
MeasureWords wordsOfMeasure(const std::string& measure);

/// Returns "length³"; "" for a pure number, and for a measure of no table.
std::string unitOfMeasure(const std::string& measure);

/// Returns the measure's definition in one line; "" for a count, a distance, a ratio or a difference.
std::string meaningOfMeasure(const std::string& measure);

/// Returns "Mean pressure [force/length²]" for "mean_pressure", a title for charts and tables.
std::string titleOfMeasure(const std::string& measure, const Units& units = {});

/// Returns the measure's place in the tables of measures (world, cell, pair); unknown measures come last.
std::size_t placeOfMeasure(const std::string& measure);

}  // namespace morula
