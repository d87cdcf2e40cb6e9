// The command line itself: help, misspelt verbs and options, strict numbers, exit codes.
#include "catch.h"
#include "launch.h"

using namespace morula::test;

TEST_CASE("help and version are data") {
  for (const auto* argument : {"--help", "--version", "-h"}) {
    const auto run = launch({argument});
    CHECK(run.code == 0);
    CHECK(run.err.empty());
    CHECK(run.out.find("orula") != std::string::npos);
  }
  const auto run = launch({"run", "--help"});
  CHECK(run.code == 0);
  CHECK(run.out.find("--set") != std::string::npos);
}

TEST_CASE("a chart or tree is refused under a name that it cannot have, before anything is measured") {
  for (const std::string ending : {".mp4", ".jpg", ".svgz", "."})
    for (const auto& arguments : std::vector<std::vector<std::string>>{{"bench"},
                                                                       {"accuracy", uniqueFour},
                                                                       {"lineage", uniqueFour},
                                                                       {"render", uniqueFour, "--style", "lineage"},
                                                                       {"chart", uniqueFour, "divisions"}}) {
      auto all = arguments;
      all.insert(all.end(), {"-o", "/nowhere/x" + ending});
      INFO(arguments[0]);
      refuses(all, 2, "needs a name that ends in .png, .svg or .pdf");
    }
  refuses({"accuracy", uniqueFour, "--into-golden", "-o", "x.png"}, 2, "--into-golden and --output: give one of them");
}

TEST_CASE("every verb that help lists is there") {
  for (const auto* verb : {"run", "check", "accuracy", "review", "validate", "schema", "init", "render", "lineage",
                           "chart", "replay", "export"}) {
    INFO(verb);
    CHECK(launch({"--help"}).out.find(std::string("  ") + verb + " ") != std::string::npos);
    CHECK(launch({verb, "--help"}).code == 0);
  }
}

TEST_CASE("misspelt verbs and options are guessed") {
  refuses(std::vector<std::string>{}, 2, "no verb; one of run, parts, check");
  refuses({"rnu", uniqueFour}, 2, "unknown verb 'rnu'; did you mean run?");
  refuses({"valdate", uniqueFour}, 2, "did you mean validate?");
  refuses({"frobnicate"}, 2, "unknown verb 'frobnicate'; one of run, ");
  refuses({uniqueFour}, 2, "did you mean morula run " + uniqueFour + "?");
  refuses({"run", uniqueFour, "--jsno"}, 2, "run: '--jsno' is not expected; did you mean --json?");
  refuses({"run", uniqueFour, "--thread=2"}, 2, "did you mean --threads?");
  refuses({"run", "--frobnicate", uniqueFour}, 2, "run --help lists the options");
  refuses({"run"}, 2, "run: scenario is required");
  refuses({"accuracy", "--level", "1", "3", "nowhere.yaml"}, 6, "'nowhere.yaml' cannot be read");
  refuses({"schema", "surplus"}, 2, "'surplus' is not expected");
}

TEST_CASE("numbers on the command line are read strictly") {
  refuses({"run", uniqueFour, "--threads", "two"}, 2, "--threads: 'two' is not a number");
  refuses({"run", uniqueFour, "--threads", "0"}, 2,
          "--threads: 0 is out of range; needs a whole number from 1 to 1024");
  refuses({"run", uniqueFour, "--threads", "010"}, 2, "leading zero");
  refuses({"run", uniqueFour, "--seed", "-1"}, 2, "--seed: '-1' is negative");
  refuses({"run", uniqueFour, "--seed", "1e3"}, 2, "--seed: '1e3' is not a whole number");
  refuses({"run", uniqueFour, "--isa", "sse9"}, 2, "--isa: ");
  refuses({"run", uniqueFour, "--search", "octree"}, 2, "--search: 'octree'");
  refuses({"run", uniqueFour, "--seeds", "1-5"}, 2, "--seeds: '1-5' is not a range; needs FIRST..LAST");
  refuses({"run", uniqueFour, "--seeds", "5..1"}, 2, "runs backward");
  refuses({"run", uniqueFour, "--seeds", "1..x"}, 2, "--seeds: 'x' is not a number");
  refuses({"run", uniqueFour, "--seed", "1", "--seeds", "1..2"}, 2, "give one of them");
  refuses({"render", uniqueFour, "--time", "-1"}, 2, "--time: -1 is out of range");
  refuses({"render", uniqueFour, "--style", "sold"}, 2, "--style: 'sold' is not known");
  refuses({"init", "--dna", "full-tree", "--levels", "17"}, 2, "--levels: 17 is out of range");
}

TEST_CASE("wrong values of the scene are input errors and name the option") {
  refuses({"run", uniqueFour, "--set", "physics.tme_step=0.1"}, 3,
          "--set physics.tme_step: unknown key; did you mean time_step?");
  refuses({"run", uniqueFour, "--set", "physics.time_step"}, 3, "needs path=value");
  refuses({"run", uniqueFour, "--set", "physics.time_step=0.5"}, 3, "--set physics.time_step: 0.5");
}

TEST_CASE("files that cannot be used") {
  refuses({"run", "no-such.yaml"}, 6, "'no-such.yaml' cannot be read: No such file or directory");
  refuses({"validate", "scenarios"}, 6, "'scenarios' is a folder");
  refuses({"lineage", "no-such.db"}, 6, "'no-such.db' cannot be read");
  refuses({"run", uniqueFour, "--out", "/dev/null/results"}, 6, "cannot be made");
  const TemporaryFolder folder;
  // With the zero byte that ends the mark of a database.
  writeWhole(folder / "no.db", std::string("SQLite format 3") + '\0' + "but a database has pages, and this has none");
  refuses({"lineage", folder / "no.db"}, 6, "no.db");
}
