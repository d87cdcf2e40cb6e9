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

TEST_CASE("a word of an earlier command line answers with the new command") {
  const auto answers = [](const Words& words, const std::string& now) {
    const auto run = launch(words);
    CHECK(run.code == 2);
    CHECK(run.out.empty());
    CHECK(run.err == "morula: " + now + "\n");
  };
  const std::string into = "accuracy --into-golden is now: morula review SCENARIO --into-golden",
                    stated = "accuracy --stated is now: morula review GOLDEN --stated",
                    pictures = "compare of pictures is now: morula render ONE.png --compare OTHER.png";
  answers({"accuracy", uniqueFour, "--into-golden"}, into);
  answers({"accuracy", "--into-golden"}, into);
  answers({"accuracy", uniqueFour, uniqueFour, "--into-golden", "--only"}, into);
  answers({"accuracy", "--stated", "golden/thesis/unique-four.golden"}, stated);
  answers({"compare", "one.png", "other.png"}, pictures);
  answers({"study", "compare", "one.png", "other.png", "-o", "difference.png"}, pictures);
  answers({"compare", "one.png"}, pictures);
  answers({"trail", uniqueFour}, "trail is now: morula internal trail");
  answers({"describe", "bash"}, "describe is now: morula internal describe");
  answers({"engine-worker"}, "engine-worker is now: morula internal engine-worker");
  refuses({"accuracy", "--", "--stated"}, 6, "'--stated' cannot be read");
}

TEST_CASE("one verb is not listed, and it groups what programs ask for") {
  CHECK_THAT(succeeds({"internal", "--help"}).out,
             ContainsSubstring("trail") && ContainsSubstring("engine-worker") && ContainsSubstring("describe"));
  const std::string manual = succeeds({"internal", "describe", "man"}).out;
  CHECK_THAT(manual, ContainsSubstring("The same as morula compare.\n") && !ContainsSubstring("morula internal"));
  CHECK(occurrences(manual, "\\-\\-equivalent") == 1);
  CHECK_THAT(succeeds({"internal", "describe", "bash"}).out, ContainsSubstring("'study compare --tidy')"));
  refuses({"internal"}, 2, "internal: no verb; one of trail, engine-worker, describe");
}
