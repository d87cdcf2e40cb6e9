#pragma once
// How one result differs from another, in words: what was changed, and what became of it.
#include <string>
#include <vector>

#include "golden/golden.h"

namespace morula {

struct KeyChange {
  std::string key;            // "physics.pressure.constant"
  std::string before, after;  // "not given" where only the other has it
};

/// Returns the parameters that decide results and differ, in the order of the file. Empty if one of the two records
/// none.
std::vector<KeyChange> changedKeys(const GoldenData& before, const GoldenData& after);

/// Lines for people, each with two blanks before it: the changed keys, what differs in the lineage, and of
/// the cells that both have at the end how far the farthest moved [radii of the egg], and the changes of volume and
/// pressure [per cent]: the organism's, and the largest of a cell. "" where none of it differs.
std::string changeInWords(const GoldenData& before, const GoldenData& after);

/// Its lines: a heading of up to eight letters and a text. A line without a heading belongs to the one above it.
struct ChangeLine {
  std::string heading, text;
};
std::vector<ChangeLine> linesOfChange(const std::string& change);

/// Tells a change in one sentence without a full stop: "physics.pressure.constant: 155 → 155.5; same lineage; …".
/// Several lines under one heading become the first of them and the number of the others.
std::string changeSentence(const std::string& change);

}  // namespace morula
