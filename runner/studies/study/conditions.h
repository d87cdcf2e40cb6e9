#pragma once
// The conditions of a study: each combination of levels, with its scenario loaded and ready to run. Parts of a plan
// that follow from conditions, when it is made and when it is read.
#include <string>
#include <vector>

#include "simulation/simulation.h"
#include "study/plan.h"
#include "study/study_table.h"
#include "yaml/problems.h"

namespace morula::study {

/// Returns "division: longest, connections: none"; "the scenario as it is" without axes.
std::string conditionName(const Study& study, const std::vector<std::string>& labels);

/// Returns the number of combinations of levels that are run; counting ends at one more than `maxConditions`. Of more
/// than 100 times as many combinations none can be left out. An axis whose levels could not be read counts as one.
std::size_t countConditions(const Study& study);

/// Reads the scenario of a condition, whose labels, levels and base are set. `bytes`: content of `file`. Files that the
/// scenario names are taken from `files`, or else read from `folder`.
Scenario readConditionScenario(const Study& study, const Condition& condition, const std::string& bytes,
                               const std::string& file, const std::filesystem::path& folder,
                               const std::vector<NamedFile>& files);

/// Sets usesSeed and meaning.
void finish(Condition& condition, const Study& study);

/// Loads all conditions, or the first `most`. A mistake becomes one problem for all conditions that have it, and their
/// scenarios may then be missing. `warnings`: warnings of the scenarios, each once.
std::vector<Condition> loadConditions(const Study& study, scenario::Problems& problems,
                                      std::vector<std::string>& warnings, const Execution& execution, std::size_t most);

/// Returns the conditions of all combinations that are run, or of the first `most`, with number, labels, levels and
/// base. The levels of the last axis change fastest. None if the levels of an axis could not be read.
std::vector<Condition> conditionsOf(const Study& study, std::size_t most = maxConditions);

/// Makes tasks and replicates from the conditions.
void addTasks(Plan& plan);

/// Returns Plan::id for a plan that is otherwise complete.
std::string planId(const Plan& plan);

/// Makes files and places relative to the study's folder, so that a plan does not depend on the current folder.
void countFromFolder(Plan& plan);

}  // namespace morula::study
