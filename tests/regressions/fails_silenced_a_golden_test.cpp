// A scenario with `check: {fails: ["."]}` and a golden passed whatever stopped it: the pattern matched the name of its
// file, and nothing was compared with the golden.
#include "catch.h"
#include "project.h"

using namespace morula::test;

namespace {

const std::string refused = "physics: {time_step: 5, mesh: {icosphere: 1}}\n";

}  // namespace

TEST_CASE("a scenario that must stop has no golden") {
  const Project project;
  project.write("scenarios/one.yaml", treeOf(1));
  REQUIRE(project.shell(acceptAll).code == 0);
  project.write("scenarios/one.yaml", treeOf(1, refused + "check: {fails: [physics.time_step]}\n"));
  const auto both = project.shell("$M check");
  CHECK(both.code == 3);
  CHECK_THAT(both.out,
             ContainsSubstring("golden/one.golden: a scenario that must stop (check.fails) has no result to accept"));
  CHECK(project.shell("rm golden/one.golden && $M check").code == 0);
}

TEST_CASE("what must stand in the reason is no text that fits everything, and the file's name is no reason") {
  const Project project;
  for (const char* text : {".", "a", "ab", "..."}) {
    project.write("scenarios/one.yaml", treeOf(1, refused + "check: {fails: ['" + std::string(text) + "']}\n"));
    const auto run = project.shell("$M check");
    CHECK(run.code == 3);
    CHECK_THAT(run.err,
               ContainsSubstring("scenarios/one.yaml:") && ContainsSubstring("is part of nearly every message"));
  }
  project.write("scenarios/one.yaml", treeOf(1, refused + "check: {fails: [scenarios/one.yaml]}\n"));
  CHECK(project.shell("$M check").code == 1);
  project.write("scenarios/one.yaml", treeOf(1, refused + "check: {fails: [physics.time_step]}\n"));
  CHECK(project.shell("$M check").code == 0);
}
