#pragma once
// A study's folder: the plan, a file for each task, the merged database.
#include <filesystem>
#include <optional>
#include <string>

#include "study/plan.h"

namespace morula {

class StudyFolder {
 public:
  explicit StudyFolder(std::filesystem::path path) : path_(std::move(path)) {}
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path tasks() const { return path_ / "tasks"; }
  std::filesystem::path task(const std::string& id) const { return tasks() / (id + ".db"); }
  std::filesystem::path pictures() const { return path_ / "pictures"; }
  /// "longest_none_seed-1_0123abcd.png": condition and seed that the task is first of, in letters that are safe in all
  /// names, and the beginning of its id, which says whether the picture is of this very run.
  std::filesystem::path picture(const Plan& plan, std::size_t task) const;
  /// The picture of the task with this id, whatever its condition is called by now; absent where there is none.
  std::optional<std::filesystem::path> storedPicture(const std::string& id) const;
  std::filesystem::path merged() const { return path_ / "study.db"; }

 private:
  std::filesystem::path path_;
};

struct PlannedStudy {
  StudyFolder folder;
  Plan plan;
  bool isNew = false;  // the folder has no plan yet, or another one that this one takes the place of
};

struct StudyChoice {
  std::string what;  // a study file, or a study's folder
  std::string to;    // the folder; "": results/studies/NAME, or `what` itself if it is one
  bool allowOutside = false;
  bool resume = false;       // go on with the folder's plan, whatever the file says by now
  bool update = false;       // plan anew what the file says by now; results that the new plan needs, too, stay
  bool mustBeThere = false;  // throws FileError where the folder has no plan
};

/// The plan of a folder, or that of a study file where the folder has none. Throws InputError for mistakes in the
/// study, and FileError: neither study nor folder, a plan that is damaged, a file that has changed since its plan was
/// made.
PlannedStudy openStudy(const StudyChoice& choice, const PlanOptions& options);

/// Throws FileError if this build has not computed the task's file: one build's results are compared with one another,
/// and a mixture would compare programs.
void requireOwnBuild(const std::filesystem::path& file);

/// Writes the plan of a new study into its folder, which is made if it is not there.
void keepPlan(const PlannedStudy& study);

}  // namespace morula
