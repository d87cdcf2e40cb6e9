#pragma once
// Comparisons of made studies, whose values are known, and what is asked of their sentences.
#include <algorithm>
#include <stdexcept>

#include "analysis/study_comparison.h"
#include "base/random.h"
#include "study_db.h"
#include "temporary_folder.h"
// Included last, because of CHECK:
#include "catch.h"

namespace morula::test {

/// Returns noise of seeds 1 to 10, with mean 0 over these seeds.
inline double noise(int seed, std::uint64_t key) {
  double sum = 0;
  for (std::uint32_t s = 1; s <= 10; ++s) sum += randomNormal({key, {}}, s);
  return randomNormal({key, {}}, static_cast<std::uint32_t>(seed)) - sum / 10;
}

inline StudyComparison compared(const MadeStudy& study, const CompareOptions& options = {}) {
  const TemporaryFolder folder;
  writeStudy(study, folder / "study.db");
  return compareStudy(readStudyResults(folder / "study.db"), options);
}

/// Returns a study like the project's own: seeds change nothing under `longest`, sisters always touch, clones are
/// tighter under `longest` by 4.5 %, and connections change nothing.
inline MadeStudy policies() {
  MadeStudy study;
  study.axes = {{"division", {"longest", "random"}}, {"connections", {"none", "both"}}};
  study.seedless = [](const std::vector<int>& levels) { return levels[0] == 0; };
  study.values = [](const std::vector<int>& levels, int seed) {
    const double z = noise(seed, 11), own = noise(seed, std::uint64_t(20 + levels[1]));
    const bool random = levels[0] == 1;
    return Values{{"clone_radius", random ? 1 / 0.955 * (1 + 0.005 * z + 0.001 * own) : 1},
                  {"sister_contact", random && seed == 3 ? 0.994 : 1}};
  };
  return study;
}

inline const PairComparison& pairOf(const StudyComparison& c, const std::string& measure, const std::string& axis) {
  for (const PairComparison& p : c.pairs)
    if (c.measureName(p.measure) == measure && c.results.axes[p.axis].name == axis) return p;
  throw std::runtime_error("no such pair");
}

inline void checkCorrectedByHolm(const std::vector<PairComparison>& pairs) {
  std::vector<double> p;
  for (const PairComparison& pair : pairs) p.push_back(pair.paired.p);
  const auto corrected = correctHolm(p);
  for (std::size_t i = 0; i < p.size(); ++i) CHECK(pairs[i].corrected == corrected[i]);
}

inline bool says(const std::vector<std::string>& lines, const std::string& sentence) {
  return std::ranges::find(lines, sentence) != lines.end();
}

/// Returns true if a sentence has this beginning, part and end.
inline bool says(const std::vector<std::string>& lines, const std::string& begin, const std::string& part,
                 const std::string& end = "") {
  return std::ranges::any_of(lines, [&](const std::string& line) {
    return line.starts_with(begin) && line.find(part) != line.npos && line.ends_with(end);
  });
}

/// Returns the sentences of a comparison, and shows them if a check fails.
inline std::vector<std::string> shownVerdicts(const StudyComparison& c) {
  auto verdicts = verdictsOf(c);
  for (const auto& line : verdicts) UNSCOPED_INFO(line);
  return verdicts;
}

}  // namespace morula::test
