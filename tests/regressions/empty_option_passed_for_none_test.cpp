// `run --db ''`, as a script gives it whose variable is not set, passed for a run without --db. An empty word
// is refused by every verb, for options and for names of files.
#include "catch.h"
#include "launch.h"

using namespace morula::test;

TEST_CASE("an empty word on the command line is refused with the option's name") {
  const std::string scenario = "scenarios/thesis/unique-four.yaml";
  for (const std::vector<std::string>& line : {std::vector<std::string>{"run", scenario, "--dry-run", "--db", ""},
                                               {"run", scenario, "--dry-run", "--out", ""},
                                               {"run", scenario, "--dry-run", "--seed", ""},
                                               {"run", scenario, "--dry-run", "--set", ""},
                                               {"replay", "ff", "--db", ""},
                                               {"explain", scenario, "--db", ""},
                                               {"export", "x.db", "--ro-crate", ""},
                                               {"lineage", ""},
                                               {"validate", ""},
                                               {"check", ""},
                                               {"render", scenario, "-o", ""}}) {
    const auto run = launch(line);
    CAPTURE(line, run.err);
    CHECK(run.code == 2);
    CHECK(run.err.find("is empty; needs a value") != std::string::npos);
  }
}
