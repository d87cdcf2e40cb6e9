#include "tasks/values.h"

#include "base/error.h"
#include "study/study_measures.h"

namespace morula {

namespace {

/// Added up in the order of paths, so that the last bit is the same everywhere.
class Mean {
 public:
  void add(const std::optional<double>& value) {
    if (value) sum_ += *value, ++count_;
  }
  std::optional<double> value() const {
    return count_ ? std::optional(sum_ / static_cast<double>(count_)) : std::nullopt;
  }

 private:
  double sum_ = 0;
  std::size_t count_ = 0;
};

std::optional<double> valueIn(const Sample& sample, const StudyMeasure& measure) {
  Mean mean;
  if (measure.onDemand) {
    for (const TakenMeasure& m : sample.more)
      if (m.scope == measure.scope && m.name == measure.row) mean.add(m.value);
  } else if (measure.scope == Scope::world) {
    mean.add(sample.world[measure.row]);
  } else if (measure.scope == Scope::cell) {
    for (const CellMeasures& c : sample.cells) mean.add(c[measure.row]);
  } else {
    for (const ContactMeasures& c : sample.contacts) mean.add(c[measure.row]);
  }
  return mean.value();
}

}  // namespace

std::vector<ResultRow> valuesOf(const std::vector<Sample>& samples,
                                const std::vector<std::string>& measures) {
  std::vector<ResultRow> rows;
  for (const std::string& name : measures) {
    const StudyMeasure* measure = findStudyMeasure(name);
    MORULA_CHECK(measure, "a study's measures are in the table");
    for (const Sample& sample : samples)
      if (const auto value = valueIn(sample, *measure))
        rows.push_back({measure->name, sample.world.time, *value});
  }
  return rows;
}

}  // namespace morula
