#pragma once
// The parts of a page, one for each kind of source.
#include <memory>
#include <string>
#include <vector>

#include "check/beside_golden.h"
#include "report/report.h"
#include "report_data/explorer_data.h"
#include "report_data/words.h"

namespace morula {

struct PagePart {
  std::string title, summary;
  Document verdict = {};
  std::vector<PageSection> change = {};  // what stands before the pictures
  std::vector<PageSection> sections = {};
  bool isAside = false;  // it belongs to another part; the titles of its sections say what they are of
};

/// Runs, with all that is known of them but their frames. Downloads take a tenth of `maxBytes`.
PagePart runPart(const std::vector<RunFacts>& runs, std::size_t maxBytes);

/// A scenario that failed its check, run again to be looked at.
struct FailedAgain {
  Scenario scenario;
  Simulation simulation;
  Frames frames;
  std::optional<BesideGolden> beside = {};  // and the accepted result
};

struct CheckedScenario {
  CheckReport report;
  std::string file;                    // of the scenario; "" where it is not known
  std::unique_ptr<FailedAgain> again;  // of the first failed ones, and those beside Bullet
  std::unique_ptr<BulletAgain> bullet = {};
  bool isOtherNow = false;  // run again, or held against the golden of now, it is another result than the one checked
};

/// A report.json of `morula check --reports`. Throws InputError for one that it did not write.
std::vector<CheckedScenario> readChecked(const std::string& file);
/// Runs it again, if it can be read and its end is known.
void runCheckedAgain(CheckedScenario& checked, const ReportQuestion& question);
/// Runs up to `most` of those that failed again.
void runFailedAgain(std::vector<CheckedScenario>& checked, std::size_t most, const ReportQuestion& question);
PagePart checkPart(const std::vector<CheckedScenario>& checked, const std::string& file);

/// Makes a part of what `morula accuracy --json` has printed. Throws InputError for other JSON.
PagePart accuracyPart(const std::string& file);

/// The program that makes the page, where no run says where it comes from.
PageSection programSection();

}  // namespace morula
