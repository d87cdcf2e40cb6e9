#include "run/draw_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "check/beside_golden.h"
#include "check/check_run.h"
#include "drawing/png_file.h"
#include "engines/bullet_check.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "golden/accept.h"
#include "system/folder_lock.h"

namespace morula {
namespace {

void besideBullet(const Scenario& scenario, const RunSettings& settings, const Simulation& run, Store& store,
                  RunOutcome& outcome) {
  if (!scenario.check.bullet || !settings.check || settings.changed) return;
  const BulletFindings found = checkAgainstBullet(scenario, run.world, settings.quiet);
  if (!outcome.checks) outcome.checks = CheckReport{goldenName(scenario.file), {}};
  outcome.checks->results.insert(outcome.checks->results.end(), found.results.begin(), found.results.end());
  store.addChecks(outcome.id, found.results);
  if (!found.bullet) return;
  store.putBulletSamples(outcome.id, name(scenario.check.bullet->baseline), found.bullet->samples);
  if (!settings.draw) return;
  const FolderLock lock(settings.folder);
  outcome.pictures.push_back((settings.folder / "bullet.png").string());
  writePicture(comparisonSheet(imagesBesideBullet(run.world, found.bullet->shapes, scenario)), outcome.pictures.back());
}

/// Writes golden.png (the accepted result, this one, and their distance) if the run differs from its golden; otherwise
/// removes the one of an earlier run.
void besideGolden(const Scenario& scenario, const RunSettings& settings, const Simulation& run, RunOutcome& outcome) {
  const auto file = settings.folder / "golden.png";
  const bool differs =
      outcome.checks && std::any_of(outcome.checks->results.begin(), outcome.checks->results.end(),
                                    [](const CheckResult& r) { return !r.passed && r.kind == CheckKind::golden; });
  const auto beside =
      differs ? drawBesideGoldenFile(scenario, run.world, settings.execution, settings.quiet) : std::nullopt;
  const FolderLock lock(settings.folder);
  if (beside) {
    writePicture(beside->sheet(), file);
    outcome.pictures.push_back(file.string());
  } else if (fileExists(file) && isOwnPng(readHead(file, 64))) {
    removeFile(file);
  }
}

}  // namespace

void drawRun(const Scenario& scenario, const RunSettings& settings, const Simulation& run, FrameCollector& frames,
             Store& store, RunOutcome& outcome) {
  try {
    if (settings.draw) {
      // Runs with the same folder draw one after the other, so that all pictures are of one run, the last.
      const FolderLock lock(settings.folder);
      outcome.pictures = writePictures(run.world, scenario, frames, settings.folder);
    }
    if (settings.draw) besideGolden(scenario, settings, run, outcome);
    besideBullet(scenario, settings, run, store, outcome);
  } catch (const NumericalError& error) {
    if (error.want == Want::nothing) throw;
    throw NumericalError(fmt::format("{}; run {} is stored in {}", error.what(), outcome.id, outcome.database.string()),
                         error.want);
  }
}

}  // namespace morula
