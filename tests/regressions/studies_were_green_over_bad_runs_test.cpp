// A study whose runs had failed, were insane, were missing or belonged to another scenario was green: `study run`,
// `status`, `check` and `compare` silently ended with 0. Statistics of a study went into a golden with older DNA. A
// crate of a study held one run of many.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "project.h"
#include "stored.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

/// Two cells: far apart, deep in one another, or so fast that their squared speeds overflow.
const std::string fine = "cells: [{at: [-3, 0, 0]}, {at: [3, 0, 0]}]",
                  insane = "cells: [{at: [-0.05, 0, 0]}, {at: [0.05, 0, 0]}]",
                  failing = "cells: [{at: [-3, 0, 0], velocity: [1e+200, 0, 0]}, {at: [3, 0, 0]}]";

const std::string base =
    "morula: 1\nname: two\ndna: |\n  START: a0\n  g1(a0|a0)\ncycle: {length: 1000}\nstop: {time: 0.25}\n"
    "physics: {mesh: {icosphere: 1}, time_step: 0.0078125}\nvariation: {start: 0.01}\n" +
    fine + "\n";

/// Returns a study with a claim that always holds: the volume of two balls of radius 1.
std::string studyOf(const std::string& levels, const std::string& more = "") {
  return "morula-study: 1\nname: two\nbase: two.yaml\nseeds: 1..3\nmeasures: [world.volume]\n" + more +
         "check: [{measure: world.volume, at: {start: fine}, mean: 8.4, within: 4}]\nvary:\n  start:\n    heavy: {physics.cell.mass: 2}\n" +
         levels;
}

const std::string levelFine = "    fine: {}\n", levelInsane = "    insane: {" + insane + "}\n",
                  levelFailing = "    failing: {" + failing + "}\n";

struct States : Project {
  explicit States(const std::string& study) {
    write("scenarios/two.yaml", base);
    write("scenarios/two.study.yaml", study);
  }
  Launched study(const std::string& verb, const std::string& more = "") const {
    return shell("$M study " + verb + " scenarios/two.study.yaml --out out " + more);
  }
};

/// Checks that every verb that judges a study says the same.
void allSay(const States& project, int code, const std::string& state, const std::string& onThePage) {
  for (const std::string& command :
       {std::string("study run scenarios/two.study.yaml --out out"),
        std::string("study status scenarios/two.study.yaml --out out"),
        std::string("study check out/study.db --reports reports"), std::string("study compare out/study.db"),
        std::string("compare out/study.db --json")}) {
    const auto said = project.shell("$M " + command);
    INFO(command << "\n" << said.out << said.err);
    CHECK(said.code == code);
    CHECK_THAT(said.out + said.err, ContainsSubstring(state));
  }
  REQUIRE(project.shell("$M report out/study.db -o page.html --frames 0 --quiet").code == 0);
  const std::string page = readWhole(project.folder / "page.html");
  CHECK(page.find(onThePage) != page.npos);
}

}  // namespace

TEST_CASE("a study with an insane run is not fine") {
  const States project(studyOf(levelFine + levelInsane));
  CHECK(project.study("run", "--quiet").code == 1);
  allSay(project, 1, "not sane", "not sane: overlap ");
  CHECK_THAT(readWhole(project.folder / "reports/junit.xml"), ContainsSubstring("type=\"NOT_SANE\""));
}

TEST_CASE("a study with a failed run is not fine") {
  const States project(studyOf(levelFine + levelFailing));
  CHECK(project.study("run", "--quiet").code == 1);
  allSay(project, 1, "3 failed", "seeds 1, 2 and 3: failed");
}

TEST_CASE("a study is fine with as many failed and insane runs as it allows, and no more") {
  const std::string levels = levelFine + levelInsane + levelFailing;
  const States enough(studyOf(levels, "limits: {failed: 3, insane: 3}\n"));
  CHECK(enough.study("run", "--quiet").code == 0);
  CHECK(enough.shell("$M study check out/study.db").code == 0);
  for (const char* limits :
       {"limits: {failed: 2, insane: 3}\n", "limits: {failed: 3, insane: 2}\n", "limits: {failed: 3}\n"}) {
    const States project(studyOf(levels, limits));
    CHECK(project.study("run", "--quiet").code == 1);
  }
}

TEST_CASE("a study that lacks a run says so") {
  const States project(studyOf(levelFine));
  REQUIRE(project.study("run", "--quiet").code == 0);
  REQUIRE(project.shell("rm $(ls -d out/tasks/*.db | head -n 1) out/study.db").code == 0);
  CHECK(project.study("merge", "--quiet").code == 5);
  for (const char* command :
       {"study status scenarios/two.study.yaml --out out", "study check out/study.db", "compare out/study.db"}) {
    const auto said = project.shell(std::string("$M ") + command);
    INFO(command << "\n" << said.out << said.err);
    CHECK(said.code == 5);
    CHECK_THAT(said.out + said.err, ContainsSubstring("1 missing"));
  }
}

