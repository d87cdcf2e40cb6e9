#include "tasks/study_folder.h"

#include <algorithm>

#include "base/error.h"
#include "files/folders.h"
#include "files/text.h"
#include "files/write_file.h"
#include "store/build_info.h"
#include "study/plan.h"
#include "study_store/task_file.h"

namespace morula {
namespace {

PlannedStudy openFolder(const StudyChoice& choice) {
  StudyFolder folder(choice.what);
  if (!choice.to.empty())
    throw FileError("'" + choice.what + "' is a folder, which holds the study's results itself; leave out --out " +
                    choice.to);
  if (!fileExists(planFile(folder.path())))
    throw FileError("'" + choice.what +
                    "' is not a study's folder, because it holds no plan.json; give a study file, from which "
                    "`morula study plan` makes a folder");
  Plan plan = loadPlan(folder.path());
  return {folder, std::move(plan), false};
}

[[noreturn]] void refuseOtherPlan(const Study& study, const Plan& now, const StudyFolder& folder) {
  const auto there = std::ranges::count_if(now.tasks, [&](const Task& t) { return fileExists(folder.task(t.id)); });
  throw FileError("'" + study.file + "' differs from the plan in '" + planFile(folder.path()).string() +
                  "', which was made from an older version; study run --update plans the study anew (" +
                  std::to_string(there) + " of its " + std::to_string(now.tasks.size()) +
                  " results exist and stay), --resume continues the existing plan, --out gives the changed study a "
                  "folder of its own");
}

constexpr std::size_t maxLetters = 40;  // max of a level's label in a name

std::string pictureEnd(const std::string& id) { return '_' + id.substr(0, 8) + ".png"; }

/// Removes characters that cause trouble in shells and on other systems.
std::string safeName(std::string label) {
  std::ranges::replace_if(
      label, [](char c) { return !isMadeOf(std::string(1, c), ".-"); }, '-');
  label.erase(0, label.find_first_not_of(".-"));
  return label.substr(0, maxLetters);
}

/// Throws if results that stay are of another build: with a new plan, the study could not go on by either build.
void requireOwnResults(const Plan& plan, const StudyFolder& folder) {
  for (const Task& task : plan.tasks)
    if (const auto file = folder.task(task.id); fileExists(file) && looksWhole(file))
      return requireOwnBuild(file);  // all results are of one build
}

}  // namespace

std::filesystem::path StudyFolder::picture(const Plan& plan, std::size_t task) const {
  const Task& t = plan.tasks[task];
  std::string name;
  for (const std::string& label : plan.conditions[t.condition].labels) name += safeName(label) + '_';
  return pictures() / (name + "seed-" + std::to_string(t.seed) + pictureEnd(t.id));
}

std::optional<std::filesystem::path> StudyFolder::storedPicture(const std::string& id) const {
  if (isFolder(pictures()))
    for (const std::filesystem::path& name : namesIn(pictures()))
      if (name.string().ends_with(pictureEnd(id))) return pictures() / name;
  return std::nullopt;
}

void requireOwnBuild(const std::filesystem::path& file) {
  const std::string theirs = TaskFile(file).buildId(), ours = buildId(buildInfo());
  if (theirs == ours) return;
  throw FileError("'" + file.string() + "' was computed by another build of the program (" + theirs + ", this is " +
                  ours + "); continue with that build, or give a new folder with --out");
}

PlannedStudy openStudy(const StudyChoice& choice, const PlanOptions& options) {
  if (isFolder(choice.what)) return openFolder(choice);
  const Study study = loadStudy(choice.what, choice.allowOutside);
  const StudyFolder folder(choice.to.empty() ? studyFolder(study) : std::filesystem::path(choice.to));
  if (fileExists(planFile(folder.path()))) {
    Plan there = loadPlan(folder.path());
    if (choice.resume) return {folder, std::move(there), false};
    PlanOptions how = options;
    how.predict = options.predict && choice.update;
    Plan now = makePlan(study, how);
    if (now.id == there.id) return {folder, std::move(there), false};
    if (!choice.update) refuseOtherPlan(study, now, folder);
    requireOwnResults(now, folder);
    return {folder, std::move(now), true};
  }
  if (choice.mustBeThere)
    throw FileError("'" + folder.path().string() + "' holds no plan.json: nothing of '" + choice.what +
                    "' has been run in this folder; run it with `morula study run`, or name another folder with "
                    "--out");
  return {folder, makePlan(study, options), true};
}

void keepPlan(const PlannedStudy& study) {
  makeFolder(study.folder.tasks());
  if (study.plan.study.keep.pictures != PicturesKept::none) makeFolder(study.folder.pictures());
  if (study.isNew) overwriteFile(planFile(study.folder.path()), writePlan(study.plan));
}

}  // namespace morula
