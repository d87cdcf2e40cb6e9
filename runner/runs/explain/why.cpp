#include "explain/why.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "base/error.h"
#include "base/number_text.h"
#include "check/check_run.h"
#include "check/golden_scenario.h"
#include "explain/run_source.h"
#include "files/folders.h"
#include "files/text.h"
#include "golden/accept.h"
#include "loop/run.h"
#include "loop/simulate.h"
#include "loop/stored_scenario.h"
#include "scenario/scenario.h"
#include "simulation/simulation.h"
#include "store/store.h"
#include "system/signals.h"

namespace morula {
namespace {

/// The vertex that has moved farthest from its place in the other run.
struct Farthest {
  double distance = 0;  // [length]
  std::size_t cell = 0;
  int vertex = 0;
};

Farthest farthest(const World& before, const World& now) {
  Farthest most;
  for (std::size_t i = 0; i < now.cells.path.size(); ++i) {
    const int a = before.bodies->slots[i], b = now.bodies->slots[i];
    for (int v = 0; v < std::min(before.bodies->vertexCount(a), now.bodies->vertexCount(b)); ++v) {
      const Vector d = now.bodies->vertex(b, v) - before.bodies->vertex(a, v);
      if (const double r = std::sqrt(dot(d, d)); r > most.distance) most = {r, i, v};
    }
  }
  return most;
}

bool stepBoth(Run& a, Run& b) {
  stopAtSignal();
  try {
    if (!a.advance(1) || !b.advance(1)) return false;
  } catch (const NumericalError&) { return false; }
  return a.world().clock.time == b.world().clock.time && a.world().cells.path == b.world().cells.path;
}

/// Runs both scenarios side by side, with the same `how`, as long as they have the same cells at the same times.
/// Returns two lines for people, in the form of changeInWords. The first line tells the step, cell and vertex at which
/// the runs first differ, and the distance [radii of the egg]. The second line tells from which steps on the farthest
/// vertex differs by 0.001, 0.01 and 0.1 radii. Returns "" without bodies or differences. Throws Interrupted if a
/// signal has come.
std::string partingInWords(const Scenario& before, const Scenario& now, const Execution& how) {
  Run beforeRun(makeScenarioWorld(before, how)), nowRun(makeScenarioWorld(now, how));
  const World &a = beforeRun.world(), &b = nowRun.world();
  if (!a.bodies || !b.bodies) return {};
  const double radius = before.scene.mechanics->physics.cell.radius;
  std::string first, apart;
  double next = 1e-3;  // [radii]
  do {
    const Farthest most = farthest(a, b);
    if (most.distance == 0) continue;
    const std::string cell = cellName(b.cells.path[most.cell].text()), step = std::to_string(b.clock.step);
    if (first.empty())
      first = "  moves     first at step " + step + ", time " + numberText(b.clock.time) + ": " + cell + ", vertex " +
              std::to_string(most.vertex) + ", by " + numberText(most.distance / radius, 3) + " radii of the egg\n";
    for (; next < 1 && most.distance >= next * radius; next *= 10)
      apart += (apart.empty() ? "  apart     by " : ", ") + numberText(next) + " radii from step " + step + " on (" +
               cell + ")";
  } while (stepBoth(beforeRun, nowRun));
  return first + apart + (apart.empty() ? "" : "\n");
}

/// Compares two runs of this program that compute in different ways.
void lookForNondeterminism(const Scenario& scenario, const WhyQuestion& question, Findings& f) {
  f.where = explainTwice(scenario, question.execution, question.every);
  f.failureClass = f.where.failureClass;
  f.text += (f.failureClass == FailureClass::none ? "two runs of this program: " : "") + f.where.text;
}

/// Runs the scenario to its end and tells how the result differs from `before`, in words.
void tellChange(const Scenario& scenario, const GoldenData& before, const WhyQuestion& question, Findings& f) {
  const auto run =
      simulate(scenario, question.execution, {.quiet = question.quiet, .record = recordingOf(scenario, false)});
  requireEnough(run.end);
  const GoldenData now = observe(scenario, run, false);
  f.changed = changedKeys(before, now);
  f.text += changeInWords(before, now);
  if (run.end.status != RunStatus::done)
    f.text += "  the run failed at step " + std::to_string(run.end.steps) + ": " + run.end.failure + "\n";
}

/// Runs both scenarios and tells where the results of the present one begin to differ from those of the earlier one,
/// `before`. `accepted`: the hash of the earlier scenario's end state in its golden; "" if unknown.
void tellWhereItBegan(const Scenario& before, const Scenario& scenario, const std::string& called,
                      const std::string& accepted, const WhyQuestion& question, Findings& f) {
  OwnRun expected = scenarioRun(before, question.execution, called + ", made again"),
         actual = scenarioRun(scenario, question.execution);
  f.where = explain(expected, actual, question.every);
  if (f.where.failureClass == FailureClass::none) {
    f.text += "where the difference began: nowhere, because both scenarios give " + f.where.text;
    return;
  }
  f.text += "where it began: " + f.where.text.substr(std::string(nameOf(f.where.failureClass)).size() + 2) +
            partingInWords(before, scenario, question.execution);
  f.where.failureClass = f.failureClass;
  if (!accepted.empty() && f.where.expectedEnd && f.where.expectedEnd->text() != accepted)
    f.text +=
        "With the accepted scenario this program does not compute the accepted bits, so the computation has "
        "changed, too\n";
}

/// Returns true if the scenario has changed, which explains everything else.
bool lookAtInput(const Scenario& scenario, const StoredRun& stored, Findings& f) {
  if (stored.record.scenarioHash == scenario.meaning.text()) return false;
  f.failureClass = f.where.failureClass = FailureClass::inputChanged;
  f.text += "INPUT_CHANGED: the scenario is not that of run " + stored.id + "\n";
  return true;
}

void compareWithStored(const Scenario& scenario, const WhyQuestion& question, Findings& f) {
  auto store = Store::openForReading(question.database);
  const StoredRun stored = store.find(question.run);
  requireWholeRecord(store, stored);
  const bool otherInput = lookAtInput(scenario, stored, f);
  std::optional<GoldenData> before;
  std::optional<Scenario> theirs;
  try {
    theirs = storedScenario(question.database, stored.id);
    before = goldenOf(stored, store.results(stored.id), *theirs);
  } catch (const InputError& unreadable) {  // another version of Morula stored the scenario, with other keys
    if (otherInput)
      f.text += "the changed keys are not known, because this program cannot read the stored scenario: " +
                firstLine(unreadable.what()) + '\n';
  }
  if (otherInput) {
    if (!before) return;
    tellChange(scenario, *before, question, f);
    tellWhereItBegan(*theirs, scenario, "the scenario of run " + stored.id, "", question, f);
    return;
  }
  const auto chain = store.chain(stored.id);
  if (chain.empty())
    throw InputError(question.database + ": run " + stored.id +
                     " kept no chain, the hashes of the states between start and end; run the scenario again with a "
                     "golden file or with `check: {}` in it, and without --no-check, --set and --seed");
  std::uint64_t step = 0;
  if (const auto broken = findBrokenLink(chain, step); !broken.empty()) {
    f.failureClass = f.where.failureClass = FailureClass::inputChanged;
    f.where.step = step;
    f.text += "INPUT_CHANGED: run " + stored.id + " in " + question.database + ": " + broken + "\n";
    return;
  }
  StoredRunSource expected("run " + stored.id + " in " + question.database, chain, stored.steps, stored.failure);
  OwnRun actual = scenarioRun(scenario, question.execution);
  f.where = explain(expected, actual, chain.size() > 1 ? chain[1].step - chain[0].step : 1);
  f.failureClass = f.where.failureClass;
  if (f.failureClass != FailureClass::none && before) tellChange(scenario, *before, question, f);
  f.text += f.where.text;
}

void compareWithProgram(const Scenario& scenario, const WhyQuestion& question, Findings& f) {
  std::vector<std::string> more;
  if (scenario.allowOutside) more.push_back("--allow-outside");  // older programs do not know this option
  ProgramRun expected(
      question.program, scenario.file, [&] { return makeScenarioWorld(scenario, question.execution); }, more);
  OwnRun actual = scenarioRun(scenario, question.execution);
  f.where = explain(expected, actual, question.every);
  f.failureClass = f.where.failureClass;
  f.text += f.where.text;
}

/// Tells how the scenario differs from the golden's scenario. Tells nothing if the golden cannot be read.
void tellChangedScenario(const Scenario& scenario, const Simulation& run, const WhyQuestion& question, Findings& f) {
  try {
    const Golden golden = readAccepted(scenario, goldenFile(scenario));
    f.changed = changedKeys(golden.data, observe(scenario, run, false));
    if (golden.data.scenarioHash == scenario.meaning.text()) return;
    if (const auto before = goldenScenario(scenario, golden))
      tellWhereItBegan(*before, scenario, "the accepted scenario", acceptedBits(golden), question, f);
    else
      f.text +=
          "the beginning of the difference is not known, because the goldens and commits here do not hold the whole "
          "accepted scenario; --db FILE compares with a stored run\n";
  } catch (const InputError&) {}
}

void compareWithGolden(const Scenario& scenario, const WhyQuestion& question, Findings& f) {
  const CheckedRun checked =
      simulateChecked(scenario, question.execution, {.quiet = question.quiet, .record = recordingOf(scenario, true)});
  const Simulation& run = checked.run;
  requireEnough(run.end);
  if (run.end.status == RunStatus::failed && checkStop(scenario, run.end.failure).passed()) {
    f.text += describe(checkStop(scenario, run.end.failure));
    return;
  }
  if (run.end.status != RunStatus::done) {
    f.failureClass = FailureClass::computation;
    f.where.step = run.end.steps;
    f.text += "COMPUTATION: the run failed at step " + std::to_string(run.end.steps) + ": " + run.end.failure + "\n";
    return;
  }
  const CheckReport report = check(scenario, checked, observe(scenario, run), true);
  f.checks = report.results;
  f.text += describe(report, true);
  const CheckResult* first = nullptr;  // the failed check that explains the others: the earliest, before CHAOS
  for (const auto& r : report.results)
    if (!r.passed && (!first || (first->failureClass == FailureClass::chaos && r.failureClass != FailureClass::chaos) ||
                      (r.firstStep && first->firstStep && *r.firstStep < *first->firstStep)))
      first = &r;
  if (!first) return;
  f.failureClass = first->failureClass;
  f.where.step = first->firstStep;
  f.where.cell = first->cell;
  if (fileExists(goldenFile(scenario))) tellChangedScenario(scenario, run, question, f);
  if (f.failureClass != FailureClass::inputChanged) {
    f.text +=
        "A golden holds hashes, not states. To see the first step, the vertex and both values, compare with the "
        "program that made the golden (--with PROGRAM), or with the stored run (--db FILE)\n";
  }
}

}  // namespace

Findings findWhy(const Scenario& scenario, const WhyQuestion& question) {
  const SignalWatch signals;
  Findings f;
  lookForNondeterminism(scenario, question, f);
  if (f.failureClass != FailureClass::none) {
    f.text = withNames(f.text, scenario.names.function());
    return f;
  }
  if (!question.database.empty()) compareWithStored(scenario, question, f);
  else if (!question.program.empty()) compareWithProgram(scenario, question, f);
  else compareWithGolden(scenario, question, f);
  f.text = withNames(f.text, scenario.names.function());
  return f;
}

Json toJson(const Scenario& scenario, const Findings& f) {
  const auto& d = f.where.difference;
  Json checks = Json::array(), changed = Json::array();
  for (const KeyChange& c : f.changed) changed.push_back({{"key", c.key}, {"expected", c.before}, {"actual", c.after}});
  for (const auto& r : f.checks)
    checks.push_back({{"check", r.check},
                      {"passed", r.passed},
                      {"class", nameOf(r.failureClass)},
                      {"first_step", orNull(r.firstStep)}});
  return {{"scenario", goldenName(scenario.file)},
          {"class", nameOf(f.failureClass)},
          {"first_step", orNull(f.where.step)},
          {"last_equal_step", orNull(f.where.lastEqual)},
          {"cell", orNull(f.where.cell)},
          {"cells", f.where.cells},
          {"field", d ? Json(d->field) : Json()},
          {"vertex", d ? orNull(d->vertex) : Json()},
          {"component", d ? Json(d->component) : Json()},
          {"expected", d ? Json(d->expected) : Json()},
          {"actual", d ? Json(d->actual) : Json()},
          {"changed", changed},
          {"text", f.text},
          {"checks", checks}};
}

}  // namespace morula
