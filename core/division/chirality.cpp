// Which divisions have chirality.
#include <algorithm>

#include "biology/substance_pattern.h"
#include "division/parameters.h"

namespace morula {

std::optional<Chirality> chiralityOf(const DivisionParameters& p, const std::string& substances) {
  const auto isFor = [&](const DivisionRule& rule) {
    return std::ranges::all_of(rule.of,
                               [&](const std::string& pattern) { return fitsAny(pattern, substances); });
  };
  const auto rule = std::ranges::find_if(p.rules, isFor);
  return rule != p.rules.end() && rule->chirality ? rule->chirality : p.chirality;
}

double longestChirality(const DivisionParameters& p) {
  double longest = p.chirality ? p.chirality->time : 0;
  for (const DivisionRule& rule : p.rules)
    if (rule.chirality) longest = std::max(longest, rule.chirality->time);
  return longest;
}

}  // namespace morula