TEST_CASE("results of another scenario, other levels or fewer seeds than the study file's are not its results") {
  const States project(studyOf(levelFine));
  const std::string check = "$M study check scenarios/two.study.yaml", before = studyOf(levelFine);
  REQUIRE(project.shell("$M study run scenarios/two.study.yaml --quiet").code == 0);
  REQUIRE(project.shell(check).code == 0);
  project.write("scenarios/two.yaml", base + "# a comment changes nothing\n");
  CHECK(project.shell(check).code == 0);
  project.write("scenarios/two.study.yaml", replaced(before, "mass: 2", "mass: 3"));
  const auto stale = project.shell(check);
  CHECK(stale.code == 1);
  CHECK_THAT(stale.out + stale.err, ContainsSubstring("stale") && ContainsSubstring("physics.cell.mass: 2") &&
                                        ContainsSubstring("physics.cell.mass: 3"));
  project.write("scenarios/two.study.yaml", replaced(before, "1..3", "1..4"));
  const auto fewer = project.shell(check);
  CHECK(fewer.code == 5);
  CHECK_THAT(fewer.out + fewer.err, ContainsSubstring("lack the seed 4"));
}

TEST_CASE("statistics of a study go into no golden whose DNA has changed since, nor from another program") {
  const States project(studyOf(levelFine));
  project.write("scenarios/two.dna", "START: a0\ng1(a0|a0)\n");
  project.write("scenarios/two.yaml", replaced(base, "dna: |\n  START: a0\n  g1(a0|a0)\n", "dna: {file: two.dna}\n"));
  REQUIRE(project.shell("$M review scenarios/two.yaml --accept --by me --why first --quiet").code == 0);
  REQUIRE(project.study("run", "--quiet").code == 0);
  const std::string into = "$M compare out/study.db --into-golden scenarios/two.yaml";
  CHECK(project.shell(into).code == 0);
  project.write("scenarios/two.dna", "START: a0\ng1(a0|a0)\ng2(b0|a0)\n");
  const auto changed = project.shell(into);
  CHECK(changed.code == 3);
  CHECK_THAT(changed.err, ContainsSubstring("before scenarios/two.dna was changed; run the study again"));
  project.write("scenarios/two.dna", "START: a0\ng1(a0|a0)\n");
  change(project.folder / "out/study.db", "UPDATE study SET build_id = 'another'");
  const auto other = project.shell(into);
  CHECK(other.code == 3);
  CHECK_THAT(other.err, ContainsSubstring("the study's runs were computed by another build of the program (another, this is "));
}

TEST_CASE("a study that varies what it compares with, or colours alone, has a run for each level") {
  const States project(
      "morula-study: 1\nname: two\nbase: two.yaml\nseeds: 1..2\nmeasures: [position_rmsd]\nkeep: {pictures: all}\nvary:\n  "
      "reference:\n    near: {check.reference.file: near.txt}\n    far: {check.reference.file: far.txt}\n  colours:\n    "
      "red: {colours: {a0: '#ff0000'}}\n    blue: {colours: {a0: '#0000ff'}}\n");
  const std::string apart = "cells: [{at: [-3, 0, 0]}, {at: [3, 0, 0]}, {at: [0, 3, 0]}, {at: [0, -3, 0]}]";
  project.write(
      "scenarios/two.yaml",
      replaced(base, fine, apart) + "check: {reference: {file: near.txt}}\nrecord: {measures: [position_rmsd]}\n");
  project.write("scenarios/near.txt", "position AA -3 0 0\nposition AB 3 0 0\nposition BA 0 3 0\n");
  project.write("scenarios/far.txt", "position AA -9 0 0\nposition AB 3 0 0\nposition BA 0 3 0\n");
  const auto run = project.study("run");
  INFO(run.out << run.err);
  CHECK(run.code == 0);
}

TEST_CASE("a crate of a study names the run that it holds") {
  const States project(studyOf(levelFine));
  REQUIRE(project.study("run", "--quiet").code == 0);
  const auto crate = project.shell("$M export out/study.db --ro-crate crate");
  CHECK(crate.code == 2);
  CHECK_THAT(crate.err, ContainsSubstring("holds 6 runs of a study") && ContainsSubstring("--run ID"));
  CHECK_FALSE(project.has("crate"));
}

TEST_CASE("a page is written of a study file whose runs are there") {
  const States project(studyOf(levelFine));
  const auto before = project.shell("$M report scenarios/two.study.yaml -o page.html");
  CHECK(before.code == 6);
  CHECK_THAT(before.err, ContainsSubstring("morula study merge scenarios/two.study.yaml makes it"));
  REQUIRE(project.shell("$M study run scenarios/two.study.yaml --quiet").code == 0);
  CHECK(project.shell("$M report scenarios/two.study.yaml -o page.html --frames 0 --quiet").code == 0);
  CHECK(project.has("page.html"));
}
