#pragma once
// How measures are spoken of in plain sentences.
#include <cstddef>
#include <string>

#include "values/units.h"

namespace morula {

struct MeasureWords {
  std::string noun;        // "clone radius"
  std::string more, less;  // "wider", "tighter": with larger and with smaller values
};

/// Returns the words for a measure as results call it: "clone_radius", "cell.volume". Without words of its own: its
/// name, higher, lower.
MeasureWords wordsOfMeasure(const std::string& measure);

/// "length³"; "" for a pure number and for what no table of measures has.
std::string unitOfMeasure(const std::string& measure);

/// "Mean pressure [force/length²]" of "mean_pressure": for charts and tables.
std::string titleOfMeasure(const std::string& measure, const Units& units = {});

/// The row's place in the tables of measures (world, cell, pair); behind all of them for what none has.
std::size_t placeOfMeasure(const std::string& measure);

}  // namespace morula
