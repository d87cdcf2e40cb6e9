// Comparisons of studies with known values: pairs, conditions, time courses, other output and refusals.
#include "database/database.h"
#include "database/store_error.h"
#include "made_comparisons.h"
#include "store/result_file.h"
#include "system/usage_error.h"

using namespace morula;
using namespace morula::test;

TEST_CASE("Conditions that differ most come first, and those without values last") {
  MadeStudy study;
  study.axes = {{"where", {"middle", "low", "nothing", "near low", "high"}}};
  study.seeds = 3;
  study.values = [](const std::vector<int>& levels, int seed) -> Values {
    const double places[] = {5, 0, 0, 0.5, 9.8};  // low and high are farthest apart
    if (levels[0] == 2) return {};
    return {{"neighbours", places[levels[0]] + 0.01 * seed}, {"sphericity", 1}};
  };
  // The middle is farther from low and high than `near low` is.
  CHECK(byDifference(compared(study)) == std::vector<std::size_t>{1, 4, 0, 3, 2});
}

TEST_CASE("Pairs are of one seed, in the mean over the other axes, and the same numbers as by hand") {
  MadeStudy study = policies();
  study.seedless = {};
  const auto c = compared(study);
  const auto& pair = pairOf(c, "clone_radius", "connections");
  std::vector<double> none, both;
  for (int seed = 1; seed <= 10; ++seed) {
    const auto mean = [&](int connections) {
      return 0.5 * (study.values({0, connections}, seed)["clone_radius"] +
                    study.values({1, connections}, seed)["clone_radius"]);
    };
    none.push_back(mean(0)), both.push_back(mean(1));
  }
  CHECK(pair.paired.difference == Approx(mean(none) - mean(both)).margin(1e-15));
  CHECK(pair.paired.p == Approx(comparePaired(none, both).p));
  CHECK(pair.unpaired->interval->low == Approx(compareUnpaired(none, both).interval->low));
  CHECK(*pair.intervalRatio() < 0.5);  // seeds share most of what varies
  checkCorrectedByHolm(c.pairs);
  CHECK(c.pairs.size() == 4);
}

TEST_CASE("Within: the levels are compared at each level of the other axis, too") {
  const auto c = compared(policies(), {.measures = {"clone-radius"}, .within = true});
  CHECK(c.pairs.size() == 6);
  CHECK(c.pairs[1].at[1] == 0);
  CHECK(says(verdictsOf(c), "clone_radius: 4.5 % tighter under longest (",
             " with connections: none, every one of 10 pairs: "));
  const auto one = compared(policies(), {.by = {"division"}, .within = true});
  CHECK(one.pairs.size() == 2);  // in the mean over connections, which are not compared
}

TEST_CASE("Failed and missing runs are named, and their partners are left out") {
  MadeStudy study = policies();
  study.trouble = [](const std::vector<int>& levels, int seed) -> std::string {
    if (levels == std::vector{1, 0} && seed == 4) return "failed";
    if (levels == std::vector{1, 1} && (seed == 4 || seed == 7)) return "missing";
    return "";
  };
  const auto c = compared(study);
  const auto troubles = troublesOf(c.results);
  CHECK(says(troubles, "failed  random, none, seed 4: numerical failure: too fast"));
  CHECK(says(troubles, "missing  random, both, seed 7"));
  CHECK(troubles.size() == 3);
  const std::string text = textOf(describe(c));
  CHECK(text.find("failed  random") < text.find("clone_radius"));
  CHECK(pairOf(c, "clone_radius", "division").of.size() == 9);  // seed 7 has one connection left
  CHECK(pairOf(c, "clone_radius", "connections").of.size() ==
        9);  // seeds 4 and 7 have longest alone, which is one pair
}

TEST_CASE("Conditions that mean the same are the same runs, and no comparison") {
  MadeStudy study = policies();
  study.seedless = {};
  study.sameAs = [](const std::vector<int>& levels) { return std::vector{levels[0], 0}; };
  const auto c = compared(study);
  CHECK(says(troublesOf(c.results), "equal runs  longest, none = longest, both"));
  CHECK(pairOf(c, "clone_radius", "connections").sameRuns);
  CHECK(says(verdictsOf(c), "clone_radius: the runs of none and both are the same"));
}

TEST_CASE("Time courses are of the times that all runs share") {
  MadeStudy study = policies();
  study.times = {1, 2, 4};
  const auto c = compared(study);
  REQUIRE(c.courses.size() == 8);
  for (const TimeCourse& course : c.courses) {
    REQUIRE(course.points.size() == 3);
    CHECK(course.points[1].time == 2);
    CHECK(course.points[1].mean == Approx(0.5 * course.points[2].mean));
  }
  CHECK(compared(policies()).courses.empty());
}

TEST_CASE("Other output says the same numbers") {
  const auto c = compared(policies());
  const Json json = toJson(c);
  CHECK(json["conditions"].size() == 8);
  CHECK(json["conditions"][0]["labels"] == Json({{"division", "longest"}, {"connections", "none"}}));
  CHECK(json["conditions"][0]["n"] == 10);
  CHECK(json["conditions"][0]["distinct"] == 1);
  CHECK(json["conditions"][0]["low"].is_null());
  CHECK(json["pairs"][0]["difference"].get<double>() == c.pairs[0].paired.difference);
  CHECK(json["verdicts"].size() == 8);
  const std::string csv = toCsv(c);
  CHECK(std::ranges::count(csv, '\n') == 1 + 80 + 8 + 4 + 2 * 3);  // title, values, conditions, pairs, effects
  CHECK(csv.starts_with(
      "kind,measure,axis:division,axis:connections,by,a,b,seed,time,n,distinct,unit,value,low,high,shape,p,p_holm,"
      "effect,g,higher,lower,unpaired_low,unpaired_high,interval_ratio,margin,p_equivalent_holm,equivalent\n"));
}

TEST_CASE("What the study has not is refused, with what was probably meant") {
  const auto message = [](const CompareOptions& options) -> std::string {
    try {
      compared(policies(), options);
      return "";
    } catch (const UsageError& error) { return error.what(); }
  };
  CHECK(message({.by = {"divison"}}) == "--by: the study has no axis 'divison'; did you mean division?");
  CHECK_THAT(message({.measures = {"mass"}}), ContainsSubstring("it has sister_contact, clone_radius"));
  for (const char* wrong : {"", "0", "-1", "abc", "5%%", "inf", "clone_radius=", "radius=0.1"})
    CHECK_THAT(message({.margins = {wrong}}), ContainsSubstring("--equivalent: "));
  CHECK_THAT(message({.margins = {"0.1", "0.2"}}), ContainsSubstring("two margins"));
}

TEST_CASE("A database that is no study's is refused") {
  const TemporaryFolder folder;
  {
    Database db(folder / "run.db", Database::Mode::create, std::chrono::seconds(1));
    makeTables(db);
  }
  CHECK_THROWS_WITH(readStudyResults(folder / "run.db"), ContainsSubstring("but of no study"));
  CHECK_THROWS_AS(readStudyResults(folder / "none.db"), StoreError);
}

TEST_CASE("A study without axes has conditions and no pairs") {
  MadeStudy study;
  study.values = [](const std::vector<int>&, int seed) { return Values{{"cells", 30. + seed}}; };
  const auto c = compared(study);
  CHECK(c.conditions.size() == 1);
  CHECK(c.conditions[0].mean == 35.5);
  CHECK(c.pairs.empty());
  CHECK_THAT(textOf(describe(c)), ContainsSubstring("cells"));
}
