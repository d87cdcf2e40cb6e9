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
    holds,     // all that the check demands; of a scenario that must stop: it stops and says why
    breaks,    // something of it
    stops,     // cannot begin or go on where it should
    goesOn,    // to the end where it should stop
    noAnswer,  // hung or died
    notAsked,  // the engine has no such thing
  };
  Kind kind = Kind::noAnswer;
  std::string text;  // for people: "breaks: volume from 0.9 to 3.2, not from 0.5 to 1.5, at step 50"
  std::optional<std::uint64_t> step;
};
/// "holds", "breaks", "stops", "goes-on", "no-answer", "not-asked".
const char* name(Verdict::Kind kind);

/// A scenario and what was found of it: first ours, then the engines in the order in which they were asked for.
struct ComparisonRow {
  std::string scenario;  // "hard/needle"
  std::vector<Verdict> verdicts;
};

/// "thesis,b1" as engines; "bullet" is b1 and b2. Throws InputError.
std::vector<Engine> parseEngines(const std::string& text);

/// Judges a run by the check.
Verdict judge(const CheckParameters& check, const ExternalRun& run);
/// Ours, from what `morula check` found.
Verdict judge(const CheckParameters& check, const CheckReport& report);

struct ComparisonOptions {
  std::vector<Engine> engines;
  int cpuSeconds = usualCpuSeconds;
  bool quiet = false;
};

/// Asks all engines for all scenarios, as many processes at a time as there are processors. `own`: ours, one
/// for each scenario.
std::vector<ComparisonRow> compareEngines(const std::vector<Scenario>& scenarios, const std::vector<Verdict>& own,
                                          const ComparisonOptions& options);

/// A Markdown table, a row for each scenario.
std::string comparisonTable(const std::vector<ComparisonRow>& rows, const std::vector<Engine>& engines);
/// A list with a row for each scenario and engine.
Json toJson(const std::vector<ComparisonRow>& rows, const std::vector<Engine>& engines);

}  // namespace morula
