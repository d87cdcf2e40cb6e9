#pragma once
// Merged databases of studies that were never run, with known contents.
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace morula {

using Values = std::map<std::string, double>;  // by measure

struct MadeStudy {
  struct MadeAxis {
    std::string name;
    std::vector<std::string> labels;
  };
  std::vector<MadeAxis> axes;
  int seeds = 10;
  /// Returns the values at the end of the run of these levels and this seed; empty if there is nothing to measure.
  std::function<Values(const std::vector<int>& levels, int seed)> values;
  /// Returns true if seeds change nothing for these levels. Absent: seeds always matter.
  std::function<bool(const std::vector<int>& levels)> seedless = {};
  /// Returns "failed", "missing" or "".
  std::function<std::string(const std::vector<int>& levels, int seed)> trouble = {};
  std::function<int(const std::vector<int>& levels)> cells =
      {};                           // number alive at the end, half as many in a failed run. Absent: unknown
  std::vector<double> times = {1};  // at all but the last, a value is the time's share of the last value
  /// Returns the levels whose runs these levels share because they mean the same. Absent: none.
  std::function<std::vector<int>(const std::vector<int>& levels)> sameAs = {};
};

void writeStudy(const MadeStudy& study, const std::filesystem::path& file);

}  // namespace morula
