// Plans: all combinations, each distinct run once, and ids that follow from content alone.
#include "study/plan.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "studies.h"
// Included last, because of CHECK:
#include "catch.h"

using namespace morula;

namespace {

std::vector<std::string> idsOf(const Plan& plan) {
  std::vector<std::string> ids;
  for (const Task& task : plan.tasks) ids.push_back(task.id);
  return ids;
}

/// Checks the parts of conditions that a plan's file does not hold, and that are made anew when it is read.
void checkMadeAnew(const Plan& a, const Plan& b) {
  REQUIRE(a.conditions.size() == b.conditions.size());
  for (std::size_t i = 0; i < a.conditions.size(); ++i) {
    const Condition &x = a.conditions[i], &y = b.conditions[i];
    CHECK(x.number == y.number);
    CHECK(x.levels == y.levels);
    CHECK(x.base == y.base);
    CHECK(x.scenario.resolved == y.scenario.resolved);
    CHECK(x.scenario.meaning == y.scenario.meaning);
    CHECK(x.scenario.places == y.scenario.places);
  }
}

}  // namespace

TEST_CASE("The conditions are all combinations of levels, the last axis fastest; each runs with each seed") {
  const TemporaryFolder folder;
  const Plan plan = planIn(folder);
  std::vector<std::vector<std::string>> labels;
  for (const char* division : {"random", "x"})
    for (const char* connections : {"none", "both"}) labels.push_back({division, connections});
  REQUIRE(plan.conditions.size() == labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    CHECK(plan.conditions[i].number == i);
    CHECK(plan.conditions[i].labels == labels[i]);
    const auto& mechanics = *plan.conditions[i].scenario.scene.mechanics;
    CHECK(mechanics.division.otherwise.plane == (i < 2 ? DivisionPlane::random : DivisionPlane::axis));
    CHECK(mechanics.connections.has_value() == (i % 2 == 1));
  }
  REQUIRE(plan.replicates.size() == 12);
  for (std::size_t i = 0; i < 12; ++i) {
    CHECK(plan.replicates[i].condition == i / 3);
    CHECK(plan.replicates[i].seed == 1 + i % 3);
  }
}

TEST_CASE("Seeds that change nothing give one task; seeds that do, one each") {
  const TemporaryFolder folder;
  const Plan plan = planIn(folder);
  CHECK(conditionsWithoutSeeds(plan) == std::vector<std::size_t>{2, 3});
  CHECK(plan.tasks.size() == 3 + 3 + 1 + 1);
  const Plan varied =
      planIn(folder, ballStudyWith("seeds: 1..3\n", "  noise: {on: {variation.share: 0.05}}\nseeds: 1..3\n"));
  CHECK(conditionsWithoutSeeds(varied).empty());
  CHECK(varied.tasks.size() == 12);
  CHECK(describe(plan).find("division: x, connections: both") != std::string::npos);
}

TEST_CASE("Every replicate finds its task: the first that needs it names it, and all of one task mean the same") {
  const TemporaryFolder folder;
  const Plan plan = planIn(folder);
  std::set<std::size_t> found;
  for (const Replicate& r : plan.replicates) {
    const Task& task = plan.tasks.at(r.task);
    if (found.insert(r.task).second) {
      CHECK(task.condition == r.condition);
      CHECK(task.seed == r.seed);
    }
    CHECK(plan.conditions[task.condition].meaning == plan.conditions[r.condition].meaning);
    if (plan.conditions[r.condition].usesSeed) CHECK(task.seed == r.seed);
  }
  CHECK(found.size() == plan.tasks.size());
}

TEST_CASE("Conditions that mean the same share their runs, however they are written") {
  const TemporaryFolder folder;
  const Plan plan = planIn(folder, ballStudyWith("connections: {none: {}",
                                                 "connections: {none: {}, gone: {connections: null}, "
                                                 "colour: {colours: {a0: '#102030'}}"));
  const auto groups = conditionsThatShare(plan);
  REQUIRE(groups.size() == 2);
  CHECK(groups[0] == std::vector<std::size_t>{0, 1, 2});
  CHECK(groups[1] == std::vector<std::size_t>{4, 5, 6});
  CHECK(plan.replicates.size() == 24);
  CHECK(plan.tasks.size() == 8);
  // Colours count if pictures are kept.
  const Plan pictures = planIn(
      folder, ballStudyWith("connections: {none: {}", "connections: {none: {}, colour: {colours: {a0: '#102030'}}") +
                  "keep: {pictures: all}\n");
  CHECK(conditionsThatShare(pictures).empty());
}

