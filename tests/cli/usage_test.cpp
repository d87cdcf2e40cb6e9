// The command line: help, calls without arguments, and early refusals. Misspelt verbs and options, numbers, files:
// bad_commands.
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
  CHECK_THAT(succeeds({"run", "--help"}).out, ContainsSubstring("--set"));
}

TEST_CASE("help names the program as it is typed") {
  CHECK_THAT(succeeds({"run", "--help"}).out, ContainsSubstring("Usage: morula run [OPTIONS] scenario"));
  CHECK_THAT(succeeds({"study", "plan", "--help"}).out, ContainsSubstring("Usage: morula study plan [OPTIONS]"));
}

TEST_CASE("behind -- all words are files") {
  const TemporaryFolder folder;
  writeWhole(folder / "--lineage.yaml", readWhole(uniqueFour));
  CHECK(launch({"validate", "--quiet", "--", uniqueFour}).code == 0);
  CHECK(launch({"validate", "--", folder / "--lineage.yaml", uniqueFour}).code == 0);
  refuses({"validate", "--", "--json"}, 6, "'--json' cannot be read");
  refuses({"validate", "--nonsense", "--", uniqueFour}, 2, "'--nonsense' is not expected");
}

TEST_CASE("a chart or tree is refused under a name that it cannot have, before anything is measured") {
  for (const std::string ending : {".mp4", ".jpg", ".svgz", "."})
    for (const Words& words : {Words{"bench"},
                               {"accuracy", uniqueFour},
                               {"lineage", uniqueFour},
                               {"render", uniqueFour, "--style", "lineage"},
                               {"chart", uniqueFour, "divisions"}}) {
      INFO(words[0]);
      refuses(joined(words, {"-o", "/nowhere/x" + ending}), 2, "needs a name that ends in .png, .svg or .pdf");
    }
}

TEST_CASE("every verb that help lists is there") {
  for (const auto* verb : {"run", "check", "accuracy", "review", "validate", "schema", "init", "render", "lineage",
                           "chart", "replay", "export"}) {
    INFO(verb);
    CHECK(launch({"--help"}).out.find(std::string("  ") + verb + " ") != std::string::npos);
    CHECK(launch({verb, "--help"}).code == 0);
  }
}

TEST_CASE("without words the verbs are told") { refuses(Words{}, 2, "no verb; one of run, parts, check"); }

TEST_CASE("a time step above its limit is an input error that names the option") {
  refuses({"run", uniqueFour, "--set", "physics.time_step=0.5"}, 3, "--set physics.time_step: 0.5");
}
