// morula study check: checks the claims of a study file against its results.

#include <algorithm>

#include "analysis/claims.h"
#include "analysis/study_comparison.h"
#include "analysis/study_state.h"
#include "base/error.h"
#include "files/content.h"
#include "files/folders.h"
#include "files/write_file.h"
#include "golden/ci_reports.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "study_verbs/study_verbs.h"
#include "system/console.h"

namespace morula::cli {
namespace {

struct CheckCommand {
  std::string study, reports;
  InputOptions input;
  OutputOptions output;
};

/// Returns the claims and the states of the runs as checks, for continuous integration.
CheckReport reportOf(const Study& study, const std::vector<ClaimFinding>& findings, const StudyState& state) {
  CheckReport report{study.name, checksOf(state, study.file)};
  for (const ClaimFinding& f : findings)
    report.results.push_back(
        judged({.check = f.claim, .kind = CheckKind::claim, .expected = f.claim, .actual = f.found}, f.holds,
               study.file + ':' + std::to_string(f.place.line) + ": " + f.found, FailureClass::claim));
  return report;
}

Json toJson(const Study& study, const std::vector<ClaimFinding>& findings, const StudyState& state) {
  Json json{
      {"study", study.name}, {"missing", state.counts.of(ResultState::missing)}, {"claims", claimsJson(findings)}};
  json.update(toJson(state));
  return json;
}

int act(const CheckCommand& command) {
  const bool isFile = isStudyFile(command.study);
  const auto database = databaseOf(command.study, command.input.allowOutside);
  const Study study = isFile ? loadStudy(command.study, command.input.allowOutside) : plannedStudy(database);
  if (study.claims.empty())
    throw InputError(study.file +
                     ": check: the study makes no claims to compare with the results; write some, as check: "
                     "[{measure: clone-radius, a: {division: longest}, b: {division: random}, says: lower}]");
  const StudyResults results = readStudyResults(database);
  const StudyState state = stateOf(results, study.allowed, isFile ? differenceFrom(database, study) : PlanDifference{});
  // Results that are stale may have other axes than the claims, which then cannot be checked.
  const auto findings = state.counts.of(ResultState::stale) && !canHold(results, study) ? std::vector<ClaimFinding>{}
                                                                                        : findClaims(results, study);
  const auto hold = std::size_t(std::ranges::count(findings, true, &ClaimFinding::holds));
  std::string text = study.name + ": " + std::to_string(hold) + " of " + counted(study.claims.size(), "claim") +
                     (hold == 1 ? " holds\n" : " hold\n");
  for (const ClaimFinding& f : findings)
    text += (f.holds ? "  ok    " : "  FAIL  ") + f.claim + "\n        " + f.found + '\n';
  if (const std::string counts = countsInWords(state); !counts.empty()) text += "  " + counts + '\n' + linesOf(state);
  printEither(command.output, toJson(study, findings, state), text);
  const std::vector<CheckReport> reports{reportOf(study, findings, state)};
  if (const std::filesystem::path folder = command.reports; !folder.empty()) {
    makeFolder(folder);
    writeFile(folder / "junit.xml", junitXml(reports), Content::report);
    writeFile(folder / "summary.md", summaryPage(reports), Content::report);
  }
  tellWorkflow(reports, command.output.json);
  return exitCodeOf(std::max(state.worst(), hold < study.claims.size() ? ResultState::differs : ResultState::fine));
}

}  // namespace

void addStudyCheck(CLI::App& study, Action& action) {
  Verb verb(study, action, "check",
            "Check the claims of a study file (its key check) against the results; exit code 1: a claim does not "
            "hold, or more runs failed or are insane than limits allow, or the results belong to another plan than "
            "the file's; 5: runs are missing");
  auto& command = verb.does<CheckCommand>(act);
  verb.needs("study", command.study, "FILE",
             "The study file, whose results lie in results/studies/NAME; or a merged study.db or its folder, with the "
             "claims that the file made when it was planned");
  verb.takes("--reports", command.reports, "FOLDER", "Folder for junit.xml and summary.md");
  add(verb, command.input);
  add(verb, command.output);
}

}  // namespace morula::cli
