#pragma once
// The part of a page on a study: its verdicts, every value of every condition, and an organism of each.
#include <string>
#include <vector>

#include "analysis/study_comparison.h"
#include "report/page_parts.h"

namespace morula {

/// Returns true if the database is a merged study.
bool isMergedStudy(const std::string& database);

PagePart studyPart(const std::string& database);

/// Adds the pictures that the study keeps of all conditions; otherwise their organisms at five moments, which runs one
/// of each again, or of more than twelve conditions the command that draws them. Nothing of a study without bodies.
void addOrganisms(PagePart& part, const std::string& database, bool quiet);

/// Returns the findings of a comparison. `database`: its merged study.
std::vector<Finding> findingsOf(const StudyComparison& comparison, const std::string& database);

struct Representative {
  std::string condition, run;  // name of the condition, id of the run
  std::uint64_t seed = 0;
  std::string name() const { return condition + ", seed " + std::to_string(seed); }
};
/// Returns all finished runs, equal runs once, by seed. Within a seed the most different conditions come first
/// [byDifference].
std::vector<Representative> representativesOf(const std::string& database);

}  // namespace morula
