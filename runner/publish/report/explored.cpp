#include "report/explored.h"

#include "report/bullet_block.h"

namespace morula {
namespace {

ExplorerRun explorerRunOf(const RunFacts& facts) {
  ExplorerRun run{.title = titleOf(facts),
                  .scenario = &facts.scenario,
                  .lineage = &facts.results.lineage,
                  .describe = [&facts](StateId state) { return facts.results.stateTexts.at(state); },
                  .end = facts.run.time,
                  .frames = nullptr};
  if (!facts.again) return run;
  const World& world = facts.again->simulation.world;
  run.lineage = &world.lineage.entries;
  run.describe = [&world](StateId state) { return world.biology->describe(state); };
  run.frames = &facts.again->frames;
  return run;
}

/// Makes an explorer's run of the run in Bullet, where cells neither divide nor die: its lineage is that of `ours`.
ExplorerRun explorerRunOf(const BulletAgain& bullet, const ExplorerRun& ours, bool alone) {
  ExplorerRun run = ours;
  run.title = bulletName() + (alone ? "" : ": " + ours.title);
  run.end = bullet.frames.frames.back().time;
  run.frames = &bullet.frames;
  return run;
}

ExplorerRun explorerRunOf(const CheckedScenario& checked) {
  const World& world = checked.again->simulation.world;
  return {.title = checked.report.scenario,
          .scenario = &checked.again->scenario,
          .lineage = &world.lineage.entries,
          .describe = [&world](StateId state) { return world.biology->describe(state); },
          .end = checked.again->simulation.end.time,
          .frames = &checked.again->frames};
}

void showBullet(BulletAgain& bullet, const ExplorerRun& ours, bool alone, Explored& explored) {
  if (bullet.frames.frames.empty() || explored.runs.size() >= maxExplored) return;
  explored.runs.push_back(explorerRunOf(bullet, ours, alone));
  explored.frames.push_back(&bullet.frames);
}

/// Adds Bullet's runs of the same scenarios, after Morula's.
void addBullet(std::vector<RunFacts>& runs, const ReportQuestion& question, Explored& explored) {
  std::size_t made = 0;
  for (RunFacts& run : runs) {
    if (!question.bullet || made == maxInBullet) return;
    if (!run.again || !run.scenario.check.bullet || run.run.status != RunStatus::done) continue;
    run.bullet = runInBulletAgain(run.scenario, run.again->simulation.world, question.frames, question.quiet);
    ++made;
    showBullet(*run.bullet, explorerRunOf(run), runs.size() == 1, explored);
  }
}

}  // namespace

void exploreChecked(std::vector<CheckedScenario>& checked, Explored& explored) {
  for (CheckedScenario& c : checked) {
    if (!c.again || explored.runs.size() >= maxExplored) continue;
    const ExplorerRun run = explorerRunOf(c);
    explored.runs.push_back(run);
    explored.frames.push_back(&c.again->frames);
    if (c.bullet) showBullet(*c.bullet, run, false, explored);
  }
}

void exploreRuns(std::vector<RunFacts>& runs, const ReportQuestion& question, Explored& explored) {
  std::size_t again = explored.runs.size();
  for (RunFacts& run : runs)
    if (question.frames > 0 && again < maxExplored && canRunAgain(run)) {
      ++again;
      runAgain(run, question.execution, question.frames, question.rerun && run.results.chain.empty(), question.quiet);
      explored.frames.push_back(&run.again->frames);
    }
  for (const RunFacts& run : runs)
    if (!run.results.lineage.empty() && explored.runs.size() < maxExplored && (run.again || again == 0))
      explored.runs.push_back(explorerRunOf(run));
  addBullet(runs, question, explored);
}

void exploreMore(std::vector<RunFacts>& runs, const ReportQuestion& question, Explored& explored) {
  // The rest of the page takes up to a third of it, and base64 takes 4 bytes for 3.
  const std::size_t room = question.maxBytes / 2;
  const auto bytesOfLeast = [](const Frames& frames) {
    Frames least = frames;
    dropVertexForces(least);  // they get what room is left
    const std::size_t n = frames.frames.size();
    if (n > minFrames) {
      least.frames.clear();
      for (std::size_t k = 0; k < minFrames; ++k)
        least.frames.push_back(frames.frames[k * (n - 1) / (minFrames - 1)]);
    }
    return packedFrames(least).size();
  };
  std::size_t taken = 0;
  for (const Frames* frames : explored.frames) taken += bytesOfLeast(*frames);
  for (RunFacts& run : runs) {
    if (taken >= room) return;
    if (!canRunAgain(run)) continue;
    runAgain(run, question.execution, question.frames, false, question.quiet);
    explored.frames.push_back(&run.again->frames);
    explored.runs.push_back(explorerRunOf(run));
    taken += bytesOfLeast(run.again->frames);
  }
}

}  // namespace morula
