#pragma once
// The conditions of a study: each combination of levels, with its scenario loaded and ready to run.
#include <functional>
#include <string>
#include <vector>

#include "simulation/world.h"
#include "study/plan.h"
#include "yaml/problems.h"

namespace morula::study {

/// [1] Of all axes together; at most one more than `mostConditions`.
std::size_t countConditions(const Study& study);

/// Reads the scenario of a condition, whose labels, levels and base are set, from bytes that are read already and files by role, or else from `folder`.
Scenario readConditionScenario(const Study& study, const Condition& condition, const std::string& bytes,
                               const std::string& file, const std::filesystem::path& folder,
                               const std::vector<NamedFile>& files);

/// Sets usesSeed and meaning.
void finish(Condition& condition, const Study& study);

/// All of them, or the first `most`. What is wrong with any becomes a problem; then some may be missing. `warnings`: of the
/// scenarios, each once.
std::vector<Condition> loadConditions(const Study& study, scenario::Problems& problems,
                                      std::vector<std::string>& warnings, const Execution& execution,
                                      std::size_t most);

/// Labels, levels and base of the condition of this number.
Condition conditionOf(const Study& study, std::size_t number);

}  // namespace morula::study
