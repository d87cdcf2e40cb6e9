#include "report_data/run_facts.h"

#include <algorithm>

#include "base/error.h"
#include "check/check_run.h"
#include "check/remarks.h"
#include "engines/bullet_run.h"
#include "files/content.h"
#include "files/folders.h"
#include "golden/accept.h"
#include "golden/change.h"
#include "loop/stored_scenario.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

std::vector<double> evenTimes(double end, std::size_t count) {
  std::vector<double> times;
  for (std::size_t k = 0; k + 1 < count; ++k)
    times.push_back(end * static_cast<double>(k) / static_cast<double>(count - 1));
  times.push_back(end);
  return times;
}

/// Returns the golden file of the run's scenario, if it lies below the current folder. The database names the
/// scenario's place, and must not reach other files.
std::string goldenOf(const std::vector<SourceText>& documents) {
  for (const SourceText& document : documents) {
    if (document.role != "scenario" || document.path.empty()) continue;
    const fs::path golden = goldenPath(document.path);
    if (fileExists(golden) && liesWithin(golden, currentFolder()) && contentOfFile(golden) == Content::golden)
      return golden.lexically_normal().generic_string();
  }
  return {};
}

GoldenData goldenDataOf(const RunFacts& facts) { return goldenOf(facts.run, facts.results, facts.scenario); }

void compareWithGolden(RunFacts& facts) {
  facts.golden = goldenOf(facts.documents);
  if (facts.golden.empty() || facts.run.status != RunStatus::done) return;
  try {
    const Golden golden = readGoldenFile(facts.golden);
    // An equal state is no change, even if its stored numbers sum up differently.
    if (acceptedBits(golden) != facts.run.stateHash) facts.change = changeInWords(golden.data, goldenDataOf(facts));
  } catch (const InputError& error) { facts.unusableGolden = error.what(); }
}

}  // namespace

std::unique_ptr<BulletAgain> runInBulletAgain(const Scenario& scenario, const World& ours, std::size_t most,
                                              bool quiet) {
  const std::size_t fit = maxFrameVertices / std::max<std::size_t>(1, ours.bodies->livingVertices);
  const auto times = evenTimes(ours.clock.time, std::clamp<std::size_t>(fit, 1, std::max<std::size_t>(1, most)));
  auto again = std::make_unique<BulletAgain>();
  again->found = checkAgainstBullet(scenario, ours, quiet, times);
  if (again->found.bullet) again->frames = framesOf(scenario, again->found.bullet->frames);
  return again;
}

Frames framesOf(const Scenario& scenario, const std::vector<ExternalFrame>& frames) {
  World world = makeBulletStart(scenario);
  FrameTaker taker(0, frames.size());
  for (const ExternalFrame& frame : frames) {
    world.clock.time = frame.time, world.clock.step = frame.step;
    placeCells(world, frame.shapes);
    taker.take(world);
  }
  return std::move(taker.frames());
}

BulletStored compareWithStored(const std::vector<CheckResult>& found, const std::vector<CheckResult>& stored) {
  std::vector<CheckResult> then;
  for (const CheckResult& r : stored)
    if (r.kind == CheckKind::bullet && !wasSkipped(r)) then.push_back(r);
  if (then.empty()) return BulletStored::none;
  const bool same =
      std::equal(found.begin(), found.end(), then.begin(), then.end(), [](const CheckResult& a, const CheckResult& b) {
        return a.check == b.check && a.expected == b.expected && a.actual == b.actual && a.passed == b.passed;
      });
  return same ? BulletStored::same : BulletStored::other;
}

std::string bulletName() {
  for (const auto& [library, version] : buildInfo().libraries)
    if (library == "Bullet") return "Bullet " + version;
  return "Bullet";
}

RunFacts factsOf(Store& store, const StoredRun& run) {
  requireWholeRecord(store, run);
  RunFacts facts{.database = store.file().string(),
                 .run = run,
                 .scenario = storedScenario(store.file().string(), run.id),
                 .documents = store.documents(run.id),
                 .results = store.results(run.id),
                 .checks = store.checks(run.id)};
  facts.ambiguous = ambiguousDivisions(
      facts.scenario.scene, facts.results.lineage, [&](StateId state) { return facts.results.stateTexts.at(state); },
      facts.results.divisions);
  compareWithGolden(facts);
  return facts;
}

std::string changeBetween(const RunFacts& before, const RunFacts& after) {
  return changeInWords(goldenDataOf(before), goldenDataOf(after));
}

bool canRunAgain(const RunFacts& facts) {
  return facts.scenario.scene.mechanics &&
         (facts.run.status == RunStatus::done || facts.run.status == RunStatus::failed);
}

void runAgain(RunFacts& facts, const Execution& how, std::size_t frames, bool hashes, bool quiet) {
  FrameTaker taker(facts.run.time, frames, ForceMeter(makeScenarioWorld(facts.scenario, how)));
  RecordOptions record;
  if (hashes) record.hashEvery = stepsPerHashOf(facts.scenario.scene);
  auto run = simulate(facts.scenario, how, {.quiet = quiet, .record = record, .watch = {&taker}});
  requireEnough(run.end);
  const bool same = facts.run.status == RunStatus::done
                        ? run.end.stateHash && run.end.stateHash->text() == facts.run.stateHash
                        : run.end.status == facts.run.status && run.end.failure == facts.run.failure;
  facts.again = std::make_unique<RunAgain>(RunAgain{std::move(run), std::move(taker.frames()), same});
}

void drawBeside(RunFacts& facts, const Execution& how, bool quiet) {
  if (!facts.again || !facts.again->same || facts.run.status != RunStatus::done || facts.golden.empty() ||
      facts.change.empty())
    return;
  try {
    facts.beside =
        drawBesideGolden(facts.scenario, facts.again->simulation.world, readGoldenFile(facts.golden), how, quiet);
  } catch (const InputError&) {}  // the golden has been changed since it was read
}

}  // namespace morula
