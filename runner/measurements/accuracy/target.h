#pragma once
// accuracy --target: the cheapest settings that hold an error, as a command that has been run to its end.
#include <string>
#include <vector>

#include "accuracy/accuracy.h"

namespace morula {

struct TargetQuestion {
  double error = 0;              // that settings must hold
  std::string file;              // the scenario, as it was given
  std::vector<std::string> set;  // changes that were asked for: "path=value"
  std::string seed;              // "": the scenario's
  double budget = 120;           // [s] of CPU time, for all runs to the end
  std::string program, folder;   // that runs, and where its results may lie meanwhile
  ReadScenario read;
  std::function<void(const std::string&)> tell;
};

/// A command that has been run to its end.
struct EndedRun {
  std::vector<std::string> command;  // "run", file, …
  Setting setting;
  double error = 0;       // on the setting's mesh; of another level estimated for the whole
  double cpuSeconds = 0;  // of the whole run
};

struct TargetAnswer {
  std::optional<EndedRun> best;                 // on the scenario's mesh, or a coarser one that still holds the error
  std::optional<EndedRun> finer;                // where the scenario's mesh alone exceeds the error
  std::optional<std::uint64_t> levelThatHolds;  // the coarsest icosphere whose own error leaves room
  std::vector<std::string> failures;            // of cheaper ones, one line each
  bool outOfTime = false;                       // the budget was used up before one had come to its end
};

TargetAnswer findTarget(const AccuracyReport& report, const TargetQuestion& question);

/// Describes the answer for people.
std::string describe(const TargetAnswer& answer, const TargetQuestion& question, const AccuracyReport& report);
Json toJson(const TargetAnswer& answer, const TargetQuestion& question, const AccuracyReport& report);

}  // namespace morula
