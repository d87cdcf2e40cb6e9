// morula study export: one crate of a whole study, and its methods.
#include "analysis/study_comparison.h"
#include "analysis/study_state.h"
#include "base/error.h"
#include "export/methods.h"
#include "export/study_crate.h"
#include "export/zip.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "files/scratch_folder.h"
#include "files/text.h"
#include "files/write_file.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "report/report.h"
#include "report/study_part.h"
#include "study_verbs/study_verbs.h"
#include "system/console.h"
#include "system/installation.h"

namespace morula::cli {

namespace fs = std::filesystem;

namespace {

struct ExportCommand {
  std::string study, out, methods, agent, license;
  bool noPage = false;
  InputOptions input;
  ExecutionOptions execution;
  OutputOptions output;
};

/// Throws InputError with the remedy unless the database is a merged study whose runs all have a result. Returns words on
/// runs that are not fine; "" if all are.
std::string requireWhole(const fs::path& database, const ExportCommand& command) {
  const bool isFile = isStudyFile(command.study);
  if (!isMergedStudy(database.string()))
    throw InputError("'" + database.string() + "' holds runs of no study; `" + programWord() + " export " +
                     shellWord(database.string()) + " --ro-crate FOLDER` makes a crate of one run, and `" +
                     programWord() + " study merge` a study.db of all runs of a study");
  const Study now = isFile ? loadStudy(command.study, command.input.allowOutside) : Study{};
  const StudyResults results = readStudyResults(database);
  const StudyState state = stateOf(results, isFile ? now.allowed : results.allowed,
                                   isFile ? differenceFrom(database, now) : PlanDifference{});
  const std::string remedy = programWord() + " study run " + shellWord(command.study);
  if (state.counts.of(ResultState::stale))
    throw InputError(command.study + ": the study has changed since its runs were computed; run `" + remedy +
                     " --update`, or name " + database.string() + " to export what they were computed from\n" +
                     linesOf(state));
  if (const std::size_t missing = state.counts.of(ResultState::missing))
    throw InputError(command.study + ": " + std::to_string(missing) + " of " + std::to_string(state.counts.all()) +
                     " runs have no result; compute them by `" + remedy + " --resume`, then export the study");
  const std::string counts = countsInWords(state);
  return counts.empty() ? "" : counts + '\n' + linesOf(state);
}

CrateFile pageOf(const fs::path& database, const ExportCommand& command) {
  ReportQuestion question;
  question.what = {database.string()};
  question.execution = execution(command.execution);
  question.quiet = command.output.quiet;
  findExplorer(question);
  ReportAnswer page = makeReport(question);
  for (const std::string& remark : page.remarks) tell("page: " + remark, command.output.quiet);
  return {.path = "report.html",
          .role = CrateFile::Role::result,
          .description = "A page of the study: findings, values, organisms, provenance",
          .content = std::move(page.bytes)};
}

/// Writes the crate as a folder, or as a zip with the folder NAME in it.
void write(const Crate& crate, const fs::path& target) {
  if (target.extension() != ".zip") {
    DraftFolder draft(target);
    writeCrate(crate, draft.path());
    return draft.takePlace();
  }
  requireNewFile(target);
  const ScratchFolder scratch(target.parent_path());
  writeCrate(crate, scratch.path());
  std::vector<std::pair<std::string, std::string>> files;
  for (const fs::path& file : everyFileBelow(scratch.path()))
    files.emplace_back((target.stem() / file.lexically_relative(scratch.path())).generic_string(),
                       readFile(file, std::uint64_t{1} << 32));
  writeNewFile(target, zipOf(files, "give a folder as --out"));
}

int act(const ExportCommand& command) {
  const fs::path database = databaseOf(command.study, command.input.allowOutside);
  const bool wantsCrate = !command.out.empty() || command.methods.empty();
  const fs::path target = command.out.empty() ? database.parent_path() / "crate" : fs::path(command.out);
  const fs::path text = command.methods, references = fs::path(text).replace_extension(".bib");
  if (!text.empty() && text == references)
    throw UsageError("--methods: needs a name that does not end in .bib, as methods.md");
  if (!text.empty()) requireNewFile(text), requireNewFile(references);
  const std::string notFine = requireWhole(database, command);
  if (wantsCrate && target.extension() == ".zip") requireNewFile(target);
  else if (wantsCrate) requireAbsent(target);
  if (!notFine.empty()) tell(notFine, command.output.quiet);

  std::vector<std::string> written;
  Json json{{"study", readStudyResults(database).name}};
  if (!text.empty()) {
    const Methods methods = methodsOf(compareStudy(readStudyResults(database), {}), database);
    writeNewFile(text, methods.text);
    writeNewFile(references, methods.references);
    written = {text.string(), references.string()};
  }
  if (wantsCrate) {
    Crate crate = crateOfStudy(database);
    crate.agent = command.agent, crate.license = command.license;
    if (!command.noPage) crate.files.push_back(pageOf(database, command));
    addReadme(crate, database);
    write(crate, target);
    if (command.license.empty()) tell(noLicence, command.output.quiet);
    json["crate"] = target.string(), json["files"] = crate.files.size();
    written.push_back(target.string() + " (" + std::to_string(crate.files.size()) +
                      " files and ro-crate-metadata.json)");
  }
  json["written"] = written;
  printEither(command.output, json, join(written, "\n") + '\n');
  return fine;
}

}  // namespace

void addStudyExport(CLI::App& study, Action& action) {
  Verb verb(study, action, "export",
            "Write one RO-Crate of a whole study, from which study replay repeats it to the byte");
  auto& command = verb.does<ExportCommand>(act);
  verb.needs("study", command.study, "FILE|DIR", "A merged study.db, the folder that it lies in, or the study file");
  verb.takes("--out", command.out, "FOLDER|ZIP", "A new folder, or a new .zip; default: crate beside study.db");
  verb.takes("--methods", command.methods, "FILE",
             "Write the methods as a paragraph for a paper, and its sources in BibTeX beside it (.bib); without --out "
             "these alone");
  verb.takes("--no-page", command.noPage, "Leave out the page, for which some runs are repeated");
  verb.takes("--agent", command.agent, "WHO", "Person who ran the study: a name, or a URI such as an ORCID");
  verb.takes("--license", command.license, "LICENCE", licenseUri,
             "The results' licence: an SPDX identifier, as CC-BY-4.0, or a URI");
  add(verb, command.input);
  add(verb, command.execution);
  add(verb, command.output);
}

}  // namespace morula::cli
