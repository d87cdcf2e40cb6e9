#pragma once
// The same mistake in many conditions, told once.
#include <map>
#include <set>
#include <string>
#include <vector>

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

}  // namespace morula::study
