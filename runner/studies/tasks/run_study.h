#pragma once
// Runs all tasks of a study, or a share of them: each in a process of its own, several at a time.
#include <cstddef>
#include <string>
#include <vector>

#include "system/json.h"
#include "tasks/run_task.h"

namespace morula {

struct RunStudyOptions {
  std::vector<std::size_t> tasks;  // numbers of the tasks to run
  int jobs = 1;
  bool retryFailed = false;  // tasks whose result is a failure, or whose picture is missing, are computed again
  TaskSettings settings;
  bool quiet = false;
};

struct FailedTask {
  std::size_t task = 0;
  std::string reason;
};

/// The outcome of the tasks that were asked for.
struct RunStudyReport {
  std::size_t asked = 0, already = 0, computed = 0;  // computed: including failures
  std::vector<FailedTask> failed;                    // failures that were computed now, by number
  std::vector<FailedTask> stopped;                   // by other programs: without a result, to be run again
  std::vector<FailedTask> undrawn;                   // with a result, but without a picture: memory ran out
  std::size_t left = 0;                              // not begun, because a signal came
  int signal = 0;                                    // the signal that stopped the study
  double seconds = 0, cpuSeconds = 0;                // [s]

  bool isComplete() const { return already + computed == asked; }
};

/// Runs the tasks that have no whole file yet, and removes leftovers of processes that died. Requires that the process
/// has one thread. Throws FileError if a result cannot be written, or if there are results of another build of the
/// program.
RunStudyReport runStudy(const PlannedStudy& study, const RunStudyOptions& options);

/// Describes a report for people: one line of counts, and one for each task that failed or was stopped.
std::string describe(const RunStudyReport& report, const PlannedStudy& study);
Json toJson(const RunStudyReport& report, const PlannedStudy& study);

/// Returns the first twenty lines, and how many more there are.
std::string firstOf(const std::vector<std::string>& lines);
/// Writes a line for each task, "  missing  NAME" and `remark`: for as many as firstOf shows, or for all with their
/// reasons.
std::string taskLines(const std::string& what, const std::vector<std::size_t>& tasks, const Plan& plan,
                      const std::string& remark = "");
std::string taskLines(const std::string& what, const std::vector<FailedTask>& tasks, const Plan& plan,
                      const std::string& remark = "");
/// Writes tasks as JSON: id, condition, seed and reason.
Json toJson(const std::vector<std::size_t>& tasks, const Plan& plan);
Json toJson(const std::vector<FailedTask>& tasks, const Plan& plan);

/// Returns "12 done", "12 done, 2 of them not sane".
std::string doneInWords(std::size_t done, std::size_t insane);

/// Returns "division: longest, connections: none, seed 4 (task 0123456789abcdef)".
std::string nameOfTask(const Plan& plan, std::size_t task);

/// The tasks number, number + of, number + 2·of, … of the plan, counted from 1. The plan alone decides, so machines
/// need not communicate. Consecutive tasks belong to one condition, cost about the same, and are in different shards.
struct Shard {
  std::size_t number = 1, of = 1;  // from 1
};

/// Parses "3/40". Throws InputError.
Shard parseShard(const std::string& text);

/// Returns the shard's tasks among 0 to count − 1, rising.
std::vector<std::size_t> tasksOf(const Shard& shard, std::size_t count);

}  // namespace morula
