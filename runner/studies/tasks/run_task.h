#pragma once
// One task: its run from beginning to end in a process of its own, and the file of its result.
// A study keeps one number of a run for each measure and time.
#include <map>
#include <string>
#include <vector>

#include "store/records.h"
#include "study_store/study_tables.h"
#include "study_store/task_file.h"
#include "system/forked.h"
#include "tasks/study_folder.h"

namespace morula {

struct TaskSettings {
  Execution execution;
  std::string command;  // as typed, for the record
};

/// Exit codes of a task's process besides 0 (its file is written) and 128 + the number of a signal. `undrawn`: its file
/// is written, but memory ran out for its picture.
enum TaskCode : int { cannotWrite = 6, brokeDown = 70, outOfMemory = 71, undrawn = 72 };

/// Computes the task and writes its file, and its picture if the study keeps one. The answer's text is the reason why
/// the run failed; "" if it did not. Does not throw.
ForkedAnswer runTask(const Plan& plan, std::size_t task, const StudyFolder& folder, const TaskSettings& settings);

/// Writes the file of a task whose process ended without one. Its result is the failure.
void writeFailure(const Plan& plan, std::size_t task, const StudyFolder& folder, const TaskSettings& settings,
                  FailureKind kind, const std::string& why, const ForkedEnd& end);

/// Returns true if the study keeps a picture of the task.
bool keepsPicture(const Plan& plan, std::size_t task);

/// Returns the measures' values in each sample: a measure of the world as it is; of cells, the mean over living cells
/// that have it; of pairs, the mean over pairs that touch; each limited to some cells if a measure says so. Values that
/// could not be measured have no row. `states`: the substances of each state in the samples. `measures`: names that
/// findMeasure knows; `scenario` says which cells they name.
std::vector<ResultRow> valuesOf(const std::vector<Sample>& samples, const std::map<StateId, std::string>& states,
                                const std::vector<std::string>& measures, const Scenario& scenario);

}  // namespace morula
