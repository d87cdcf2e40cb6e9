#pragma once
// Accepted results: one text file golden/<family>/<name>.golden per scenario scenarios/<family>/<name>.yaml.
// The format is described in golden/README.md.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/hash.h"
#include "golden/check_result.h"
#include "golden/item.h"
#include "golden/tolerance.h"

namespace morula {

/// A line `statistic`: the mean of a measure at the end under the scenario's settings minus the mean under other
/// settings. The means are over runs with small disturbances of the start, for scenes in which chaos leaves only
/// distributions to be compared.
struct GoldenStatistic {
  std::string measure;       // [observation/measures.h]
  std::string against;       // the label of the other settings: "half-step"
  double difference = 0;     // [the measure's unit]
  double low = 0, high = 0;  // its 95 % interval
  std::uint64_t runs = 0;    // runs under each of the two settings
  bool onePath = false;      // true: disturbed runs stay one path, so there is no interval; its ends are the difference

  friend bool operator==(const GoldenStatistic&, const GoldenStatistic&) = default;
};

/// Returns "statistic clone_radius against half-step difference -0.0012 low -0.0041 high 0.0017 runs 8", or for one path
/// "statistic clone_radius against half-step difference -0.0012 one-path runs 8".
std::string write(const GoldenStatistic& statistic);

/// Reads a line `statistic`. Returns null for any other line, and for an interval whose ends are not in order.
std::optional<GoldenStatistic> readStatistic(std::string_view line);

void add(Hasher& hasher, const GoldenStatistic& statistic);

/// The result of a run in canonical order (makeGoldenData), or the result that a golden file asks for.
struct GoldenData {
  std::string scenario;      // "thesis/unique-four"
  std::string scenarioHash;  // semantic: formatting and key order do not count
  std::uint64_t seed = 0;
  std::vector<GoldenItem> items;
  // Keys and values that decided the result (scenario/deciding_values.h); empty if not recorded
  std::vector<std::pair<std::string, std::string>> parameters = {};
};

/// Returns the items of one kind, in their order.
template <class Item>
std::vector<const Item*> all(const std::vector<GoldenItem>& of) {
  std::vector<const Item*> items;
  for (const GoldenItem& item : of)
    if (const auto* one = std::get_if<Item>(&item)) items.push_back(one);
  return items;
}
template <class Item>
std::vector<const Item*> all(const GoldenData& data) {
  return all<Item>(data.items);
}

/// The growth of a disturbance of one unit in the last place of one coordinate at the start: the step by which it has
/// grown to `size`, in radii of the egg.
struct GoldenGrowth {
  double size = 0;  // powers of ten
  std::uint64_t step = 0;
};

/// Version of the format. Version 1 holds no recorded tables.
inline constexpr int goldenVersion = 2;

struct Golden {
  GoldenData data;
  std::string acceptedBy;  // name of the person who accepted it
  std::string why;         // the reason for the last acceptance
  std::vector<ToleranceRule> rules;
  std::string file = {};                         // the path it was read from
  std::vector<GoldenGrowth> growth = {};         // by size; empty: not measured
  std::vector<GoldenItem> stated = {};           // errors, and why there are none; empty: not measured
  std::vector<GoldenStatistic> statistics = {};  // of values at the end; empty: not measured
  int version = goldenVersion;                   // format of the file
};

/// Returns the chaos horizon: the step up to which a tolerance of this size means something. Beyond it a difference in
/// the last place alone uses the tolerance up. Absent if the tolerance means something for the whole run.
std::optional<std::uint64_t> horizonOf(const Golden& golden, double size);
/// Returns the max growth of one unit in the last place by this step; 0 if it was not measured.
double grownBy(const Golden& golden, std::uint64_t step);

/// Returns the file's text. The same golden gives the same bytes.
std::string writeGolden(const Golden& golden);

/// Reads a golden file's text. Throws InputError "file:line: …" for an unknown line, a truncated file, merge markers,
/// items twice, edited items (the last line holds their digest), or a tolerance without a reason.
Golden readGolden(const std::string& text, const std::string& file);
/// Reads a golden file. Throws InputError also if the file is missing, FileError if it cannot be read.
Golden readGoldenFile(const std::filesystem::path& file);

/// Returns the hash of the accepted end state; "" if the golden holds none.
std::string acceptedBits(const Golden& golden);

/// Compares a run's data with the golden. Returns one result per check: scenario, completeness, tolerances, counts,
/// lineage, time_steps, bits, step_hashes, values by tolerance rule, and recorded tables.
CheckReport compareGolden(const Golden& golden, const GoldenData& observed);
/// Returns the report of a golden that belongs to no scenario, or is unusable for the reason given (edited, cut off,
/// with merge markers): one failed check "golden" of class INPUT_CHANGED.
CheckReport unusableGolden(const std::string& scenario, const std::string& why);

}  // namespace morula
