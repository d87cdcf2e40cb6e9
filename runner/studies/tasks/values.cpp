#include "tasks/values.h"

#include "base/error.h"
#include "store/sample_values.h"

namespace morula {

std::vector<ResultRow> valuesOf(const std::vector<Sample>& samples, const std::map<StateId, std::string>& states,
                                const std::vector<std::string>& measures) {
  std::vector<ResultRow> rows;
  for (const std::string& name : measures) {
    const std::optional<AskedMeasure> measure = findMeasure(name);
    MORULA_CHECK(measure, "a study's measures are known");
    for (const Sample& sample : samples) {
      const auto values = valuesIn(sample, *measure, states);
      double sum = 0;  // in the order of paths, so that the last bit is the same everywhere
      for (const auto& [thing, value] : values) sum += value;
      if (!values.empty()) rows.push_back({measure->name, sample.world.time, sum / static_cast<double>(values.size())});
    }
  }
  return rows;
}

}  // namespace morula
