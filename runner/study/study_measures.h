#pragma once
// The measures that a study may take: all rows of the tables of measures, by names that belong to one row each.
#include <optional>
#include <string>
#include <vector>

#include "simulation/measures.h"

namespace morula {

struct Scenario;

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

/// By its name in a study; '-' may stand for '_'. Null if there is none.
const StudyMeasure* findStudyMeasure(std::string text);

/// What the scenario lacks for the measure: "bodies (physics)"; "" if it has all.
std::string missingFor(const StudyMeasure& measure, const Scenario& scenario);

}  // namespace morula
