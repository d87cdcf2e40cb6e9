// Keys, names, --set, file names, OBJ lines, goldens and databases sent control bytes to the terminal, where these
// could rewrite text. Bytes that are not UTF-8 ended JSON output as a bug, exit 70. Now all output passes one function
// that makes such bytes visible; JSON stays JSON.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "hostile.h"
#include "stored.h"

using namespace morula::test;

namespace {

const std::string escape = "\x1b]0;owned\x07",
                  c1 = "\xc2\x9b"
                       "31m",
                  direction =
                      "\xe2\x80\xae"
                      "abc",
                  noText = "\xff\xfe";
// The first text passes readers of YAML, the second is refused at once.
const Words hostile{"a" + c1 + direction + "\x7f", escape + "\r" + noText};

void checkClean(const Launched& run) {
  CAPTURE(run.code, run.out, run.err);
  CHECK(harmfulByte(run.out) == "");
  CHECK(harmfulByte(run.err) == "");
  CHECK(run.code != 70);
  CHECK(run.code < 128);
}

}  // namespace

TEST_CASE("control bytes in scenarios, names and options are shown, not sent") {
  const TemporaryFolder folder;
  const auto scenario = folder / "small.yaml";
  for (const auto& bytes : hostile) {
    CAPTURE(bytes);
    for (const std::string& text :
         {smallScene + bytes + ": 1\n", smallScene + "summary: " + bytes + "\n",
          smallScene + "colours: {" + bytes + ": red}\n",
          "morula: 1\nname: x\ndna: |\n  START: a0\n  g1(" + bytes + "|a0)\nstop: {cycles: 1}\n"}) {
      writeWhole(scenario, text);
      checkClean(launch({"validate", scenario}));
      checkClean(launch({"validate", "--json", scenario}));
    }
    writeWhole(scenario, smallScene);
    for (const Words& words : {Words{"--set", "summary=" + bytes},
                               {"--set", bytes + "=1"},
                               {"--set", "name=" + bytes},
                               {"--set", bytes},
                               {"--seed", bytes},
                               {"--" + bytes},
                               {bytes},
                               {"--set", "colours={" + bytes + ": '#ffffff'}"}}) {
      checkClean(launch(joined({"validate", scenario}, words)));
      checkClean(launch(joined({"run", scenario, "--dry-run", "--json"}, words)));
    }
    checkClean(launch({bytes}));
    checkClean(launch({"lineage", "--run", bytes, scenario}));
    checkClean(launch({"explain", "--with", folder / bytes, scenario}));
    const auto named = folder / ("x" + bytes + ".yaml");
    writeWhole(named, smallScene);
    for (const char* verb : {"validate", "check", "lineage"}) {
      checkClean(launch({verb, named}));
      const auto json = launch({verb, "--json", named});
      checkClean(json);
      CHECK_FALSE(nlohmann::json::parse(json.out, nullptr, false).is_discarded());
    }
    checkClean(launch({"check", "--reports", folder / "reports", named}));
    for (const char* report : {"junit.xml", "report.json", "summary.md"})
      CHECK(harmfulByte(readWhole(folder / "reports/" + report)) == "");
    writeWhole(folder / "small.golden", "morula golden 1\n" + bytes + "\n");
    checkClean(launch({"check", scenario}));
    std::filesystem::remove(folder / "small.golden");
    writeWhole(folder / "a.obj", bytes + "\nv " + bytes + "\n");
    writeWhole(scenario, smallBody);
    checkClean(launch({"validate", "--set", "physics.mesh={file: a.obj}", scenario}));
  }
}

TEST_CASE("control characters written as escapes of YAML are refused at their place") {
  const TemporaryFolder folder;
  const auto scenario = folder / "a.yaml";
  for (const char* text : {"x\\0y", "\\e[31m", "a\\x9b", "\\u202e", "\\a"}) {
    CAPTURE(text);
    writeWhole(scenario, smallScene + "summary: \"" + text + "\"\n");
    const auto run = launch({"validate", scenario});
    checkClean(run);
    CHECK(run.code == 3);
    CHECK(run.err.starts_with(scenario + ":10:10: summary: "));
  }
}

TEST_CASE("a text cannot pass for a line of ours") {
  const TemporaryFolder folder;
  writeWhole(folder / "a.yaml", smallScene + "\"x\\nother.yaml:1:1: name\": 1\n");
  const auto run = launch({"validate", folder / "a.yaml"});
  CHECK(run.code == 3);
  CHECK(run.err.find("\nother.yaml") == std::string::npos);
}

TEST_CASE("control bytes in a database are shown or refused") {
  const TemporaryFolder folder;
  const auto original = folder / "original.db", database = folder / "run.db";
  writeWhole(folder / "small.yaml", smallScene);
  succeeds({"run", "--quiet", "--no-check", "--no-pictures", "--db", original, folder / "small.yaml"});
  for (const auto& bytes : hostile)
    for (const char* sql : {"UPDATE run SET scenario = ?", "UPDATE run SET started = ?", "UPDATE run SET failure = ?",
                            "UPDATE run SET command = ?", "UPDATE run SET cpu = ?", "UPDATE cell SET state = ?",
                            "UPDATE run_document SET role = ?"}) {
      CAPTURE(bytes, sql);
      std::filesystem::copy_file(original, database, std::filesystem::copy_options::overwrite_existing);
      change(database, sql, bytes);
      checkClean(launch({"export", database}));
      checkClean(launch({"lineage", database}));
    }
}
