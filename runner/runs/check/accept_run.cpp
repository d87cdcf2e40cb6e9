#include "check/accept_run.h"

#include <algorithm>

#include "base/error.h"
#include "check/check_run.h"
#include "check/pending.h"
#include "check/sanity_check.h"
#include "files/folders.h"
#include "golden/change.h"
#include "golden/golden_diff.h"
#include "loop/progress.h"
#include "loop/twin_run.h"
#include "system/console.h"
#include "system/installation.h"
#include "system/signals.h"

namespace morula {
namespace {

/// Bits are checked exactly; the values beside them tell how large a difference is.
std::vector<ToleranceRule> usualRules(const Scenario& scenario) {
  if (!scenario.scene.mechanics) return {};  // a lineage has no values
  return {readRule("tolerance * rel 1e-9 scale 1 why \"what the bits tell exactly, in numbers people can weigh\"",
                   "usual rules")};
}

/// No result is worth keeping that breaks what the scenario itself demands, or that is not sane.
void refuseViolated(const Scenario& scenario, const CheckedRun& checked) {
  CheckReport report{goldenName(scenario.file), checkInvariants(scenario, checked)};
  report.results.insert(report.results.end(), checked.sanity.begin(), checked.sanity.end());
  if (!scenario.check.fails.empty()) report = checkStop(scenario, "");
  if (!report.passed()) throw InputError(scenario.file + ": nothing accepted: " + describe(report));
}

/// Returns true if two results are the same apart from pictures, which depend on the renderer.
bool isSameResult(GoldenData a, GoldenData b) {
  const auto isImage = [](const GoldenItem& item) { return std::holds_alternative<GoldenImage>(item); };
  std::erase_if(a.items, isImage), std::erase_if(b.items, isImage);
  const auto same = [](const GoldenItem& x, const GoldenItem& y) { return agree(x, y) && keyOf(x) == keyOf(y); };
  return a.scenarioHash == b.scenarioHash && a.seed == b.seed && std::ranges::equal(a.items, b.items, same);
}

/// Runs the scenario again with other kernels. With bodies its twin runs beside it.
TwinRun runAgain(const Scenario& scenario, const Execution& how, bool quiet) {
  const std::string label = scenario.scene.name + " again";
  if (!scenario.scene.mechanics)
    return {{}, simulate(scenario, how, {.label = label, .quiet = quiet}).end.stateHash.value_or(Hash{})};
  const SignalWatch signals;
  Progress progress(label, quiet);
  return runTwins(makeScenarioWorld(scenario, how), makeScenarioWorld(scenario, how), [&](const World& world) {
    stopAtSignal();
    progress.show(world);
  });
}

}  // namespace

AcceptedRun acceptRun(const Scenario& scenario, const Execution& how, const Acceptance& acceptance, bool quiet) {
  const auto file = goldenFile(scenario);
  refuseWithinCi(file);
  const CheckedRun checked = simulateChecked(scenario, how, {.quiet = quiet, .record = recordingOf(scenario, true)});
  const Simulation& run = checked.run;
  if (run.end.status != RunStatus::done) throw InputError(scenario.file + ": " + run.end.failure);
  refuseViolated(scenario, checked);
  const GoldenData observed = observe(scenario, run);
  if (const auto waiting = waitingResult(scenario); waiting && !isSameResult(*waiting, observed)) {
    AcceptedRun refused{.other = true};
    refused.text = "nothing accepted: " + scenario.file +
                   ": the result of this run differs from the result that waited for a review:\n" +
                   changeInWords(*waiting, observed) + describeGoldenDiff({*waiting, {}, {}, {}}, observed) +
                   "look at the new result with `" + programWord() + " review " + shellWord(scenario.file) +
                   "`, and accept it if it is right\n";
    putPending(scenario, run, observed, how, quiet);
    return refused;
  }
  const TwinRun again = runAgain(scenario, otherExecution(how), quiet);
  if (again.end != *run.end.stateHash) return {.nondeterministic = true};

  Golden golden{observed, {}, {}, usualRules(scenario), {}, again.growth};
  AcceptedRun accepted{.done = true};
  if (fileExists(file)) {
    try {
      const Golden old = readAccepted(scenario, file);
      golden.rules = old.rules;
      // A key that is only called by another word leaves the run, and so its errors, as they are.
      if (old.data.scenarioHash == golden.data.scenarioHash || acceptedBits(old) == acceptedBits(golden))
        golden.stated = old.stated, golden.statistics = old.statistics;
      golden.data = keepValuesWithinTolerance(std::move(golden.data), old);
      accepted.text = changeInWords(old.data, golden.data) + describeGoldenDiff(old, golden.data);
    } catch (const InputError& e) {  // damaged, or of an older version: there is nothing to keep of it
      accepted.text = std::string(e.what()) + "\nthe new golden keeps no tolerances or errors of the old one\n";
    }
  }
  std::vector<std::string> notes;
  golden.rules = limitToHorizon(golden, notes);
  for (const auto& note : notes) accepted.text += "tolerance " + note + '\n';
  acceptGolden(file, std::move(golden), acceptance);
  accepted.text += "accepted: " + file.string() + '\n';
  return accepted;
}

}  // namespace morula
