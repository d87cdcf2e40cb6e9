#pragma once
// Changes from one golden to the next, for the acceptance and for reviewers.
#include <string>
#include <vector>

#include "golden/golden.h"

namespace morula {

/// Returns the observed data, in which each value within its tolerance of the old golden keeps the old text, byte for
/// byte. A golden's diff then shows only real changes.
GoldenData keepValuesWithinTolerance(GoldenData observed, const Golden& old);

/// Returns the golden's rules, each limited to steps before the chaos horizon of its tolerance. A rule that then
/// matches no value is dropped. Adds to `notes`, for people, each change.
std::vector<ToleranceRule> limitToHorizon(const Golden& golden, std::vector<std::string>& notes);

/// Lists the values of the golden for which `golden`'s rules allow more than `before`'s did: a line for each pair of
/// new and old rule. Empty if nothing is looser.
std::vector<std::string> loosenedTolerances(const Golden& before, const Golden& golden);

/// Lists the items that only the golden or only the observed data has, and changed items: lineage, bits, values, tables
/// and others. Each heading has a count and up to nine lines. "" if there are none.
std::string describeGoldenDiff(const Golden& golden, const GoldenData& observed);

}  // namespace morula
