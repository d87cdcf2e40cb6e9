#include "explain/explain.h"

#include <algorithm>
#include <limits>

#include "golden/difference.h"
#include "loop/simulate.h"
#include "simulation/world.h"

namespace morula {

namespace {

constexpr std::uint64_t toTheEnd = std::numeric_limits<std::uint64_t>::max() / 2;

/// The steps between which the hashes of two runs begin to differ.
struct Window {
  bool same = false;
  std::optional<std::uint64_t> lastEqual;
  std::uint64_t first = 0;                                   // the first step at which they are known to differ
  const StateHashes *expected = nullptr, *actual = nullptr;  // at step `first`; null if a run has no state there
};

Window partingOf(const HashTrace& e, const HashTrace& a) {
  Window w;
  const std::size_t both = std::min(e.links.size(), a.links.size());
  for (std::size_t i = 0; i < both; ++i) {
    if (e.links[i].step == a.links[i].step && e.links[i].state.whole == a.links[i].state.whole) {
      w.lastEqual = e.links[i].step;
      continue;
    }
    w.first = std::min(e.links[i].step, a.links[i].step);
    w.expected = &e.links[i].state, w.actual = &a.links[i].state;
    return w;
  }
  w.same = e.links.size() == a.links.size() && e.lastStep == a.lastStep && e.failure == a.failure;
  w.first = std::min(e.lastStep, a.lastStep) + (e.failure == a.failure ? 1 : 0);  // one ended or failed there
  if (w.lastEqual && w.first <= *w.lastEqual) w.first = *w.lastEqual + 1;
  return w;
}

std::vector<std::string> cellsThatDiffer(const StateHashes& e, const StateHashes& a) {
  std::vector<std::string> cells;
  auto i = e.cells.begin(), j = a.cells.begin();
  while (i != e.cells.end() || j != a.cells.end()) {
    if (j == a.cells.end() || (i != e.cells.end() && i->path < j->path)) cells.push_back((i++)->path.text());
    else if (i == e.cells.end() || j->path < i->path) cells.push_back((j++)->path.text());
    else {
      if (i->hash != j->hash) cells.push_back(i->path.text());
      ++i, ++j;
    }
  }
  return cells;
}

std::string describe(const Explanation& x, const std::string& e, const std::string& a, const HashTrace& te,
                     const HashTrace& ta) {
  std::string text = x.failureClass + ": ";
  text += x.step == 0u ? "different before the first step"
                       : "the same up to step " + std::to_string(x.lastEqual.value_or(0)) + ", different at step " +
                             std::to_string(*x.step);
  text += "\n  expected  " + e + "\n  actual    " + a;
  if (x.difference) text += "\n  first     " + x.difference->text;
  if (!x.cells.empty())
    text += "\n  cells     " + inWords(x.cells) + (x.cells.size() == 1 ? " differs" : " differ") + " there";
  for (const auto& [who, trace] : {std::pair{"expected", &te}, std::pair{"actual", &ta}})
    if (!trace->failure.empty())
      text += "\n  " + std::string(who) + " ended at step " + std::to_string(trace->lastStep) + ": " + trace->failure;
  return text + '\n';
}

}  // namespace

Explanation explain(RunSource& expected, RunSource& actual, std::uint64_t every) {
  Explanation x;
  HashTrace e = expected.hashTrace(0, toTheEnd, every), a = actual.hashTrace(0, toTheEnd, every);
  if (!e.links.empty()) x.expectedEnd = e.links.back().state.whole;
  Window window = partingOf(e, a);
  if (window.same) {
    x.lastEqual = e.lastStep;
    x.text = "the same bits at all " + std::to_string(e.links.size()) + " states looked at, to step " +
             std::to_string(e.lastStep) + '\n';
    return x;
  }
  if (const std::uint64_t from = window.lastEqual.value_or(0); window.first > from + 1) {
    HashTrace finerE = expected.hashTrace(from, window.first, 1), finerA = actual.hashTrace(from, window.first, 1);
    const auto stepByStep = [from](const HashTrace& t) { return t.links.size() > 1 && t.links[1].step == from + 1; };
    if (stepByStep(finerE) && stepByStep(finerA)) {
      const Window finer = partingOf(finerE, finerA);
      if (finer.same) window = {false, window.first, window.first + 1};  // one run ends there, the other continues
      else e = std::move(finerE), a = std::move(finerA), window = partingOf(e, a);
    }
  }
  x.lastEqual = window.lastEqual;
  x.step = window.first;
  if (window.expected && window.actual) x.cells = cellsThatDiffer(*window.expected, *window.actual);
  const auto worldE = expected.stateAt(window.first), worldA = actual.stateAt(window.first);
  if (worldE && worldA) x.difference = findStateDifference(*worldE, *worldA);
  x.cell = x.difference ? x.difference->cell : x.cells.empty() ? std::nullopt : std::optional(x.cells.front());
  x.failureClass = window.first == 0 ? "SETUP" : x.difference && x.difference->lineage ? "LINEAGE" : "COMPUTATION";
  x.text = describe(x, expected.name(), actual.name(), e, a);
  for (const RunSource* w : {&expected, &actual})
    if (!w->noState.empty()) x.text += "  no vertex and values: " + w->name() + ": " + w->noState + '\n';
  return x;
}

Explanation explainTwice(RunSource& first, RunSource& second, std::uint64_t every) {
  Explanation x = explain(first, second, every);
  if (x.failureClass.empty()) return x;
  x.failureClass = "NONDETERMINISM";
  x.text = "NONDETERMINISM: two runs of this program differ, so other differences cannot be classified\n" + x.text;
  return x;
}

Explanation explainTwice(const Scenario& scenario, const Execution& how, std::uint64_t every) {
  OwnRun first = scenarioRun(scenario, how), second = scenarioRun(scenario, otherExecution(how));
  return explainTwice(first, second, every);
}

}  // namespace morula
