#pragma once
// A study on a page: its verdicts, every value of every condition, and one organism of each.
#include <string>
#include <vector>

#include "analysis/comparison.h"
#include "report/parts.h"

namespace morula {

/// Whether the database is a merged study.
bool isMergedStudy(const std::string& database);

PagePart studyPart(const std::string& database);

/// Adds the organisms of all conditions at five moments, which runs one of each again; of more than twelve conditions the command
/// that draws them. Nothing of a study without bodies. Returns the signal that interrupted it, or 0.
int addOrganisms(PagePart& part, const std::string& database, bool quiet);

/// What its verdict says. `database`: the merged study that `comparison` is of.
std::vector<Finding> findingsOf(const StudyComparison& comparison, const std::string& database);

struct Representative {
  std::string condition, run;  // its name, the run's id
};
/// The first run that is done of each of the first `most` conditions that have one; equal runs once.
std::vector<Representative> representativesOf(const std::string& database, std::size_t most);

}  // namespace morula
