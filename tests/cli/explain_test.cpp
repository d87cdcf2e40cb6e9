// morula explain, and review with waiting results.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string divides =
    "morula: 1\nname: pair\ndna: |\n  START: a0\n  g1(a1|a0)\n  g2(divide|a0)\n  g3(a1|a1)\ncycle: {length: 0.125}\n"
    "stop: {cycles: 2}\nphysics:\n  mesh: {icosphere: 1}\n  cell: {radius: 0.95}\n  drag: 1\n  contact: {}\n"
    "division: {plane: longest}\n";

Json explained(const Words& words, int code) { return jsonOf(joined({"explain"}, words), code); }

/// Writes a program that computes another scenario than it is asked for, like an older build with another constant.
std::string pretender(const TemporaryFolder& folder, const std::string& scenario) {
  const auto program = folder / "pretender";
  writeWhole(program, "#!/bin/sh\nshift 3\nexec '" MORULA_PROGRAM "' internal trail '" + scenario + "' \"$@\"\n");
  fs::permissions(program, fs::perms::owner_all);
  return program;
}

}  // namespace

TEST_CASE("explain says that all is well") {
  const TemporaryFolder folder;
  const auto scenario = folder / "pair.yaml";
  writeWhole(scenario, divides);
  accept(scenario);
  const auto json = explained({scenario}, 0);
  CHECK(json["class"] == "");
  CHECK(json["first_step"].is_null());
  for (const auto& check : json["checks"]) CHECK(check["passed"] == true);
}

TEST_CASE("explain names the kind of difference, and where it begins") {
  const TemporaryFolder folder;
  const auto scenario = folder / "pair.yaml";
  writeWhole(scenario, divides);
  accept(scenario);
  succeeds({"run", scenario, "--no-pictures", "--out", folder / "out", "--db", folder / "run.db"});
  CHECK(explained({scenario, "--db", folder / "run.db"}, 0)["class"] == "");

  SECTION("a golden that somebody has edited") {
    const auto golden = folder / "pair.golden";
    writeWhole(golden, replaced(readWhole(golden), "count cells 2", "count cells 3"));
    CHECK(explained({scenario}, 1)["class"] == "INPUT_CHANGED");
  }
  SECTION("another scenario than the accepted one") {
    writeWhole(scenario, replaced(divides, "drag: 1", "drag: 1.5"));
    const auto json = explained({scenario}, 1);
    CHECK(json["class"] == "INPUT_CHANGED");
    CHECK(json["first_step"] == 1);
    CHECK(json["last_equal_step"] == 0);
    CHECK(json["field"] == "acceleration");
    CHECK(json["cell"] == "");
    CHECK_THAT(json["text"].get<std::string>(),
               ContainsSubstring("where it began: the same up to step 0, different at step 1\n") &&
                   ContainsSubstring("expected  the accepted scenario, made again") &&
                   ContainsSubstring("  moves     first at step ") && !ContainsSubstring("  ok    "));
    // A changed program would not reproduce the golden's bits.
    CHECK_THAT(json["text"].get<std::string>(), !ContainsSubstring("the computation has changed, too"));
  }
  SECTION("another scenario than the stored one") {
    writeWhole(scenario, replaced(divides, "drag: 1", "drag: 1.5"));
    const auto json = explained({scenario, "--db", folder / "run.db"}, 1);
    CHECK(json["class"] == "INPUT_CHANGED");
    CHECK_THAT(json["text"].get<std::string>(), ContainsSubstring("changed   physics.drag: 1 → 1.5\n") &&
                                                    ContainsSubstring("lineage   the same\n") &&
                                                    ContainsSubstring("where it began: "));
  }
  SECTION("another program that computes with another constant") {
    const auto other = folder / "other.yaml";
    writeWhole(other, replaced(divides, "drag: 1", "drag: 1.0000000000000002"));
    const auto json = explained({scenario, "--with", pretender(folder, other)}, 1);
    CHECK(json["class"] == "COMPUTATION");
    CHECK(json["first_step"].get<int>() == json["last_equal_step"].get<int>() + 1);
    CHECK(json["cell"] == "");
  }
  SECTION("another program whose cells divide elsewhere") {
    const auto other = folder / "other.yaml";
    writeWhole(other, replaced(divides, "length: 0.125", "length: 0.25"));
    const auto json = explained({scenario, "--with", pretender(folder, other)}, 1);
    CHECK(json["cells"].size() == 3);  // the egg of one run, the daughters of the other
  }
}

