#pragma once
// The facts of one run on a page: its rows in the database, its scenario and golden, the run made again for its shapes,
// which few databases keep, and its run in Bullet, whose shapes no database keeps.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "check/beside_golden.h"
#include "engines/bullet_check.h"
#include "loop/simulate.h"
#include "report_data/frames.h"
#include "store/store.h"

namespace morula {

struct BulletAgain {
  BulletFindings found;  // as checkAgainstBullet finds it now
  Frames frames;         // none unless Bullet came to the same end
};

/// Runs a scenario with check.bullet in Bullet. `ours`: our world at its end. At most `most` frames, evenly over time;
/// fewer of many vertices, so that the answer stays below maxFrameVertices. `most` is 1 at least.
std::unique_ptr<BulletAgain> runInBulletAgain(const Scenario& scenario, const World& ours, std::size_t most,
                                              bool quiet);

/// Converts shapes to frames of a page. Bullet's contacts are not measured. Velocities are those of the start.
Frames framesOf(const Scenario& scenario, const std::vector<ExternalFrame>& frames);

/// How the numbers found now lie to those that are stored with the run.
enum class BulletStored { none, same, other };
BulletStored compareWithStored(const std::vector<CheckResult>& found, const std::vector<CheckResult>& stored);

/// "Bullet 3.24": the library that this program was built with.
std::string bulletName();

/// The run made again from its record.
struct RunAgain {
  Simulation simulation;
  Frames frames;
  bool same = false;  // it ended in the stored state, bit for bit
};

struct RunFacts {
  std::string database;    // as given
  std::string label = {};  // of the condition of a study that it stands for; "" for a run of its own
  std::string title = {};  // what it is called on its page
  StoredRun run;
  Scenario scenario;
  std::vector<SourceText> documents;
  RunResults results;
  std::vector<CheckResult> checks;
  std::vector<DivisionRecord> ambiguous = {};  // divisions across the longest extent of cells that have none
  std::string golden = {};                     // the accepted result's file; "" where there is none
  std::string change = {};                     // how the run differs from it, in words; "" where it does not
  std::string unusableGolden = {};             // why it cannot be read; ""
  std::unique_ptr<RunAgain> again = {};
  std::unique_ptr<BulletAgain> bullet = {};  // of a run made again whose scenario asks for it
  std::optional<BesideGolden> beside = {};   // drawn by drawBeside
};

/// Reads what is stored. Throws FileError if the record was changed.
RunFacts factsOf(Store& store, const StoredRun& run);

/// How `after` differs from `before`, as changeInWords says it; "" where it does not. Both are done.
std::string changeBetween(const RunFacts& before, const RunFacts& after);

/// Returns true if running it again shows something: bodies, and an end or a failure to reach.
bool canRunAgain(const RunFacts& facts);

/// Runs it again to where it ended, and keeps up to `frames` frames and, if asked, step hashes.
void runAgain(RunFacts& facts, const Execution& how, std::size_t frames, bool hashes, bool quiet);

/// For a run that was made again, came to its stored end and differs from its golden: draws `beside`, which runs the
/// golden's scenario.
void drawBeside(RunFacts& facts, const Execution& how, bool quiet);

}  // namespace morula
