#pragma once
// accuracy --target: the cheapest settings for an error, as a command that has been run to its end.
#include <string>
#include <vector>

#include "accuracy/accuracy.h"

namespace morula {

struct TargetQuestion {
  double error = 0;              // max error of the settings
  std::string file;              // the scenario, as it was given
  std::vector<std::string> set;  // requested changes: "path=value"
  std::string seed;              // "": the scenario's
  double budget = 120;           // [s] max CPU time of all runs to the end
  std::string program, folder;   // the program that runs, and the folder for its temporary results
  ReadScenario read;
  std::function<void(const std::string&)> tell;
};

/// A command that has been run to its end.
struct EndedRun {
  std::vector<std::string> command;  // "run", file, …
  Setting setting;
  double error = 0;       // error on the setting's mesh; for another level an estimate of the whole error
  double cpuSeconds = 0;  // CPU time of the whole run
};

struct TargetAnswer {
  std::optional<EndedRun> best;                 // on the scenario's mesh, or a coarser one within the error
  std::optional<EndedRun> finer;                // set if the error of the scenario's mesh alone is too large
  std::optional<std::uint64_t> levelThatHolds;  // the coarsest icosphere whose own error leaves room
  std::vector<std::string> failures;            // failures of cheaper settings, one line each
  bool outOfTime = false;                       // true: the budget was used up before a run had ended
};

TargetAnswer findTarget(const AccuracyReport& report, const TargetQuestion& question);

/// Describes the answer for people.
std::string describe(const TargetAnswer& answer, const TargetQuestion& question, const AccuracyReport& report);
Json toJson(const TargetAnswer& answer, const TargetQuestion& question, const AccuracyReport& report);

}  // namespace morula
