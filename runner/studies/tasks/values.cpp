#include "tasks/values.h"

#include <algorithm>

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

/// Which cells of a sample a measure is of.
class Selected {
 public:
  Selected(const Sample& sample, const StudyMeasure& measure, const std::map<StateId, std::string>& states) {
    if (!measure.of) return;
    some_.emplace();
    for (const CellMeasures& c : sample.cells)
      if (measure.of->has(c.path, states.at(c.state))) some_->push_back(c.path);  // by path
  }
  bool has(const CellPath& cell) const { return !some_ || std::ranges::binary_search(*some_, cell); }
  double count() const { return static_cast<double>(some_->size()); }

 private:
  std::optional<std::vector<CellPath>> some_;  // absent: all
};

std::optional<double> valueIn(const Sample& sample, const StudyMeasure& measure, const Selected& cells) {
  if (measure.isCount()) return cells.count();
  const bool ofPairs = measure.scope == Scope::pair;
  const auto counts = [&](const CellPath& a, const CellPath& b) {
    return cells.has(a) || (ofPairs && cells.has(b));
  };
  Mean mean;
  if (measure.onDemand) {
    for (const TakenMeasure& m : sample.more)
      if (m.scope == measure.scope && m.name == measure.row && counts(m.a, m.b)) mean.add(m.value);
  } else if (measure.scope == Scope::world) {
    mean.add(sample.world[measure.row]);
  } else if (ofPairs) {
    for (const ContactMeasures& c : sample.contacts)
      if (counts(c.a, c.b)) mean.add(c[measure.row]);
  } else {
    for (const CellMeasures& c : sample.cells)
      if (cells.has(c.path)) mean.add(c[measure.row]);
  }
  return mean.value();
}

}  // namespace

std::vector<ResultRow> valuesOf(const std::vector<Sample>& samples,
                                const std::map<StateId, std::string>& states,
                                const std::vector<std::string>& measures) {
  std::vector<ResultRow> rows;
  for (const std::string& name : measures) {
    const std::optional<StudyMeasure> measure = findStudyMeasure(name);
    MORULA_CHECK(measure, "a study's measures are known");
    for (const Sample& sample : samples)
      if (const auto value = valueIn(sample, *measure, Selected(sample, *measure, states)))
        rows.push_back({measure->name, sample.world.time, *value});
  }
  return rows;
}

}  // namespace morula
