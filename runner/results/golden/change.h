#pragma once
// The difference of two results in words: the changed keys and their effects.
#include <string>
#include <vector>

#include "golden/golden.h"

namespace morula {

struct KeyChange {
  std::string key;            // "physics.pressure.constant"
  std::string before, after;  // "not given" for a key that only the other result has
};

/// Returns the parameters that decide results and differ, in the order of the file; none if one of the two results
/// records no parameters.
std::vector<KeyChange> changedKeys(const GoldenData& before, const GoldenData& after);

/// Returns lines for people, each indented by two blanks; "" if there are no differences. They tell the changed keys,
/// the differences of the lineage, and for cells that both have at the end the largest movement [radii of the egg].
/// Then follow changes of volume and pressure [per cent]: the organism's, and the largest of a cell.
std::string changeInWords(const GoldenData& before, const GoldenData& after);

/// A line of changeInWords: a heading of up to eight letters, or none for a further line of the last, and a text.
struct ChangeLine {
  std::string heading, text;
};
std::vector<ChangeLine> linesOfChange(const std::string& change);

/// Returns a change in one sentence without a full stop: "physics.pressure.constant: 155 → 155.5; same lineage; …". Of
/// several lines under one heading it holds the first and the number of the others.
std::string changeSentence(const std::string& change);

}  // namespace morula
