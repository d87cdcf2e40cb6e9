#include "check/check_run.h"

#include "base/error.h"
#include "files/folders.h"
#include "files/text.h"
#include "golden/accept.h"
#include "golden/observe.h"
#include "observation/measures.h"
#include "organism/organism_renderer.h"
#include "pictures/pictures.h"
#include "scenario/deciding_values.h"
#include "system/git_text.h"
#include "system/installation.h"
#include "yaml/numbers.h"

namespace morula {
namespace {

/// [radii of the shell] How far a vertex may lie outside the shell. Positions are projected onto the shell, up to
/// rounding.
constexpr double shellSlack = 1e-6;

CheckResult shellHolds(const World& world) {
  const double outermost = measure<Observation>("outermost").get(Observation(world)).value_or(0);
  const std::string text = exactText(outermost);
  return judged({.check = "shell",
                 .kind = CheckKind::invariant,
                 .expected = "1",
                 .actual = text,
                 .tolerance = "abs " + exactText(shellSlack),
                 .field = "outermost",
                 .share = outermost <= 1 ? 0 : (outermost - 1) / shellSlack},
                outermost <= 1 + shellSlack, "a vertex stands at " + text + " of the shell's radius; needs at most 1");
}

Hash hashOf(const Image& image) {
  Hasher hasher;
  hasher.add(image.width).add(image.height);
  std::string bytes;
  for (const Colour& c : image.pixels) bytes += {char(c.r), char(c.g), char(c.b)};
  return hasher.add(bytes).digest();
}

/// The picture without words, because another library draws the letters.
GoldenImage imageOf(const Simulation& run, const Scenario& scenario) {
  OrganismPicture picture = pictureOf(run.world, scenario);
  picture.title = picture.caption = "";
  picture.legend.clear();
  return {"organism", rendererName(), hashOf(drawOrganism(picture))};
}

/// A message without the places "file:line:column: " at the beginnings of its lines: names of files are no reasons.
std::string withoutPlaces(const std::string& message, const std::string& file) {
  std::string text;
  for (const std::string& line : linesOf(message)) {
    const auto end = line.starts_with(file + ':') ? line.find(": ") : line.npos;
    text += (text.empty() ? "" : "\n") + (end == line.npos ? line : line.substr(end + 2));
  }
  return text;
}

CheckResult goldenMissing(const Scenario& scenario, const std::filesystem::path& file) {
  return failedCheck("golden", FailureClass::setup, "a golden file", "none",
                     file.string() + " does not exist; accept the result: " + programWord() + " review " +
                         shellWord(scenario.file) + " --accept --why \"…\"");
}

}  // namespace

RunChecks::RunChecks(const Scenario& scenario, const World& start, bool asked)
    : scenario_(scenario),
      asked_(asked),
      watches_(asked && Invariants::areGiven(scenario.check)),
      invariants_(asked ? scenario.check : CheckParameters{}),
      sanity_(start) {}

void RunChecks::see(const World& world) {
  if (watches_) invariants_.observe(world);
}

CheckedRun RunChecks::of(Simulation run) const {
  std::vector<CheckResult> sanity;
  if (run.end.status == RunStatus::done) sanity = sanity_.results(run.world, scenario_.check, asked_);
  return {std::move(run), invariants_, std::move(sanity)};
}

CheckedRun simulateChecked(const Scenario& scenario, const Execution& how, RunOptions options, bool asked) {
  World start = makeScenarioWorld(scenario, how);
  RunChecks checks(scenario, start, asked);
  options.watch.push_back(&checks);
  return checks.of(simulate(scenario, std::move(start), std::move(options)));
}

GoldenData observe(const Scenario& scenario, const Simulation& run, bool withPicture) {
  GoldenFacts facts;
  facts.scenario = goldenName(scenario.file), facts.scenarioHash = scenario.meaning.text();
  // A golden holds only samples that the scenario asks for, not the first and last ones of every run.
  for (const RunResults* part : {&run.kept.records, &run.results}) {
    if (scenario.record.every)
      for (const auto& sample : part->samples) facts.samples.push_back(sample.world);
    facts.chain.insert(facts.chain.end(), part->chain.begin(), part->chain.end());
  }
  RecordedTables tables = run.kept.tables;
  tables.addAll(run.results, run.end.steps);
  facts.tables = tables.items();
  if (run.world.bodies && run.world.cells.path.size() <= goldenCellLimit)
    facts.images.push_back(withPicture ? imageOf(run, scenario) : GoldenImage{"organism", GoldenImage::undrawn, {}});
  GoldenData data = observeGolden(run.world, std::move(facts));
  data.parameters = decidingValues(scenario);
  return data;
}

GoldenData goldenOf(const StoredRun& run, const RunResults& results, const Scenario& scenario) {
  GoldenFacts facts;
  facts.scenario = run.record.scenario, facts.scenarioHash = run.record.scenarioHash;
  facts.seed = run.record.seed, facts.steps = run.steps;
  facts.lineage = results.lineage;
  facts.describe = [&](StateId state) { return results.stateTexts.at(state); };
  for (const TimeStepRecord& t : results.timeSteps) facts.timeSteps.push_back({t.step, t.time, t.timeStep});
  if (!results.samples.empty() && results.samples.back().world.step == run.steps) {
    facts.mechanics = !results.samples.back().cells.empty();
    facts.end = results.samples.back().world, facts.cells = results.samples.back().cells;
  }
  GoldenData data = makeGoldenData(facts);
  data.parameters = decidingValues(scenario);
  return data;
}

Golden readAccepted(const Scenario& scenario, const std::filesystem::path& file) {
  Golden golden = readGoldenFile(file);
  if (!golden.data.parameters.empty() || golden.data.scenarioHash == scenario.meaning.text()) return golden;
  const auto committed = committedText(scenario.file);
  if (!committed) return golden;
  try {
    const auto before = readScenario(*committed, scenario.file, folderOf(scenario.file), {}, {}, scenario.allowOutside);
    if (before.meaning.text() == golden.data.scenarioHash) golden.data.parameters = decidingValues(before);
  } catch (const InputError&) {  // of another version of the format: its parameters cannot be read
  }
  return golden;
}

std::filesystem::path goldenFile(const Scenario& scenario) { return goldenPath(scenario.file); }

CheckReport check(const Scenario& scenario, const CheckedRun& checked, const GoldenData& observed, bool needsGolden) {
  if (!scenario.check.fails.empty()) return checkStop(scenario, "");
  CheckReport report{goldenName(scenario.file), {}};
  const auto file = goldenFile(scenario);
  if (fileExists(file)) {
    try {
      report = compareGolden(readAccepted(scenario, file), observed);
    } catch (const InputError& unusable) { report = unusableGolden(report.scenario, unusable.what()); }
  } else if (needsGolden) report.results.push_back(goldenMissing(scenario, file));
  for (auto& result : checkInvariants(scenario, checked)) report.results.push_back(std::move(result));
  return report;
}

std::vector<CheckResult> checkWithoutGolden(const Scenario& scenario, const CheckedRun& checked) {
  const RunEnd& end = checked.run.end;
  if (!scenario.check.fails.empty()) return checkStop(scenario, end.failure).results;
  return end.status == RunStatus::done ? checkInvariants(scenario, checked) : std::vector<CheckResult>();
}

std::vector<CheckResult> checkInvariants(const Scenario& scenario, const CheckedRun& checked) {
  const World& end = checked.run.world;
  std::vector<CheckResult> results;
  const auto& mechanics = scenario.scene.mechanics;
  if (mechanics && mechanics->physics.shell) results.push_back(shellHolds(end));
  for (auto& result : checked.invariants.results(end)) results.push_back(std::move(result));
  return results;
}

CheckReport checkStop(const Scenario& scenario, const std::string& failure) {
  const std::string name = goldenName(scenario.file);
  if (const auto file = goldenFile(scenario); !scenario.check.fails.empty() && fileExists(file))
    return unusableGolden(name, file.string() +
                                    ": a scenario that must stop (check.fails) has no result to accept; remove this "
                                    "golden, or remove check.fails if the run must not stop");
  return {name, {stopsAsItMust(scenario.check.fails, withoutPlaces(failure, scenario.file))}};
}

}  // namespace morula
