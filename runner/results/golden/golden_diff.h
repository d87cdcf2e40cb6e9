#pragma once
// From one golden to the next: what stays, what is limited, and what a reviewer must see.
#include <string>
#include <vector>

#include "golden/golden.h"

namespace morula {

/// The observed data, in which each value that lies within its tolerance of the old golden keeps the old
/// text, byte for byte: a golden's diff then shows only what really changed.
GoldenData keepValuesWithinTolerance(GoldenData observed, const Golden& old);

/// The rules, each ending before the chaos horizon of its tolerance where values lie beyond; a rule to which
/// no value is left is dropped. Says in `notes`, for people, what it did.
std::vector<ToleranceRule> limitToHorizon(const Golden& golden, std::vector<std::string>& notes);

/// Values of the golden for which `golden`'s rules allow more than `before`'s did: one line per rule and for
/// those under no rule any more; empty if nothing is looser.
std::vector<std::string> loosenedTolerances(const Golden& before, const Golden& golden);

/// Lists the golden's items that the observed data lacks or has more of, changed lineage lines and changed bits: each
/// heading with a count and up to nine lines. "" if there is nothing.
std::string describeGoldenDiff(const Golden& golden, const GoldenData& observed);

}  // namespace morula
