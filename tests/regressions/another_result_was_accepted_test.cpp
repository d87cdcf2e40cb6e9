// `review --accept` silently accepted another result than the one that waited and was shown. In a copied project
// `review` showed or deleted the other project's result. A picture of an earlier result stayed with a new one, and a
// page of an earlier check showed pictures of now. A golden's name and reason could hold control characters.
#include "catch.h"
#include "project.h"

using namespace morula::test;

namespace {

/// A scenario of one cell that changes its shape a little.
std::string cellOf(int drag) {
  return "morula: 1\nname: cell\ndna: |\n  START: a0\n  g1(a1|a0)\nstop: {time: 0.125}\nphysics: {mesh: {icosphere: 1}, drag: " +
         std::to_string(drag) + "}\n";
}

std::string waiting(const Project& project, const char* extension, const std::string& root = ".") {
  for (const auto& entry : std::filesystem::directory_iterator(project.folder / root + "/golden/.pending"))
    if (entry.path().extension() == extension) return entry.path().string();
  return "";
}

}  // namespace

TEST_CASE("only the result that waits is accepted") {
  const Project project;
  project.write("scenarios/one.yaml", treeOf(1));
  REQUIRE(project.shell(acceptAll).code == 0);
  project.write("scenarios/one.yaml", treeOf(2));
  REQUIRE(project.shell("$M check").code == 1);
  REQUIRE(project.shell("$M review").code == 1);
  project.write("scenarios/one.yaml", treeOf(3));  // changed after it was shown
  const std::string before = readWhole(project.folder / "golden/one.golden");
  const auto other = project.shell("$M review scenarios/one.yaml --accept --by me --why seen");
  CHECK(other.code == 1);
  CHECK_THAT(other.out, ContainsSubstring("nothing accepted") && ContainsSubstring("stop.cycles: 2 → 3"));
  CHECK(readWhole(project.folder / "golden/one.golden") == before);
  CHECK(project.shell("$M review scenarios/one.yaml --accept --by me --why seen").code == 0);
  CHECK(project.shell("$M check").code == 0);
}

TEST_CASE("what waits belongs to its project, wherever that was moved, and is not deleted by looking") {
  const Project project;
  project.write("a/scenarios/one.yaml", treeOf(1));
  REQUIRE(project.shell("$M review scenarios/one.yaml --accept --by me --why first --quiet", "a").code == 0);
  project.write("a/scenarios/one.yaml", treeOf(2));
  REQUIRE(project.shell("$M check", "a").code == 1);
  REQUIRE(project.shell("cp -r a b").code == 0);
  project.write("a/scenarios/one.yaml", treeOf(3));  // the other project changes its scenario
  const auto copied = project.shell("$M review --quiet", "b");
  CHECK(copied.code == 1);
  CHECK_THAT(copied.out, ContainsSubstring("scenarios/one.yaml: ") && ContainsSubstring("stop.cycles: 1 → 2"));
  REQUIRE(project.shell("mv a c && rm c/scenarios/one.yaml").code == 0);
  const auto gone = project.shell("$M review", "c");
  CHECK(gone.code == 0);
  CHECK_THAT(gone.err, ContainsSubstring("golden/.pending/one-") && ContainsSubstring("is not here"));
  CHECK_FALSE(waiting(project, ".golden", "c").empty());
}

TEST_CASE("pictures are of the result beside which they lie") {
  const Project project;
  project.write("scenarios/one.yaml", cellOf(1));
  REQUIRE(project.shell(acceptAll).code == 0);
  project.write("scenarios/one.yaml", cellOf(2));
  REQUIRE(project.shell("$M check --reports reports").code == 1);
  REQUIRE_FALSE(waiting(project, ".png").empty());
  CHECK_THAT(readWhole(project.folder / "reports/report.html"), !ContainsSubstring("There are no pictures"));
  // A page of a check whose scenario has changed since shows no pictures.
  project.write("scenarios/one.yaml", cellOf(3));
  REQUIRE(project.shell("$M report reports/report.json -o later.html --quiet").code == 0);
  CHECK_THAT(readWhole(project.folder / "later.html"),
             ContainsSubstring("There are no pictures, because the scenario"));
  // The next result has no bodies, and so no picture.
  project.write("scenarios/one.yaml", treeOf(1));
  REQUIRE(project.shell("$M check").code == 1);
  CHECK(waiting(project, ".png").empty());
}

TEST_CASE("names and reasons in goldens are one line of plain text") {
  const Project project;
  project.write("scenarios/one.yaml", treeOf(1));
  for (const char* text : {"a$(printf '\\033')[2J", "a$(printf '\\342\\200\\256')b", "a$(printf '\\377')b",
                           "$(printf 'x%.0s' $(seq 1200))", "a$(printf '\\302\\205')b"})
    for (const char* option : {"--why", "--by"}) {
      const std::string other = option == std::string("--why") ? "--by" : "--why";
      const auto run =
          project.shell("$M review scenarios/one.yaml --accept " + other + " me " + option + " \"" + text + "\"");
      INFO(text << run.err);
      CHECK(run.code == 3);
      CHECK_FALSE(project.has("golden/one.golden"));
    }
  CHECK(project.shell("$M review scenarios/one.yaml --accept --by 'Zoë Ångström' --why 'größer → fester'").code == 0);
}
