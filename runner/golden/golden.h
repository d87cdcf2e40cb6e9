#pragma once
// Accepted results: one text file golden/<family>/<name>.golden per scenario scenarios/<family>/<name>.yaml.
// The format is described in golden/README.md.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "golden/check_result.h"
#include "golden/item.h"
#include "golden/tolerance.h"

namespace morula {

/// What a run showed, in canonical order (makeGoldenData), or what a golden file says that it should show.
struct GoldenData {
  std::string scenario;      // "thesis/unique-four"
  std::string scenarioHash;  // semantic: formatting and key order do not count
  std::uint64_t seed = 0;
  std::vector<GoldenItem> items;
};

struct Golden {
  GoldenData data;
  std::string acceptedBy;  // who
  std::string why;         // the reason for the last acceptance
  std::vector<ToleranceRule> rules;
  std::string file;  // where it was read from
};

/// The file's text. The same golden gives the same bytes.
std::string writeGolden(const Golden& golden);

/// Reads a golden file's text. Throws InputError "file:line: …" for a line that it does not understand, a
/// truncated file, merge markers, items twice, edited items (the last line holds their digest), a tolerance
/// without a reason.
Golden readGolden(const std::string& text, const std::string& file);
/// The same from a file; InputError also if there is none, FileError if it cannot be read.
Golden readGoldenFile(const std::filesystem::path& file);

/// Holds what was observed against the golden. One result per check: scenario, completeness, tolerances,
/// counts, lineage, time_steps, bits, step_hashes, and values by tolerance rule.
CheckReport compareGolden(const Golden& golden, const GoldenData& observed);

}  // namespace morula
