#include "export/study_crate.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/claims.h"
#include "analysis/organisms.h"
#include "analysis/study_comparison.h"
#include "analysis/study_state.h"
#include "analysis/tidy.h"
#include "base/error.h"
#include "charts/small_multiples.h"
#include "database/database.h"
#include "export/methods.h"
#include "export/run_crate.h"
#include "files/printable.h"
#include "files/text.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

using Role = CrateFile::Role;

CrateFile derived(const std::string& path, const std::string& description, std::string content) {
  return {.path = path, .role = Role::result, .description = description, .content = std::move(content)};
}

/// Returns how many folders a relative path climbs above its start.
std::size_t climbs(const fs::path& path) { return std::size_t(std::ranges::count(path, fs::path(".."))); }

/// Describes when and by which command the runs were computed.
CrateAction actionOf(const StudyResults& r, const fs::path& database) {
  CrateAction action;
  action.name = "All runs of the study " + r.name;
  Database db(database.string(), Database::Mode::existing, std::chrono::seconds(30));
  Statement timing(db, "SELECT min(started), max(ended), min(command) FROM timing");
  timing.start();
  if (timing.next()) action.started = timing.text(0), action.ended = timing.text(1), action.command = timing.text(2);
  Statement plan(db, "SELECT plan_id FROM study");
  plan.start();
  if (plan.next()) action.identifier = plan.line(0);
  action.parameters = {{"conditions", std::to_string(r.conditions.size())}, {"seeds", std::to_string(r.seeds.size())}};
  action.results = {{"runs", r.counts().text()}};
  return action;
}

}  // namespace

StudyInputs inputsOf(const fs::path& database) {
  StudyInputs inputs;
  readStoredPlan(database, [&](const Json& plan) {
    const Json& study = plan.at("study");
    std::size_t up = 0;
    for (const Json& file : plan.at("files")) {
      const fs::path path = fs::path(file.at("path").get<std::string>()).lexically_normal();
      if (path.is_absolute())
        throw InputError(
            study.at("file").get<std::string>() + ": names '" + path.string() +
            "' by a path of this machine alone; name it from the scenario's folder, and run the study again");
      up = std::max(up, climbs(path));
    }
    fs::path folder = "study";
    for (std::size_t i = 0; i < up; ++i) folder /= "study";
    std::set<std::string> known;
    const auto add = [&](const fs::path& path, const std::string& description, const Json& content) {
      const std::string place = (folder / path).lexically_normal().generic_string();
      if (known.insert(place).second)
        inputs.files.push_back({.path = place,
                                .role = Role::object,
                                .description = description,
                                .alternateName = path.generic_string(),
                                .content = content.get<std::string>()});
      return place;
    };
    inputs.studyFile = add(safeName(study.at("file").get<std::string>(), "study.study.yaml"),
                           "The study file: what is varied, seeds, measures and claims", study.at("text"));
    for (const Json& file : plan.at("files"))
      add(file.at("path").get<std::string>(), describeRole(file.at("role").get<std::string>()), file.at("text"));
  });
  return inputs;
}

std::vector<CrateFile> derivedFiles(const fs::path& database) {
  const StudyComparison c = compareStudy(readStudyResults(database), {});
  const Units units = unitsOf(c.results, database);
  std::vector<CrateFile> files;
  std::string values;
  writeTidy(database, TidyRows::runs, [&](std::string_view line) { values += line; });
  files.push_back(derived("values.csv", "The values of all runs, one a line with the labels of all axes", values));
  files.push_back(derived("comparison.txt", "The comparison of the conditions: sentences and tables",
                          textOf(describe(inUnits(c, units)))));
  files.push_back(derived("comparison.json", "The comparison for programs", jsonText(toJson(c, units), 1) + '\n'));
  files.push_back(derived("comparison.csv", "The comparison as one table", toCsv(c)));
  const Study study = plannedStudy(database);
  if (!study.claims.empty())
    files.push_back(derived("claims.json", "The claims of the study file, and whether they hold",
                            jsonText(claimsJson(findClaims(c.results, study)), 1) + '\n'));
  const Methods methods = methodsOf(c, database);
  files.push_back(derived("methods.md", "A paragraph on the methods, for a paper", methods.text));
  files.push_back(derived("references.bib", "The sources that methods.md cites, in BibTeX", methods.references));
  return files;
}

Crate crateOfStudy(const fs::path& database) {
  const StudyComparison c = compareStudy(readStudyResults(database), {});
  const StudyResults& r = c.results;
  const Units units = unitsOf(r, database);
  const auto done = std::ranges::find(r.tasks, TaskStatus::done, &ResultTask::status);
  if (done == r.tasks.end())
    throw InputError("'" + database.string() + "': no run of the study is done, so there is nothing to export; " +
                     "`morula study status` tells why");
  auto store = Store::openForReading(database);
  Crate crate{.name = r.name + ": a study of Morula",
              .description = fmt::format("{}{}, {}, {}: {}.", r.summary.empty() ? "" : r.summary + ". ",
                                         counted(r.conditions.size(), "condition"), counted(r.seeds.size(), "seed"),
                                         counted(r.tasks.size(), "distinct run"), r.counts().text()),
              .run = store.find(done->runId),
              .action = actionOf(r, database),
              .agent = "",
              .license = "",
              .files = inputsOf(database).files};
  for (const SourceText& document : store.documents(done->runId))
    if (document.role == "diff")
      crate.files.push_back({.path = "program.diff",
                             .role = Role::about,
                             .description = "Changes of the program's sources since their commit",
                             .content = document.content});
  crate.files.push_back(
      {"study.db", Role::result, "All runs, values and the plan, in SQLite", database.string(), "", database});
  for (CrateFile& file : derivedFiles(database)) crate.files.push_back(std::move(file));
  crate.files.push_back(derived("figures/values.svg", "All values of each condition, their means and intervals",
                                drawSmallMultiples(stripsOf(c, units)).file(PictureFormat::svg)));
  if (const auto pictures = storedPictures(r, database)) {
    std::set<std::string> known;
    for (std::size_t k = 0; k < pictures->files.size(); ++k)
      if (const fs::path& file = pictures->files[k]; known.insert(file.string()).second)
        crate.files.push_back({"figures/" + safeName(file.string(), "picture"), Role::result,
                               "The organism at the end of " + r.nameOf(r.conditions[k]), "", "", file});
  }
  return crate;
}

void addReadme(Crate& crate, const fs::path& database) {
  const BuildInfo& build = crate.run.record.build;
  std::string text = fmt::format(
      "# {}\n\n{}\n\n## Repeat it\n\n```\nmorula study replay .\n```\n\nin this folder repeats two of the runs from the "
      "study file `{}`, and the comparison from the values in `study.db`, and says whether the bytes are the same "
      "(`--runs N` repeats more of them; exit code 1: something differs). Runs were computed by Morula {}, commit {} "
      "({}), build `{}`; that build gives the same bits on every machine."
      "\n\n## Files\n\n| file | holds |\n|---|---|\n",
      crate.name, crate.description, inputsOf(database).studyFile, build.version, build.gitCommit, build.gitState,
      buildId(build));
  for (const CrateFile& file : crate.files) text += fmt::format("| `{}` | {} |\n", file.path, file.description);
  text += "\n`ro-crate-metadata.json` describes all of them, with the XXH3-128 of their bytes (RO-Crate 1.1).\n";
  crate.files.insert(crate.files.begin(), {.path = "README.md",
                                           .role = Role::about,
                                           .description = "What this crate holds, and how to repeat it",
                                           .content = printable(text)});
}

}  // namespace morula
