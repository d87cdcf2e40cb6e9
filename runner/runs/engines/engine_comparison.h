#pragma once
// Runs of scenarios in other engines, judged by the scenarios' own checks: `morula check --beside`.
#include <string>
#include <vector>

#include "engines/external_run.h"
#include "system/console.h"

namespace morula {

/// One engine's run of one scenario.
struct Verdict {
  enum class Kind {
    holds,     // all checks pass; of a scenario that must stop: it stops with the reason
    breaks,    // a check fails
    stops,     // cannot begin or go on where it should
    goesOn,    // runs to the end where it should stop
    noAnswer,  // hung or died
    notAsked,  // the engine cannot compute the scene
  };
  Kind kind = Kind::noAnswer;
  std::string text;  // for people: "breaks: volume from 0.9 to 3.2, not from 0.5 to 1.5, at step 50"
  std::optional<std::uint64_t> step;
};
/// Returns "holds", "breaks", "stops", "goes-on", "no-answer" or "not-asked".
const char* name(Verdict::Kind kind);

/// A scenario and the verdicts on it: first ours, then the engines' in the order of the options.
struct ComparisonRow {
  std::string scenario;  // "hard/needle"
  std::vector<Verdict> verdicts;
};

/// Parses "thesis,b1" as engines; "bullet" is b1 and b2. Throws InputError.
std::vector<Engine> parseEngines(const std::string& text);

/// Judges a run by the scenario's check.
Verdict judge(const CheckParameters& check, const ExternalRun& run);
/// Judges our run, by the report of `morula check`.
Verdict judge(const CheckParameters& check, const CheckReport& report);

struct ComparisonOptions {
  std::vector<Engine> engines;
  int cpuSeconds = usualCpuSeconds;
  bool quiet = false;
};

/// Runs all scenarios in all engines, with as many processes at a time as there are processors. `own`: our verdicts,
/// one for each scenario.
std::vector<ComparisonRow> compareEngines(const std::vector<Scenario>& scenarios, const std::vector<Verdict>& own,
                                          const ComparisonOptions& options);

/// Returns a Markdown table with a row for each scenario.
std::string comparisonTable(const std::vector<ComparisonRow>& rows, const std::vector<Engine>& engines);
/// Returns a list with an entry for each scenario and engine.
Json toJson(const std::vector<ComparisonRow>& rows, const std::vector<Engine>& engines);

}  // namespace morula
