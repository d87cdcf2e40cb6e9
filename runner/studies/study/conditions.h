#pragma once
// The conditions of a study: each combination of levels, with its scenario loaded and ready to run; and the same
// mistake in many of them, told once.
#include <map>
#include <set>
#include <string>
#include <vector>

#include "simulation/world.h"
#include "study/plan.h"
#include "yaml/problems.h"

namespace morula::study {

class ConditionMistakes {
 public:
  /// Lines as InputError has them, of one condition.
  void add(std::size_t condition, const std::string& lines);
  /// Each line once. If only some of `conditions` have it, the line names them, unless they are just those of the level
  /// at whose place in the study file it stands.
  void tell(const Study& study, const std::vector<Condition>& conditions, scenario::Problems& problems) const;

 private:
  struct Line {
    std::string text;
    std::set<std::size_t> conditions;
  };
  std::vector<Line> lines_;                     // in the order in which they came first
  std::map<std::string, std::size_t> numbers_;  // of each text in lines_
};

/// "division: longest, connections: none"; "the scenario as it is" without axes.
std::string conditionName(const Study& study, const std::vector<std::string>& labels);

/// How many combinations of levels there are; counting ends at one more than `mostConditions`.
std::size_t countConditions(const Study& study);

/// Reads the scenario of a condition, whose labels, levels and base are set. `bytes`: what `file` holds. A file that it
/// names is taken from `files`, or if it is not there read from `folder`.
Scenario readConditionScenario(const Study& study, const Condition& condition, const std::string& bytes,
                               const std::string& file, const std::filesystem::path& folder,
                               const std::vector<NamedFile>& files);

/// Sets usesSeed and meaning.
void finish(Condition& condition, const Study& study);

/// All of them, or the first `most`. What is wrong with one of them becomes a problem, and it may then be missing.
/// `warnings`: of the scenarios, each once.
std::vector<Condition> loadConditions(const Study& study, scenario::Problems& problems,
                                      std::vector<std::string>& warnings, const Execution& execution, std::size_t most);

/// Labels, levels and base of the condition of this number.
Condition conditionOf(const Study& study, std::size_t number);

}  // namespace morula::study
