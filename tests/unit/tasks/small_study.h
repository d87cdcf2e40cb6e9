#pragma once
// A study that takes some hundredths of a second, in a folder of its own.
#include "study/plan.h"
#include "study/study_file.h"
#include "tasks/merge.h"
#include "tasks/run_study.h"
#include "temporary_folder.h"

namespace morula {

inline const std::string smallScenario =
    "morula: 1\nname: tree\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\nstop: {cycles: 3}\n"
    "variation: {cycle: 0.05}\n";
inline const std::string smallStudy =
    "morula-study: 1\nname: trees\nbase: tree.yaml\nvary:\n"
    "  length: {usual: {}, long: {cycle.length: 2}}\n  vary: {yes: {}, no: {variation: null}}\n"
    "seeds: 1..3\nmeasures: [cells, generation]\n";

/// A study with one run of the scenario.
inline const std::string singleStudy = "morula-study: 1\nname: trees\nbase: tree.yaml\nseeds: [1]\nmeasures: [cells]\n";

/// Returns the file of a task's result.
inline std::filesystem::path fileOf(const PlannedStudy& study, std::size_t task) {
  return study.folder.task(study.plan.tasks[task].id);
}

struct SmallStudy {
  TemporaryFolder folder;
  explicit SmallStudy(const std::string& study = smallStudy, const std::string& scenario = smallScenario) {
    writeText(folder / "tree.yaml", scenario);
    writeText(folder / "trees.study.yaml", study);
  }
  PlannedStudy open(const std::string& to = "out") const {
    PlannedStudy planned =
        openStudy({(folder / "trees.study.yaml").string(), (folder / to).string()}, {.predict = false});
    keepPlan(planned);
    return planned;
  }
  RunStudyReport run(const PlannedStudy& study, std::vector<std::size_t> tasks = {}, int jobs = 1,
                     bool retryFailed = false) const {
    if (tasks.empty())
      for (std::size_t t = 0; t < study.plan.tasks.size(); ++t) tasks.push_back(t);
    return runStudy(study, {.tasks = tasks, .jobs = jobs, .retryFailed = retryFailed, .settings = {}, .quiet = true});
  }
};

}  // namespace morula
