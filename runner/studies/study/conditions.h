#pragma once
// The conditions of a study: each combination of levels, with its scenario loaded and ready to run; and what follows
// from them when a plan is made, and when it is read.
#include <string>
#include <vector>

#include "simulation/world.h"
#include "study/plan.h"
#include "yaml/problems.h"

namespace morula::study {

/// "division: longest, connections: none"; "the scenario as it is" without axes.
std::string conditionName(const Study& study, const std::vector<std::string>& labels);

/// How many combinations of levels there are; counting ends at one more than `maxConditions`.
std::size_t countConditions(const Study& study);

/// Reads the scenario of a condition, whose labels, levels and base are set. `bytes`: what `file` holds. A file that it
/// names is taken from `files`, or if it is not there read from `folder`.
Scenario readConditionScenario(const Study& study, const Condition& condition, const std::string& bytes,
                               const std::string& file, const std::filesystem::path& folder,
                               const std::vector<NamedFile>& files);

/// Sets usesSeed and meaning.
void finish(Condition& condition, const Study& study);

/// All of them, or the first `most`. What is wrong with one of them becomes a problem, told once for all that have it,
/// and it may then be missing. `warnings`: of the scenarios, each once.
std::vector<Condition> loadConditions(const Study& study, scenario::Problems& problems,
                                      std::vector<std::string>& warnings, const Execution& execution, std::size_t most);

/// Labels, levels and base of the condition of this number.
Condition conditionOf(const Study& study, std::size_t number);

/// Tasks and replicates, from the conditions.
void addTasks(Plan& plan);

/// Plan::id, of a plan that is otherwise complete.
std::string planId(const Plan& plan);

/// Makes files and places relative to the study's folder, so that a plan is the same wherever it was made from.
void countFromFolder(Plan& plan);

}  // namespace morula::study
