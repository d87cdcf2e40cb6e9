#pragma once
// The facts of one run on a page: its rows in the database, its scenario and golden, and its repetitions in Morula and
// in Bullet, for the shapes that databases rarely keep.
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
  BulletFindings found;  // present findings of checkAgainstBullet
  Frames frames;         // empty unless Bullet reached the same end
};

/// Runs a scenario with check.bullet in Bullet. `ours`: Morula's world at its end. `most`: max number of frames, at
/// least 1, evenly spread in time; many vertices reduce it, so that the answer stays below maxFrameVertices.
std::unique_ptr<BulletAgain> runInBulletAgain(const Scenario& scenario, const World& ours, std::size_t most,
                                              bool quiet);

/// Converts Bullet's shapes to frames of a page. Contacts are not measured; velocities are those of the start.
Frames framesOf(const Scenario& scenario, const std::vector<ExternalFrame>& frames);

/// The relation of present findings to those stored with the run.
enum class BulletStored { none, same, other };
BulletStored compareWithStored(const std::vector<CheckResult>& found, const std::vector<CheckResult>& stored);

/// Returns "Bullet 3.24", the library that this program was built with.
std::string bulletName();

/// The repetition of a run from its record.
struct RunAgain {
  Simulation simulation;
  Frames frames;
  bool same = false;  // true: it ended in the stored state, bit for bit
};

struct RunFacts {
  std::string database;    // path as given
  std::string label = {};  // the condition of a study that it represents; "" for other runs
  std::string title = {};  // its title on its page
  StoredRun run;
  Scenario scenario;
  std::vector<SourceText> documents;
  RunResults results;
  std::vector<CheckResult> checks;
  std::vector<DivisionRecord> ambiguous = {};  // divisions across the longest extent of cells without a longest extent
  std::string golden = {};                     // file of the accepted result; "" if there is none
  std::string change = {};                     // differences from the golden, in words; "" if there are none
  std::string unusableGolden = {};             // the reason why the golden cannot be read; "" if it can
  std::unique_ptr<RunAgain> again = {};
  std::unique_ptr<BulletAgain> bullet = {};  // its run in Bullet, for a repeated run whose scenario asks for it
  std::optional<BesideGolden> beside = {};   // drawn by drawBeside
};

/// Reads the facts of a stored run. Throws FileError if the record was changed.
RunFacts factsOf(Store& store, const StoredRun& run);

/// Returns the differences of two finished runs in words [changeInWords]; "" if there are none.
std::string changeBetween(const RunFacts& before, const RunFacts& after);

/// Returns true if running the run again shows something: it has bodies, and an end or a failure to reach.
bool canRunAgain(const RunFacts& facts);

/// Runs it again to where it ended, and keeps up to `frames` frames and, if asked, step hashes.
void runAgain(RunFacts& facts, const Execution& how, std::size_t frames, bool hashes, bool quiet);

/// For a run that was made again, came to its stored end and differs from its golden: draws `beside`, which runs the
/// golden's scenario.
void drawBeside(RunFacts& facts, const Execution& how, bool quiet);

}  // namespace morula