TEST_CASE("explain tells that another program gives no trail") {
  const auto run = launch({"explain", uniqueFour, "--with", "/bin/true"});
  CHECK_THAT(run.err, ContainsSubstring("the trail is cut short"));
}

TEST_CASE("what differs waits for a review, beside the goldens, and is rejected or accepted with a reason") {
  const TemporaryFolder folder;
  const std::string name = fs::path(folder.path()).filename().string();  // a unique name
  const auto scenario = folder / (name + ".yaml"), golden = folder / (name + ".golden");
  writeWhole(scenario, divides);
  accept(scenario);
  const fs::path pending = folder / ".pending";
  const auto waits = [&](const char* extension) {  // a hash of the place follows the name
    if (!fs::exists(pending)) return false;
    for (const auto& entry : fs::directory_iterator(pending))
      if (entry.path().filename().string().starts_with(name + "-") && entry.path().extension() == extension)
        return true;
    return false;
  };
  CHECK_FALSE(waits(".golden"));

  writeWhole(scenario, replaced(divides, "drag: 1", "drag: 1.5"));
  CHECK(launch({"check", scenario}).code == 1);
  CHECK((waits(".golden") && waits(".png")));
  CHECK_THAT(endsWith(1, {"review", scenario}).out,
             ContainsSubstring("INPUT_CHANGED") && ContainsSubstring("changed bits") &&
                 ContainsSubstring("changed values") && ContainsSubstring("picture  ") &&
                 ContainsSubstring(scenario + ": "));
  CHECK(launch({"review", scenario, "--reject", "--why", "the drag was a slip"}).code == 0);
  CHECK_FALSE((waits(".golden") || waits(".png")));
  CHECK_THAT(readWhole(golden), ContainsSubstring("why the first one"));

  // Without a scenario's name review finds all waiting results of the folder. A result whose scenario is gone is
  // reported and stays.
  const auto reviewHere = [&] {
    return std::system(("cd '" + folder.path() + "' && '" MORULA_PROGRAM "' review >said 2>&1").c_str());
  };
  CHECK(launch({"check", scenario}).code == 1);
  CHECK(reviewHere() != 0);
  CHECK_THAT(readWhole(folder / "said"), ContainsSubstring(name + ".yaml: "));
  CHECK_THAT(launch({"review"}).out, !ContainsSubstring(name));  // a result of another project
  writeWhole(scenario, divides);                                 // the accepted scenario: nothing waits any more
  CHECK(launch({"check", scenario}).code == 0);
  CHECK_FALSE((waits(".golden") || waits(".png") || waits(".from")));
  writeWhole(scenario, replaced(divides, "drag: 1", "drag: 1.5"));
  CHECK(launch({"check", scenario}).code == 1);
  fs::rename(scenario, scenario + ".gone");
  CHECK(reviewHere() == 0);
  CHECK_THAT(readWhole(folder / "said"), !ContainsSubstring("cannot be read"));
  CHECK_THAT(readWhole(folder / "said"), ContainsSubstring("is not here"));
  CHECK((waits(".golden") && waits(".png") && waits(".from")));
  fs::rename(scenario + ".gone", scenario);

  CHECK(launch({"check", scenario}).code == 1);
  accept(scenario, "more drag");
  CHECK_FALSE(waits(".golden"));
  CHECK_THAT(readWhole(golden), ContainsSubstring("why more drag"));
  CHECK(launch({"check", scenario}).code == 0);
}
