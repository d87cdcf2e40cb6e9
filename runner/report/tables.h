#pragma once
// Stored results as texts for other programs: CSV [RFC 4180] and the tree in Newick's format. Numbers are the shortest texts
// that read back as the same bits.
#include <string>

#include "report/run_facts.h"

namespace morula {

std::string cellsCsv(const RunResults& results);
/// These two are "" without samples.
std::string samplesCsv(const RunResults& results);
std::string cellSamplesCsv(const RunResults& results);

/// Labels are names, or paths where there are none; a branch is as long as its cell has lived, up to `end` [time].
std::string newick(const RunResults& results, double end);

/// JSON with line breaks, for people; as it is if it cannot be read.
std::string indented(const std::string& json);

/// The scenario file that the run was read from, as it was given.
std::string sourceOf(const RunFacts& run);

}  // namespace morula
