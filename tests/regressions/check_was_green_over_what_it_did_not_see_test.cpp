// `check` was green over a family behind a symbolic link, scenarios that end in .yml, and an empty project. An
// unreadable scenario ended it before its reports were written, and green reports of an earlier check stayed. A project
// whose scenarios all must stop ended with exit 6.
#include "catch.h"
#include "project.h"

using namespace morula::test;

TEST_CASE("families behind links and scenarios that end in .yml are checked") {
  const Project project;
  project.write("elsewhere/one.yaml", treeOf(2));
  std::filesystem::create_directory_symlink("../elsewhere", project.folder / "scenarios/linked");
  std::filesystem::create_directory_symlink("..", project.folder / "elsewhere/around");  // links may form circles
  project.write("scenarios/two.yml", treeOf(2));
  project.write("scenarios/family/three.YAML", treeOf(2));
  CHECK(project.shell("$M check").code == 1);
  REQUIRE(project
              .shell("for f in scenarios/linked/one.yaml scenarios/two.yml scenarios/family/three.YAML; do "
                     "$M review $f --accept --by me --why first --quiet || exit 9; done")
              .code == 0);
  const auto fine = project.shell("$M check");
  CHECK(fine.code == 0);
  for (const char* name : {"linked/one: all", "two: all", "family/three: all"})
    CHECK_THAT(fine.out, ContainsSubstring(name));
  project.write("elsewhere/one.yaml", treeOf(3));
  project.write("scenarios/two.yml", treeOf(3));
  const auto changed = project.shell("$M check");
  CHECK(changed.code == 1);
  CHECK(occurrences(changed.out, "INPUT_CHANGED") >= 2);
}

TEST_CASE("a project without scenarios is not green") {
  const Project project;
  const auto empty = project.shell("$M check --reports reports");
  CHECK(empty.code == 3);
  CHECK_THAT(empty.err, ContainsSubstring("there is no scenario to check"));
  CHECK_THAT(readWhole(project.folder / "reports/junit.xml"), ContainsSubstring("failures=\"1\""));
  project.write("scenarios/family/some.study.yaml", "");
  CHECK(project.shell("$M check").code == 3);
}

TEST_CASE("a scenario that cannot be read is a failed check, the others go on, and reports are this check's") {
  const Project project;
  project.write("scenarios/a.yaml", treeOf(2));
  project.write("scenarios/c.yaml", treeOf(2));
  project.write("scenarios/f/claims.study.yaml", "");
  REQUIRE(
      project.shell("for f in a c; do $M review scenarios/$f.yaml --accept --by me --why first --quiet; done").code ==
      0);
  const auto green = project.shell("$M check --reports reports");
  CHECK(green.code == 0);
  CHECK_THAT(green.err, ContainsSubstring("scenarios/f/claims.study.yaml"));  // named, and not run here
  project.write("reports/of-others.txt", "kept");

  project.write("scenarios/b.yaml", "morula: 1\nnam: b\n");
  project.write("scenarios/c.yml", treeOf(2));  // its golden would be that of c.yaml
  std::filesystem::create_symlink("nowhere.yaml", project.folder / "scenarios/d.yaml");
  const auto red = project.shell("$M check --reports reports");
  CHECK(red.code == 3);
  CHECK_THAT(red.out, ContainsSubstring("a: all"));
  CHECK_THAT(red.err, ContainsSubstring("scenarios/b.yaml:2") && ContainsSubstring("scenarios/d.yaml") &&
                          ContainsSubstring("its golden file is the same as that of scenarios/c.yaml"));
  const std::string junit = readWhole(project.folder / "reports/junit.xml");
  CHECK_THAT(junit, ContainsSubstring("type=\"UNREAD\"") && ContainsSubstring("scenarios/b.yaml") &&
                        ContainsSubstring("classname=\"a\""));
  CHECK_THAT(readWhole(project.folder / "reports/summary.md"), ContainsSubstring("scenarios/b.yaml"));
  CHECK_THAT(readWhole(project.folder / "reports/report.html"), ContainsSubstring("scenarios/b.yaml"));
  CHECK(readWhole(project.folder / "reports/of-others.txt") == "kept");
}

TEST_CASE("a project whose scenarios all must stop needs no folder of goldens") {
  const Project project;
  project.write("scenarios/stops.yaml",
                treeOf(2, "physics: {time_step: 5, mesh: {icosphere: 1}}\ncheck: {fails: [physics.time_step]}\n"));
  const auto run = project.shell("$M check");
  INFO(run.out << run.err);
  CHECK(run.code == 0);
}

TEST_CASE("a golden that git has written with the line ends of another system is the same golden") {
  const Project project;
  project.write("scenarios/one.yaml", treeOf(1));
  REQUIRE(project.shell(acceptAll).code == 0);
  CHECK(project.shell("sed -i 's/$/\\r/' scenarios/one.yaml golden/one.golden && $M check").code == 0);
  const auto mixed = project.shell("sed -i '5s/\\r$//' golden/one.golden && $M check");
  CHECK(mixed.code == 3);
  CHECK_THAT(mixed.out, ContainsSubstring("*.golden -text") && ContainsSubstring(".gitattributes"));
}