TEST_CASE("Ids follow from content: neither folder, comments, names of labels nor the order of axes change a task's") {
  const TemporaryFolder folder, other;
  const Plan plan = planIn(folder);
  CHECK(idsOf(planIn(other)) == idsOf(plan));
  CHECK(planIn(other).id == plan.id);
  CHECK(planIn(other, "# a remark\n" + ballStudy).id == plan.id);
  const Plan renamed = planIn(folder, ballStudyWith("{random: {", "{anywhere: {"));
  CHECK(idsOf(renamed) == idsOf(plan));
  CHECK(renamed.id != plan.id);
  auto sorted = idsOf(plan);
  std::ranges::sort(sorted);
  CHECK(std::ranges::adjacent_find(sorted) == sorted.end());
  for (const std::string& id : sorted) {
    CHECK(id.size() == 16);
    CHECK(id.find_first_not_of("0123456789abcdef") == id.npos);
  }
}

TEST_CASE("What is measured, when, and what is kept is part of a task's id; limits only of the plan's") {
  const TemporaryFolder folder;
  const Plan plan = planIn(folder);
  for (const std::string& study :
       {ballStudyWith(", clone_radius", ", sphericity"),
        ballStudyWith("sister-contact, clone_radius", "clone_radius, sister-contact"),
        ballStudyWith("[sister-contact, clone_radius]", "{names: [sister-contact, clone_radius], when: each-division}"),
        ballStudyWith("[sister-contact, clone_radius]", "{names: [sister-contact, clone_radius], when: {every: 0.5}}"),
        ballStudy + "keep: {hashes: all}\n", ballStudy + "keep: {samples: all}\n",
        ballStudy + "keep: {pictures: all}\n"}) {
    CAPTURE(study);
    const std::vector<std::string> ids = idsOf(plan);
    for (const std::string& id : idsOf(planIn(folder, study))) CHECK(std::ranges::find(ids, id) == ids.end());
  }
  const Plan limited = planIn(folder, ballStudy + "limits: {cpu-per-run: 10}\n");
  CHECK(idsOf(limited) == idsOf(plan));
  CHECK(limited.id != plan.id);
}

TEST_CASE("What the scenario itself would record does not count, and the study's measures do") {
  const TemporaryFolder folder;
  const Plan plan = planIn(folder);
  writeText(folder / "balls.yaml", ballScenario + "record: {every: 0.1, pictures: 1, measures: [energy]}\n");
  const Plan again = makePlan(loadStudy(folder / "s.study.yaml"), {.predict = false});
  CHECK(again.id == plan.id);
  const auto& record = again.conditions[0].scenario.record;
  CHECK(record.measures == std::vector<std::string>{"sister_contact", "clone_radius"});
  CHECK(!record.every);
  CHECK(!record.pictures);
}

TEST_CASE("A task's scenario is the one that --set and --seed would have given") {
  const TemporaryFolder folder;
  const Plan plan = planIn(folder);
  const Task& task = plan.tasks.at(4);  // random, both, seed 2
  CHECK(task.seed == 2);
  const Scenario run = scenarioOf(plan, task);
  const Scenario expected = loadScenario(
      folder / "balls.yaml", {{"division.plane", "random", "--set division.plane"},
                              {"connections.make", "at-division", "--set connections.make"},
                              {"connections.on-division", "both", "--set connections.on-division"},
                              {"record.measures", "[sister_contact, clone_radius]", "--set record.measures"},
                              {"seed", "2", "--seed"}});
  CHECK(run.resolved == expected.resolved);
  CHECK(run.meaning == expected.meaning);
}

