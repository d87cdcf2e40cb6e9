#pragma once
// Merged databases of studies that were never run, for tests that know what is in them.
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
  /// The values at the end of the run of these levels and this seed. None: there was nothing to measure.
  std::function<Values(const std::vector<int>& levels, int seed)> values;
  /// Whether seeds change nothing for these levels. Absent: they always do.
  std::function<bool(const std::vector<int>& levels)> seedless = {};
  /// "failed", "missing" or "".
  std::function<std::string(const std::vector<int>& levels, int seed)> trouble = {};
  std::function<int(const std::vector<int>& levels)> cells =
      {};                           // alive at the end, of a failed run half as many. Absent: not known
  std::vector<double> times = {1};  // at all but the last the value is the time's share of that at the end
  /// Further levels that mean the same as others: levels → those whose runs they share. Absent: none.
  std::function<std::vector<int>(const std::vector<int>& levels)> sameAs = {};
};

void writeStudy(const MadeStudy& study, const std::filesystem::path& file);

}  // namespace morula
