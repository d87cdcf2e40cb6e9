#pragma once
// The parts of a page, one for each kind of source.
#include <memory>
#include <string>
#include <vector>

#include "check/beside_golden.h"
#include "report/report.h"
#include "report_data/explorer_data.h"
#include "report_data/run_words.h"

namespace morula {

struct PagePart {
  std::string title, summary;
  Document verdict = {};
  std::vector<PageSection> change = {};  // sections on changes, before the pictures
  std::vector<PageSection> sections = {};
  Json charts = Json::object();  // lines of charts, which the page's program draws
  bool isAside = false;          // true: it belongs to another part; its sections' titles name their subject
};

/// Makes the part on runs, with everything but their frames. Downloads take a tenth of `maxBytes`.
PagePart runPart(const std::vector<RunFacts>& runs, std::size_t maxBytes);

/// A scenario that failed its check, run again for its pictures.
struct FailedAgain {
  Scenario scenario;
  Simulation simulation;
  Frames frames;
  std::optional<BesideGolden> beside = {};  // pictures beside the accepted result
};

struct CheckedScenario {
  CheckReport report;
  std::string file;                    // the scenario's file; "" if unknown
  std::unique_ptr<FailedAgain> again;  // set for the first failed scenarios and those compared with Bullet
  std::unique_ptr<BulletAgain> bullet = {};
  bool isOtherNow = false;  // true: run again, or by its present golden, the result is not the checked one
};

/// Reads a report.json of `morula check --reports`. Throws InputError for other files.
std::vector<CheckedScenario> readChecked(const std::string& file);
/// Runs it again, if it can be read and its end is known.
void runCheckedAgain(CheckedScenario& checked, const ReportQuestion& question);
/// Runs up to `most` of those that failed again.
void runFailedAgain(std::vector<CheckedScenario>& checked, std::size_t most, const ReportQuestion& question);
PagePart checkPart(const std::vector<CheckedScenario>& checked, const std::string& file);

/// Makes the part on the output of `morula accuracy --json`. Throws InputError for other JSON.
PagePart accuracyPart(const std::string& file);

/// Makes the section on the running program, for pages without runs that tell their origin.
PageSection programSection();

}  // namespace morula