TEST_CASE("What measures compare with counts where one is taken, and is gone where none is") {
  const TemporaryFolder folder;
  const std::string compared =
      "record: {measures: [contact_f1]}\ncheck: {extent: 9, reference: {contacts: [[AAA, BBB]]}}\n";
  writeText(folder / "a.yaml", ballScenario + compared);
  writeText(folder / "b.yaml", ballScenario + compared);
  std::string other = compared;
  writeText(folder / "c.yaml", ballScenario + other.replace(other.find("BBB"), 3, "ABB"));
  const std::string study = "morula-study: 1\nname: three\nbase: [a.yaml, b.yaml, c.yaml]\nseeds: [1, 2]\nmeasures: ";
  const Plan with = planIn(folder, study + "[contact-f1]\n");
  CHECK(conditionsThatShare(with) == std::vector<std::vector<std::size_t>>{{0, 1}});
  CHECK(with.conditions[0].scenario.check.reference->contacts.size() == 1);
  CHECK(!with.conditions[0].scenario.check.extent);
  const Plan without = planIn(folder, study + "[cells]\n");
  CHECK(conditionsThatShare(without) == std::vector<std::vector<std::size_t>>{{0, 1, 2}});
  CHECK(!without.conditions[0].scenario.check.reference);
  for (const Plan* plan : {&with, &without})
    for (const Task& task : plan->tasks) {  // scenarios in a database can be read again
      const Scenario run = scenarioOf(*plan, task);
      CHECK(readScenario(run.resolved, "resolved.json", "").resolved == run.resolved);
    }
}

TEST_CASE("Several scenarios are the first axis") {
  const TemporaryFolder folder;
  const Plan plan =
      planIn(folder,
             "morula-study: 1\nname: two\nbase: {small: tree.yaml, large: balls.yaml}\n"
             "vary: {noise: {none: {}, some: {variation.cycle: 0.1}}}\nseeds: [7, 3]\nmeasures: [cells]\n");
  REQUIRE(plan.conditions.size() == 4);
  CHECK(plan.study.axes[0].name == "base");
  CHECK(plan.conditions[1].labels == std::vector<std::string>{"small", "some"});
  CHECK(plan.conditions[2].scenario.scene.name == "balls");
  CHECK(plan.conditions[2].labels == std::vector<std::string>{"large", "none"});
  CHECK(plan.replicates[0].seed == 7);
  CHECK(plan.replicates[1].seed == 3);
}

TEST_CASE("A plan's file is the plan, without the files that it was made from") {
  Plan plan;
  std::string text;
  {
    const TemporaryFolder folder;
    writeText(folder / "tree.dna", "START: a0\ng1(a0|a0)\ng2(divide|a0)\n");
    plan =
        planIn(folder,
               ballStudyWith("none: {}", "none: {}, other: {dna: {file: tree.dna}, stop: {time: 0.123456789012345}}") +
                   "summary: 'ein Versuch: \"ü\"'\nkeep: {hashes: none, pictures: first-seed}\n"
                   "limits: {cpu-per-run: 1.5, memory-per-run: 2G}\n",
               true);
    text = writePlan(plan);
  }
  const Plan again = readPlan(text, "plan.json");
  checkMadeAnew(plan, again);
  CHECK(writePlan(again) == text);
  CHECK(again.conditions[1].scenario.files.at(0).path == "tree.dna");
  CHECK(text.find("morula-test") == text.npos);  // no folder of this machine
}

TEST_CASE("A plan's file is damaged by any change") {
  const TemporaryFolder folder;
  const std::string text = writePlan(planIn(folder));
  for (std::size_t i = 0; i < text.size(); i += 97) {
    std::string damaged = text;
    damaged[i] = damaged[i] == 'x' ? 'y' : 'x';
    CAPTURE(i, text.substr(i, 20));
    CHECK_THROWS_AS(readPlan(damaged, "plan.json"), FileError);
  }
  CHECK_THROWS_AS(readPlan(text.substr(0, text.size() / 2), "plan.json"), FileError);
  CHECK_THROWS_AS(readPlan("", "plan.json"), FileError);
  CHECK_THROWS_WITH(readPlan("{}", "plan.json"), ContainsSubstring("no plan"));
  CHECK_THROWS_WITH(readPlan("[]", "plan.json"), ContainsSubstring("no plan"));
  std::string other = text;
  other.replace(other.find("\"seed\":2"), 8, "\"seed\":5");
  CHECK_THROWS_WITH(readPlan(other, "plan.json"), ContainsSubstring("is damaged"));
}

