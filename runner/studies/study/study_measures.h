#pragma once
// The measures that a study may take: all rows of the tables of measures, by names that belong to one row each.
#include <string>
#include <vector>

#include "simulation/measures.h"

namespace morula {

struct StudyMeasure {
  /// As results call it: "sphericity"; where rows of two tables have one name, with its scope: "cell.volume".
  std::string name;
  std::string row;   // in its table
  std::string unit;  // "length³"; "": a pure number
  Scope scope;
  Needs needs;
  bool onDemand;  // taken by takeMeasures; otherwise a column of samples
};

/// World, cell, pair; each in the order of its table.
const std::vector<StudyMeasure>& studyMeasures();

/// By its name in a study; '-' may stand for '_', and a scope may stand before any name. Null if there is none, or if rows
/// of two tables have that name.
const StudyMeasure* findStudyMeasure(std::string text);

}  // namespace morula
