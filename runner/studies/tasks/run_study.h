#pragma once
// All tasks of a study, or a share of them: each in a process of its own, several at a time.
#include <cstddef>
#include <string>
#include <vector>

#include "system/json.h"
#include "tasks/run_task.h"

namespace morula {

struct RunStudyOptions {
  std::vector<std::size_t> tasks;  // which, by number
  int jobs = 1;
  bool retryFailed = false;  // tasks whose result is a failure, or whose picture is missing, are computed once more
  TaskSettings settings;
  bool quiet = false;
};

struct FailedTask {
  std::size_t task = 0;
  std::string reason;
};

/// The outcome of the tasks that were asked for.
struct RunStudyReport {
  std::size_t asked = 0, already = 0, computed = 0;  // computed: with those that failed
  std::vector<FailedTask> failed;                    // of those that were computed now, by number
  std::vector<FailedTask> stopped;                   // from outside: they have no result, and will be run again
  std::vector<FailedTask> undrawn;                   // they have a result, and no picture: there was no memory for it
  std::size_t left = 0;                              // not begun, because a signal came
  int signal = 0;                                    // that stopped all of it
  double seconds = 0, cpuSeconds = 0;                // [s]

  bool isComplete() const { return already + computed == asked; }
};

/// Runs those tasks that have no whole file yet, and removes what processes that died have left. Has to be called while
/// the process has one thread. Throws FileError if a result cannot be written, or if results are there that another
/// build of the program has computed.
RunStudyReport runStudy(const PlannedStudy& study, const RunStudyOptions& options);

/// Describes a report for people: one line of counts, and one for each task that failed or was stopped.
std::string describe(const RunStudyReport& report, const PlannedStudy& study);
Json toJson(const RunStudyReport& report, const PlannedStudy& study);

/// The first twenty lines of many, and how many more there are.
std::string firstOf(const std::vector<std::string>& lines);
/// Writes a line for each task, "  missing  NAME" and what follows it: for as many as firstOf tells, or for all with
/// their reasons.
std::string taskLines(const std::string& what, const std::vector<std::size_t>& tasks, const Plan& plan,
                      const std::string& remark = "");
std::string taskLines(const std::string& what, const std::vector<FailedTask>& tasks, const Plan& plan,
                      const std::string& remark = "");
/// Writes tasks as JSON: id, condition, seed and reason.
Json toJson(const std::vector<std::size_t>& tasks, const Plan& plan);
Json toJson(const std::vector<FailedTask>& tasks, const Plan& plan);

/// "12 done", "12 done, 2 of them not sane"
std::string doneInWords(std::size_t done, std::size_t insane);

/// "division: longest, connections: none, seed 4 (task 0123456789abcdef)"
std::string nameOfTask(const Plan& plan, std::size_t task);

/// The tasks number, number + of, number + 2·of, … of the plan, counted from 1. The plan alone decides, so machines
/// need not communicate. Consecutive tasks, which belong to one condition and cost about the same, are in different
/// shards.
struct Shard {
  std::size_t number = 1, of = 1;  // number: from 1
};

/// "3/40". Throws InputError.
Shard parseShard(const std::string& text);

/// Returns the shard's tasks among 0 to count − 1, rising.
std::vector<std::size_t> tasksOf(const Shard& shard, std::size_t count);

}  // namespace morula