TEST_CASE("A folder keeps its plan: the same again is nothing new, another one is refused") {
  const TemporaryFolder folder;
  const Plan plan = planIn(folder);
  CHECK(keepPlan(plan, folder / "results"));
  const std::string text = readText(planFile(folder / "results"));
  CHECK_FALSE(keepPlan(plan, folder / "results"));
  CHECK(readText(planFile(folder / "results")) == text);
  CHECK(loadPlan(folder / "results").id == plan.id);
  const Plan other = planIn(folder, ballStudyWith("1..3", "1..4"));
  CHECK_THROWS_WITH(keepPlan(other, folder / "results"), ContainsSubstring("another plan"));
  CHECK(readText(planFile(folder / "results")) == text);
  CHECK_THROWS_AS(loadPlan(folder / "nothing"), FileError);
}

TEST_CASE("Costs: every condition has one, and the sum is that of the distinct runs") {
  const TemporaryFolder folder;
  const Plan plan = planIn(folder, ballStudy, true);
  REQUIRE(plan.costs.size() == 4);
  double seconds = 0, memory = 0;
  for (const Task& task : plan.tasks) {
    const RunCost& cost = plan.costs[task.condition];
    CHECK(cost.seconds > 0);
    CHECK(cost.memory > 0);
    CHECK(cost.disk > 1000);
    seconds += cost.seconds;
    memory = std::max(memory, cost.memory);
  }
  CHECK(totalCost(plan)->seconds == Approx(seconds));
  CHECK(totalCost(plan)->memory == memory);
  CHECK_FALSE(totalCost(planIn(folder)));
  // Without time for rehearsals the first condition alone is tried, and the others take its costs.
  const Plan poor = makePlan(loadStudy(folder / "s.study.yaml"), {.predict = true, .rehearsal = 0});
  CHECK(poor.costs[0].tried);
  CHECK_FALSE(poor.costs[3].tried);
  CHECK(poor.costs[3].memory == poor.costs[0].memory);
  CHECK(poor.id == plan.id);
}

TEST_CASE("What a base would take from rest to rest is told, or the key that does not go with it") {
  const TemporaryFolder folder;
  const Plan plan = planIn(folder, ballStudy, true);
  REQUIRE(plan.settled.size() == 1);
  CHECK(plan.settled[0].settled > 0);
  CHECK(plan.settled[0].seconds == plan.costs[0].seconds);
  CHECK_THAT(describe(plan),
             ContainsSubstring("with physics.integrator: quasi-static") && ContainsSubstring(" or more instead of "));
  CHECK(planIn(folder).settled.empty());  // no prediction was requested
  const auto first = [&](const std::string& keys) {
    return planIn(folder,
                  "morula-study: 1\nname: one\nbase: balls.yaml\nvary: {a: {b: {" + keys +
                      "}}}\nseeds: 1\nmeasures: [sphericity]\n",
                  true);
  };
  const Plan crawling = first("physics.motility: {speed: 0.1, persistence: 1}");
  REQUIRE(crawling.settled.size() == 1);
  CHECK_THAT(crawling.settled[0].refused, ContainsSubstring("physics.motility: integrator quasi-static"));
  CHECK_THAT(describe(crawling), ContainsSubstring("is not possible: physics.motility"));
  CHECK(first("physics.integrator: quasi-static").settled.empty());  // the integrator settles already
}

TEST_CASE("Ten thousand runs are planned") {
  const TemporaryFolder folder;
  std::string study = "morula-study: 1\nname: many\nbase: balls.yaml\nseeds: 1..100\nmeasures: [sphericity]\nvary:\n";
  for (const auto& [axis, change] :
       {std::pair<std::string, std::string>{"a", "variation.share: 0.0"}, {"b", "physics.drag: 1"}}) {
    study += "  " + axis + ":\n";
    for (const char digit : std::string("0123456789"))
      study += std::string("    v") + digit + ": {" + change + digit + "}\n";
  }
  const Plan plan = planIn(folder, study);
  CHECK(plan.conditions.size() == 100);
  CHECK(plan.tasks.size() == 10'000);
  CHECK(readPlan(writePlan(plan), "plan.json").tasks == plan.tasks);
}
