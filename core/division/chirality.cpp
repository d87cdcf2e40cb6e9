// Which divisions have chirality.
#include <algorithm>

#include "division/rules.h"

namespace morula {

std::optional<Chirality> chiralityOf(const DivisionParameters& p, const std::string& substances) {
  const DivisionRule* rule = ruleFor(p, substances);
  return rule && rule->chirality ? rule->chirality : p.chirality;
}

double longestChirality(const DivisionParameters& p) {
  double longest = p.chirality ? p.chirality->time : 0;
  for (const DivisionRule& rule : p.rules)
    if (rule.chirality) longest = std::max(longest, rule.chirality->time);
  return longest;
}

}  // namespace morula
