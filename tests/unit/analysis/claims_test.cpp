// Claims compared with studies of known values.
#include "analysis/claims.h"

#include "base/error.h"
#include "catch.h"
#include "study_db.h"
#include "temporary_folder.h"

using namespace morula;

namespace {

/// Returns results in which clone_radius is 1 under `a` and about 1.1 under `b`, without connections 0.02 more in every
/// seed. The sphericity is about equal everywhere.
StudyResults results() {
  MadeStudy study;
  study.axes = {{"division", {"a", "b"}}, {"connections", {"none", "both"}}};
  study.values = [](const std::vector<int>& levels, int seed) {
    const double wave = 0.001 * ((seed * 7) % 10 - 4.5);
    return Values{{"clone_radius", 1 + (levels[0] ? 0.1 + (levels[1] ? 0 : 0.02) : 0) + wave * (1 + levels[0])},
                  {"sphericity", 0.9 + wave * (levels[0] == levels[1] ? 1 : -1)}};
  };
  const TemporaryFolder folder;
  writeStudy(study, folder / "study.db");
  return readStudyResults(folder / "study.db");
}

Study studyWith(const std::string& claim) {
  return readStudy(
      "morula-study: 1\nname: s\nbase: s.yaml\nvary:\n  division: {a: {}, b: {physics.drag: 1}}\n"
      "  connections: {none: {}, both: {physics.cell.mass: 2}}\nseeds: 1..10\n"
      "measures: [clone-radius, sphericity]\ncheck:\n  - {measure: " +
          claim + "}\n",
      "s.study.yaml", true);
}

ClaimFinding findingOf(const std::string& claim) {
  const auto findings = findClaims(results(), studyWith(claim));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].place.line == 10);
  return findings[0];
}

}  // namespace

TEST_CASE("A claim holds or not, by what a comparison says of its pair or condition") {
  struct Row {
    const char *claim, *words;
    bool holds;
  };
  for (const Row& row : std::vector<Row>{
           {"clone-radius, a: {division: a}, b: {division: b}, says: lower", "clone_radius: a lower than b", true},
           {"clone_radius, a: {division: b}, b: {division: a}, says: lower", "clone_radius: b lower than a", false},
           {"clone_radius, a: {division: b}, b: {division: a}, says: higher", "clone_radius: b higher than a", true},
           {"clone_radius, a: {division: a}, b: {division: b}, says: no-effect",
            "clone_radius: no effect of a as compared with b", false},
           {"sphericity, a: {division: a}, b: {division: b}, says: no-effect",
            "sphericity: no effect of a as compared with b", true},
           {"sphericity, a: {division: a}, b: {division: b}, says: lower", "sphericity: a lower than b", false},
           {"sphericity, a: {division: a}, b: {division: b}, says: equivalent, within: 1%",
            "sphericity: a equivalent to b within 1%", true},
           {"clone_radius, a: {division: a}, b: {division: b}, says: equivalent, within: 0.05",
            "clone_radius: a equivalent to b within 0.05", false},
           {"clone_radius, a: {division: a}, b: {division: b}, says: equivalent, within: 0.13",
            "clone_radius: a equivalent to b within 0.13", true},
           // Claims at one level of the other axis, and in the mean over that axis.
           {"clone_radius, a: {division: b, connections: none}, b: {division: b, connections: both}, says: higher",
            "clone_radius: none higher than both with division: b", true},
           {"clone_radius, a: {division: a, connections: none}, b: {division: a, connections: both}, says: higher",
            "clone_radius: none higher than both with division: a", false},
           {"clone_radius, at: {division: b, connections: none}, mean: 1.12, within: 0.001",
            "clone_radius: 1.12 ± 0.001 with division: b, connections: none", true},
           {"clone_radius, at: {division: b, connections: both}, mean: 1.12, within: 0.001",
            "clone_radius: 1.12 ± 0.001 with division: b, connections: both", false},
           {"clone_radius, at: {division: b, connections: both}, mean: 1.12, within: 2%",
            "clone_radius: 1.12 ± 2% with division: b, connections: both", true}}) {
    INFO(row.claim);
    const ClaimFinding finding = findingOf(row.claim);
    INFO(finding.found);
    CHECK(finding.claim == row.words);
    CHECK(finding.holds == row.holds);
  }
  CHECK_THAT(findingOf("clone-radius, a: {division: b}, b: {division: a}, says: higher").found,
             ContainsSubstring("clone_radius: 9.9 % tighter under a (1) than under b (1.11), every one of 10 pairs"));
  CHECK(findingOf("clone-radius, at: {division: a, connections: none}, mean: 2, within: 1").found ==
        "clone_radius: 1 in the mean of 10 runs, 95 % interval 0.9978 to 1.002");
}

TEST_CASE("A claim of equivalence that no result could contradict is refused, with its place and what would be right") {
  const auto margin = [](const std::string& within) {
    return "clone_radius, a: {division: a}, b: {division: b}, says: equivalent, within: " + within;
  };
  CHECK_THROWS_WITH(
      findClaims(results(), studyWith(margin("0.2"))),
      "s.study.yaml:10:91: check[0].within: ±0.2 of clone_radius is wider than the range of all its values "
      "(0.9955 to 1.129), so any two conditions would pass; needs a margin below 0.13");
  CHECK_THROWS_AS(findClaims(results(), studyWith(margin("20%"))), InputError);
  CHECK_THROWS_AS(findClaims(results(), studyWith("sphericity, a: {division: a}, b: {division: b}, says: equivalent, "
                                                  "within: 0.01")),
                  InputError);
}

TEST_CASE("Claims of other axes than the results have are refused, and what was not measured holds nothing") {
  StudyResults other = results();
  other.axes[0].labels[1] = "c";
  const Study study = studyWith("sphericity, a: {division: a}, b: {division: b}, says: no-effect");
  CHECK_THROWS_WITH(findClaims(other, study), ContainsSubstring("run and merge the study again"));
  StudyResults none = results();
  for (ResultTask& task : none.tasks) task.status = TaskStatus::missing, task.values.assign(2, {});
  const auto findings = findClaims(none, study);
  CHECK_FALSE(findings[0].holds);
  CHECK(findings[0].found == "sphericity: no run has a value of this measure");
}
