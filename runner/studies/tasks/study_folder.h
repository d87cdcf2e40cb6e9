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
  /// Returns "longest_none_seed-1_0123abcd.png": the task's first condition and seed, in letters that are safe in all
  /// names, and the beginning of its id, which identifies the run.
  std::filesystem::path picture(const Plan& plan, std::size_t task) const;
  /// Returns the picture of the task with this id, whatever its condition is called now; absent if there is none.
  std::optional<std::filesystem::path> storedPicture(const std::string& id) const;
  std::filesystem::path merged() const { return path_ / "study.db"; }

 private:
  std::filesystem::path path_;
};

struct PlannedStudy {
  StudyFolder folder;
  Plan plan;
  bool isNew = false;  // the folder has no plan yet, or another plan that this plan replaces
};

struct StudyChoice {
  std::string what;  // path of a study file or of a study's folder
  std::string to;    // the folder; "": results/studies/NAME, or `what` itself if it is a folder
  bool allowOutside = false;
  bool resume = false;       // continue the folder's plan, whatever the file says now
  bool update = false;       // make a new plan from the file; results that it also needs stay
  bool mustBeThere = false;  // throws FileError if the folder has no plan
};

/// Returns the plan of a folder, or else of a study file. Throws InputError for mistakes in the study. Throws FileError
/// for neither study nor folder, for a damaged plan, and for a file that has changed since its plan was made.
PlannedStudy openStudy(const StudyChoice& choice, const PlanOptions& options);

/// Throws FileError if another build has computed the task's file: comparisons across builds would compare programs.
void requireOwnBuild(const std::filesystem::path& file);

/// Writes the plan of a new study into its folder, which is made if it is not there.
void keepPlan(const PlannedStudy& study);

}  // namespace morula
