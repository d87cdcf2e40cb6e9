// morula compare: what a study has found.
#include <memory>

#include "analysis/comparison.h"
#include "analysis/into_golden.h"
#include "analysis/organisms.h"
#include "analysis/picture.h"
#include "base/error.h"
#include "files/folders.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/picture_name.h"
#include "options/verb.h"
#include "pictures/pictures.h"
#include "study/plan.h"
#include "study_verbs/study_verbs.h"
#include "system/console.h"

namespace morula::cli {

namespace {

struct CompareCommand {
  std::string database, picture, organisms, intoGolden;
  CompareOptions options;
  bool csv = false;
  OutputOptions output;
};

/// A database, the folder of a study, or a study file.
std::filesystem::path databaseOf(const std::string& named) {
  std::filesystem::path file = named;
  if (file.extension() == ".yaml" || file.extension() == ".yml") file = studyFolder(loadStudy(file));
  else if (!isFolder(file)) return file;
  if (!fileExists(file / "study.db"))
    throw FileError((file / "study.db").string() + ": not there; morula study merge " + named + " makes it");
  return file / "study.db";
}

int act(const CompareCommand& command) {
  checkPictureName("compare", command.picture, true);
  checkPictureName("compare", command.organisms, false);
  if (command.csv && command.output.json)
    throw UsageError("--csv and --json are two forms; leave out one of them");
  const std::filesystem::path file = databaseOf(command.database);
  const StudyComparison comparison = compareStudy(readStudyResults(file), command.options);
  if (!command.intoGolden.empty()) writeIntoGolden(comparison, file, command.intoGolden);
  std::vector<std::string> pictures;
  if (!command.picture.empty()) {
    writePicture(drawComparedStudy(comparison), command.picture);
    pictures.push_back(command.picture);
  }
  if (!command.organisms.empty()) {
    writePicture(drawOrganisms(comparison.results, file, command.output.quiet), command.organisms);
    pictures.push_back(command.organisms);
  }
  if (command.csv) {
    print(toCsv(comparison));
  } else if (command.output.json) {
    Json json = toJson(comparison);
    if (!pictures.empty()) json["pictures"] = pictures;
    printJson(json);
  } else {
    std::string text = describe(comparison);
    for (const std::string& picture : pictures) text += "\npicture  " + picture;
    print(text + (pictures.empty() ? "" : "\n"));
  }
  return fine;
}

/// To the program or to `study`: the same verb.
void addCompareTo(CLI::App& above, Action& action) {
  auto command = std::make_shared<CompareCommand>();
  Verb verb(above, action, "compare",
            "Hold the conditions of a study against each other: what differs, and how surely");
  verb.needs("study", command->database, "FILE",
             "The study.db of morula study merge, the folder that it lies in, or the study file");
  verb.takes("--by", command->options.by, "AXIS,...",
             "Axes whose levels are compared, in the mean over the others; default: all");
  verb.takes("--measure", command->options.measures, "NAME,...", "Only these measures");
  verb.takes("--within", command->options.within,
             "Compare levels also at each level of the other axes that are compared");
  verb.takes("--equivalent", command->options.margins, "MARGIN,...",
             "Test whether differences stay within a margin (two one-sided tests): 0.01, 5% of the mean, "
             "sphericity=0.01");
  verb.takes("--csv", command->csv, "One table for other programs");
  verb.takes("-o,--output", command->picture, "FILE", "Also draw all values: a .png, .svg or .pdf");
  verb.takes("--organisms", command->organisms, "FILE",
             "Also draw one organism of each condition, by running it again: a .png");
  verb.takes("--into-golden", command->intoGolden, "SCENARIO",
             "Also write the differences of the first level of --by into the golden of this scenario, which "
             "the study varies");
  add(verb, command->output);
  verb.does([command] { return act(*command); });
}

}  // namespace

void addCompare(CLI::App& app, Action& action) { addCompareTo(app, action); }

void addStudyCompare(CLI::App& study, Action& action) { addCompareTo(study, action); }

}  // namespace morula::cli
