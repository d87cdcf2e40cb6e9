#pragma once
// All rows of a run's results, table by table, for storing, digests and goldens. A new table is added in this file.
#include <algorithm>

#include "base/error.h"
#include "store/run_tables.h"

namespace morula {

/// Calls visit(step, row, context…) for each row of samples and hashes. The context holds the values of the columns
/// before the row's own, without the run's id.
template <class Visit>
void visitRecords(const RunResults& results, const Visit& visit) {
  for (const Sample& s : results.samples) {
    const double time = s.world.time;
    const std::uint64_t step = s.world.step;
    visit(step, s.world);
    for (const TakenMeasure& m : s.more) visit(step, m, time);
    for (const CellSurface& c : s.surfaces) visit(step, c, time);
    for (const CellMeasures& c : s.cells) {
      const auto state = results.stateTexts.find(c.state);
      MORULA_CHECK(state != results.stateTexts.end(), "every state in the results has its text");
      visit(step, CellSampleRow{c, state->second}, time);
    }
    for (const ContactMeasures& c : s.contacts) visit(step, c, time);
  }
  for (const ChainLink& link : results.chain) {
    visit(link.step, link);
    for (const CellHash& c : link.state.cells) visit(link.step, c, link.step);
  }
}

/// Calls visit(step, row, context…) for each row that is known when the run has ended. `step`: the last step.
template <class Visit>
void visitEnd(const RunResults& results, std::uint64_t step, const Visit& visit) {
  for (const LineageEntry& e : results.lineage) {
    const auto state = results.stateTexts.find(e.state);
    MORULA_CHECK(state != results.stateTexts.end(), "every state in the results has its text");
    const auto label = results.names.find(e.path);
    visit(e.bornStep,
          CellRow{e, state->second, label == results.names.end() ? std::nullopt : std::optional(label->second)});
  }
  std::int64_t number = 0;
  for (const ConnectionRecord& c : results.connections) visit(step, c, number++);
  for (const TimeStepRecord& t : results.timeSteps) visit(t.step, t);
  for (const SettlingRecord& s : results.settlings) visit(s.step, s);
  std::int64_t deed = 0;
  for (const ExperimentRecord& e : results.experiments) visit(e.step, e, deed++);
  for (const DivisionRecord& d : results.divisions) visit(d.step, d);
}

}  // namespace morula
