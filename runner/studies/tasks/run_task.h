#pragma once
// One task: its run from beginning to end, and the file of its result. Each is computed in a process of its own.
// A study keeps of a run one number for each measure and time.
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

/// Exit codes of a task's process. Others: 0 (its file is written) and 128 + the number of a signal. `undrawn`: its
/// file is written, and there was no memory for its picture.
enum TaskCode : int { cannotWrite = 6, brokeDown = 70, outOfMemory = 71, undrawn = 72 };

/// Computes the task and writes its picture, if the study keeps one of it, and its file; the answer's text is then why
/// the run failed, "" if it did not. Does not throw.
ForkedAnswer runTask(const Plan& plan, std::size_t task, const StudyFolder& folder, const TaskSettings& settings);

/// Writes the file of a task whose process ended without one: its result is the failure.
void writeFailure(const Plan& plan, std::size_t task, const StudyFolder& folder, const TaskSettings& settings,
                  FailureKind kind, const std::string& why, const ForkedEnd& end);

/// Returns true if the study keeps a picture of the task.
bool keepsPicture(const Plan& plan, std::size_t task);

/// The measures' values in each of the samples: a measure of the world as it is; of cells, the mean over the living
/// cells that have it; of pairs, the mean over the pairs that touch; of some cells alone where a measure says so. No
/// row where there was nothing to measure. `states`: the substances of each state in the samples. `measures`: names
/// that findMeasure knows.
std::vector<ResultRow> valuesOf(const std::vector<Sample>& samples, const std::map<StateId, std::string>& states,
                                const std::vector<std::string>& measures);

}  // namespace morula
