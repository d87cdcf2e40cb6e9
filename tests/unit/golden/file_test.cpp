// The golden's text: its bytes are reproducible, everything comes back, and a damaged file names the place.
#include "catch.h"
#include "example_facts.h"
#include "files/folders.h"
#include "files/read_file.h"

using namespace morula;

namespace {

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

/// Checks that reading the text fails at this line (0: any).
void complains(const std::string& text, int line, const std::string& about) {
  const std::string place = line ? "x.golden:" + std::to_string(line) + ": " : "x.golden:";
  CHECK_THROWS_WITH(readGolden(text, "x.golden"), Catch::Matchers::StartsWith(place) && ContainsSubstring(about));
}

/// Returns the text with the line of this beginning replaced, and the line's number.
std::pair<std::string, int> edited(const std::string& beginning, const std::string& replacement) {
  std::string text;
  int number = 0, found = 0;
  for (const std::string& line : linesOf(writeGolden(exampleGolden()))) {
    ++number;
    if (!found && line.starts_with(beginning)) {
      found = number;
      if (!replacement.empty()) text += replacement + '\n';
    } else {
      text += line + '\n';
    }
  }
  REQUIRE(found);
  return {text, found};
}

void complains(const std::string& beginning, const std::string& replacement, const std::string& about) {
  INFO(beginning << " -> " << replacement);
  const auto [text, line] = edited(beginning, replacement);
  complains(text, line, about);
}

int lastLine() { return static_cast<int>(linesOf(writeGolden(exampleGolden())).size()); }

}  // namespace

TEST_CASE("the errors of a scenario's settings are kept, and sealed; they are compared with no run") {
  Golden golden = exampleGolden();
  const GoldenData observed = golden.data;
  golden.stated = {GoldenError{"position", 2.8e-5, 2.8e-4, 1.6875, 0.0013, 0.013, 1.5},
                   GoldenError{"volume", {}, 1e-3, 1.6875, {}, {}, {}}, GoldenUnstated{"mesh", {"none is finer"}}};
  const std::string text = writeGolden(golden), line = "error position 2.8e-05 0.00028 1.6875 0.0013 0.013 1.5";
  CHECK(text.find("\n# error quantity rest worst until mesh_rest mesh_worst mesh_until\n" + line +
                  "\nerror volume - 0.001 1.6875 - - -\n") != text.npos);
  CHECK(text.find("\nunstated mesh none is finer\n") != text.npos);
  const Golden again = readGolden(text, "x.golden");
  CHECK(std::ranges::equal(again.stated, golden.stated, [](const auto& a, const auto& b) { return agree(a, b); }));
  CHECK(writeGolden(again) == text);
  CHECK(again.data.items.size() == exampleGolden().data.items.size());
  CHECK(compareGolden(again, observed).passed());
  const auto replaced = [&](const std::string& by) { return with(text, line, by); };
  for (const char* other :
       {"error position 2.7e-05 0.00028 1.6875 0.0013 0.013 1.5",
        "error position 2.8e-05 0.00028 1.6875 0.0013 0.014 1.5", "error position 2.8e-05 0.00028 1.6875 - - -",
        "error surface 2.8e-05 0.00028 1.6875 0.0013 0.013 1.5"})
    complains(replaced(other), 0, "edited");
  complains(replaced("error position 1 2 3"), 0, "the line is cut short; mesh_rest is expected");
  complains(replaced("error position x 2 3 4 5 6"), 0, "rest: 'x'");
  complains(replaced("error time 0.0028 mesh 0.01 until 2"), 0, "has the form of an older version");
  complains(replaced(line + "\n" + line), 0, "stands twice");
  CHECK(readGolden(writeGolden(exampleGolden()), "x.golden").stated.empty());
}

TEST_CASE(
    "old form: errors with one number for the time step and one for the mesh are read, and written as they stand") {
  Golden golden = exampleGolden();
  golden.stated = {OldGoldenError{"position", 2.8e-4, 1.6875, 0.013, 1.5},
                   OldGoldenError{"volume", 1e-3, 1.6875, {}, {}}};
  const std::string text = writeGolden(golden), line = "error position 0.00028 1.6875 0.013 1.5";
  CHECK(text.find("\n# error quantity time until mesh mesh_until\n" + line + "\nerror volume 0.001 1.6875 - -\n") !=
        text.npos);
  const Golden again = readGolden(text, "x.golden");
  CHECK(writeGolden(again) == text);
  CHECK(hasOldErrors(again));
  const std::vector<GoldenError> errors = errorsOf(again);
  REQUIRE(errors.size() == 2);
  CHECK_FALSE(errors[0].rest);
  CHECK(errors[0].worst == 2.8e-4);
  CHECK(errors[0].until == 1.6875);
  CHECK_FALSE(errors[0].meshRest);
  CHECK(errors[0].meshWorst == 0.013);
  CHECK(errors[0].meshUntil == 1.5);
  CHECK_FALSE(errors[1].meshWorst);
  const auto replaced = [&](const std::string& by) { return with(text, line, by); };
  complains(replaced("error position 0.00027 1.6875 0.013 1.5"), 0, "edited");
  complains(replaced("error position x 2 3 4"), 0, "time: 'x'");
  complains(replaced(line + "\nerror position 1 2 3 4 5 6"), 0, "stands twice");
  CHECK_FALSE(hasOldErrors(exampleGolden()));
}

TEST_CASE("statistics of the end are kept in their order, and sealed") {
  Golden golden = exampleGolden();
  golden.statistics = {{"clone_radius", "half-step", -0.0012, -0.0041, 0.0017, 8},
                       {"clone_radius", "coarse-mesh", 0.5, 0.25, 1, 20},
                       {"clone_radius", "single", 0.5, 0.5, 0.5, 10, true}};
  const std::string text = writeGolden(golden);
  const std::string line = "statistic clone_radius against half-step difference -0.0012 low -0.0041 high 0.0017 runs 8";
  CHECK(text.find("\n" + line + "\n") != text.npos);
  const std::string onePath = "statistic clone_radius against single difference 0.5 one-path runs 10";
  CHECK(text.find("\n" + onePath + "\n") != text.npos);
  const Golden again = readGolden(text, "x.golden");
  CHECK(again.statistics == golden.statistics);
  CHECK(writeGolden(again) == text);
  const auto replaced = [&](const std::string& by) { return with(text, line, by); };
  for (const char* other :
       {"statistic clone_radius against half-step difference -0.0012 low -0.0041 high 0.0018 runs 8",
        "statistic clone_radius against half-step difference -0.0012 low -0.0041 high 0.0017 runs 9",
        "statistic clone_radius against half difference -0.0012 low -0.0041 high 0.0017 runs 8"})
    complains(replaced(other), 0, "edited");
  complains(with(text, onePath, "statistic clone_radius against single difference 0.5 low 0.5 high 0.5 runs 10"), 0,
            "edited");
  for (const char* broken : {"statistic clone_radius", "statistic clone_radius against a difference 1 path runs 8",
                             "statistic clone_radius against a difference 1 low 2 high 3",
                             "statistic clone_radius against a difference 1 low 2 high 1 runs 8",
                             "statistic clone_radius against a difference x low 0 high 1 runs 8",
                             "statistic clone_radius against a difference 1 low 0 high 1 runs 1",
                             "statistic clone_radius than a difference 1 low 0 high 1 runs 8"})
    complains(replaced(broken), 0, "`statistic MEASURE against LABEL difference X low X high X runs N` is expected");
  complains(replaced(line + "\n" + line), 0, "stands twice");
}

TEST_CASE("the file is one value per line in a fixed order") {
  const std::string expected = R"(morula golden 2
scenario thesis/example
seed 7
scenario_hash 0123456789abcdef0123456789abcdef
accepted_by A. Tester
why first result

tolerance final/* rel 1e-12 why "test"

# count name count
count cells 1
count cells_ever 3
count divisions 1
count deaths 1
count steps 1024
count hash_every 256

# cell path born born_step ended ended_step fate state
cell egg 0 0 1 256 divided START a0
cell A 1 256 - - alive a4
cell B 1 256 3 768 died

# time_step step time time_step
time_step 0 0 0.00390625
time_step 256 1 0.001953125

# bits domain hash
bits solver 0000000000000abc0000000000000def

# step_hash step hash cells
step_hash 0 00000000000000010000000000000001 1001
step_hash 256 00000000000000020000000000000002 1002
step_hash 512 00000000000000030000000000000003 10031004

# image name renderer hash
image organism painter-1 00000000000000040000000000000004

# cost name count
cost list_builds 5

# value name step value
value 0.5/organism/cells 128 1
value 0.5/organism/volume 128 2
value 0.5/organism/kinetic_energy 128 1e-09
value 0.5/organism/mean_pressure 128 0.5
value 0.5/organism/shell_fill 128 0.5
value 0.5/organism/outermost 128 0.9
value final/organism/cells 1024 1
value final/organism/volume 1024 2
value final/organism/kinetic_energy 1024 1e-09
value final/organism/mean_pressure 1024 0.5
value final/organism/shell_fill 1024 0.5
value final/organism/outermost 1024 0.9
value final/A/volume 1024 2
value final/A/area 1024 0.30000000000000004
value final/A/pressure 1024 0.40625
value final/A/x 1024 -0
value final/A/y 1024 1e-17
value final/A/z 1024 -0.25
value final/A/sphericity 1024 0.97
value final/A/neighbours 1024 1

end 37 )";
  const std::string text = writeGolden(exampleGolden({rule("final/* rel 1e-12 why \"test\"")}));
  CHECK(text.substr(0, expected.size()) == expected);
  CHECK(text.size() == expected.size() + 33);
}

TEST_CASE("what is read is what was written, byte for byte") {
  const std::string text =
      writeGolden(exampleGolden({rule("final/* rel 1e-12 why \"test\""), rule("* ulp 2 why \"w\"")}));
  const Golden golden = readGolden(text, "x.golden");
  CHECK(writeGolden(golden) == text);
  CHECK(golden.acceptedBy == "A. Tester");
  CHECK(golden.why == "first result");
  CHECK(golden.data.seed == 7);
  CHECK(golden.rules.size() == 2);
  CHECK(golden.rules[1].line == 9);
}

TEST_CASE("the order of birth does not matter, the order of the file is by path") {
  GoldenFacts facts = exampleFacts();
  std::swap(facts.lineage[0], facts.lineage[2]);
  Golden golden = exampleGolden();
  golden.data = dataOf(facts);
  CHECK(writeGolden(golden) == writeGolden(exampleGolden()));
}

TEST_CASE("reasons, tolerances and comments are people's to edit") {
  const auto [text, line] = edited("why ", "why a better reason\n# a remark\n\ntolerance final/* abs 1e-9 why \"w\"");
  CHECK(readGolden(text, "x.golden").rules.size() == 1);
}

TEST_CASE("every truncated golden is refused, wherever it ends") {
  const std::string text = writeGolden(exampleGolden());
  for (std::size_t size = 0; size < text.size(); ++size) {
    INFO("the first " << size << " bytes");
    CHECK_THROWS_AS(readGolden(text.substr(0, size), "x.golden"), InputError);
  }
  complains("", 1, "the file is empty");
  complains(text.substr(0, text.find("\nend") + 1), lastLine() - 1, "truncated");
  complains(text.substr(0, text.size() - 5), lastLine(), "truncated");
}

TEST_CASE("every edited digit of a golden is seen") {
  const std::string text = writeGolden(exampleGolden());
  const std::size_t begin = text.find("\n# count"), why = text.find("\nwhy"), by = text.find("\naccepted_by");
  bool comment = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') comment = text[i + 1] == '#';
    if (comment || text[i] == '\n' || (i > by && i < begin && i != why)) continue;
    std::string other = text;
    other[i] = other[i] == '1' ? '2' : '1';
    INFO("character " << i << " of '" << text.substr(text.rfind('\n', i) + 1, 40));
    CHECK_THROWS_AS(readGolden(other, "x.golden"), InputError);
  }
}

TEST_CASE("every lost line of a golden is seen") {
  for (const std::string& line : linesOf(writeGolden(exampleGolden()))) {
    if (line.empty() || line[0] == '#') continue;
    INFO(line);
    CHECK_THROWS_AS(readGolden(edited(line, "").first, "x.golden"), InputError);
  }
}

TEST_CASE("merge markers") {
  for (const char* marker : {"<<<<<<< HEAD", "|||||||", "=======", ">>>>>>> theirs"})
    complains("count cells 1", marker, "merge marker");
}

TEST_CASE("how fast runs part is kept, and cannot be edited") {
  Golden golden = exampleGolden();
  golden.growth = {{1e-15, 3}, {1e-9, 700}};
  const std::string text = writeGolden(golden);
  CHECK_THAT(text, ContainsSubstring("\ngrowth 1e-15 3\ngrowth 1e-09 700\n"));
  CHECK(writeGolden(readGolden(text, "x.golden")) == text);
  const auto replaced = [&](const std::string& by) { return with(text, "growth 1e-09 700", by); };
  CHECK_THROWS_WITH(readGolden(replaced("growth 1e-09 900"), "x"),
                    ContainsSubstring("were edited after they had been accepted"));
  for (const char* line : {"growth", "growth 1e-9", "growth 0 7", "growth x 7", "growth 1e-9 -7", "growth 1e-9 7 8"})
    CHECK_THROWS_WITH(readGolden(replaced(line), "x"), ContainsSubstring("x:10: "));
}

TEST_CASE("a long chain is thinned, and its last link stays") {
  GoldenFacts facts = exampleFacts();
  facts.chain.clear();
  for (std::uint64_t i = 0; i <= 200; ++i) facts.chain.push_back({64 * i, {i, i}, {}});
  const GoldenData data = makeGoldenData(facts);
  std::vector<std::string> steps;
  for (const auto* link : all<GoldenLink>(data)) steps.push_back(std::to_string(link->step));
  CHECK(steps.size() == 51);  // every fourth of 201
  CHECK(steps[1] == "256");
  CHECK(steps.back() == "12800");
}

TEST_CASE("line ends of another system are the same text, a mixture of both is not") {
  const std::string text = writeGolden(exampleGolden());
  std::string other;
  for (const char c : text) other += c == '\n' ? std::string("\r\n") : std::string(1, c);
  CHECK(writeGolden(readGolden(other, "example.golden")) == text);
  complains("count cells 1", "count cells 1\r", "*.golden -text");
}

TEST_CASE("lines that cannot be understood are named") {
  complains("morula golden 2", "morula golden 3", "no golden file of this version");
  complains("scenario ", "scenery x", "scenario is expected here");
  complains("seed ", "seed -1", "seed: '-1'; a whole number from 0 is expected");
  complains("why ", "why ", "why is expected here");
  complains("count cells 1", "counts cells 1", "'counts' begins no line of a golden file");
  complains("count cells 1", "count", "its name is expected");
  complains("count cells 1", "count cells", "count is expected");
  complains("count cells 1", "count cells 01x", "'01x'; a whole number from 0 is expected");
  complains("count cells 1", "count cells -1", "a whole number from 0 is expected");
  complains("count cells 1", "count cells 1 2", "'2' follows the end of the line");
  complains("count cells_ever", "count cells 3", "count cells stands twice, first in line 9");
  complains("cell A", "cell C 1 256 - - alive a4", "path: ");
  complains("cell A", "cell A 1 256 -", "ended_step is expected");
  complains("cell A", "cell A - 256 - - alive a4", "born: '-'; a finite number");
  complains("cell A", "cell A 1.0 256 - - alive a4", "'1.0'; a finite number, written as shortly as it can be");
  complains("value final/A/y", "value final/A/y 1024 nan", "'nan'; a finite number");
  complains("value final/A/y", "value final/A/y 1024 0.10000000000000001", "written as shortly");
  complains("bits", "bits solver 123", "'123'; a hash of 32 hexadecimal digits");
  complains("time_step 0", "time_step x 0 1", "step: 'x'; a whole number");
  complains("end", "end many", "`end ITEMS DIGEST` is expected");
  complains("end", "end 36 00000000000000000000000000000000", "has 37 items, but 36 were accepted");
  complains("end", "end 37 00000000000000000000000000000000", "were edited after they had been accepted");
  complains(writeGolden(exampleGolden()) + "count x 1\n", lastLine() + 1, "'count x 1' follows the end of the file");
}

TEST_CASE("a large lineage is counts and one digest per generation") {
  GoldenFacts facts = exampleFacts();
  facts.mechanics = false;
  facts.lineage.clear();
  std::vector<CellPath> generation{CellPath{}};
  for (int depth = 0; depth <= 12; ++depth) {
    std::vector<CellPath> next;
    for (const CellPath& p : generation) {
      LineageEntry e = cell("", depth, 0, depth < 12 ? Fate::divided : Fate::alive, 1, depth + 1);
      e.path = p;
      facts.lineage.push_back(e);
      next.push_back(p.daughter(false));
      next.push_back(p.daughter(true));
    }
    generation = std::move(next);
  }
  const GoldenData data = makeGoldenData(facts);
  CHECK(all<GoldenGeneration>(data).size() == 13);
  CHECK(data.items.size() < 40);

  Golden golden = exampleGolden();
  golden.data = data;
  golden = reread(golden);
  CHECK(compareGolden(golden, data).passed());
  facts.lineage[5000].state = 2;
  const CheckReport report = compareGolden(golden, makeGoldenData(facts));
  CHECK_FALSE(report.passed());
  CHECK_THAT(describe(report), ContainsSubstring("generation 12: the hash differs from the accepted one"));
}

TEST_CASE("every shipped golden is written again as it stands, byte for byte") {
  int goldens = 0;
  for (const auto& file : filesBelow("golden", ".golden")) {
    CAPTURE(file.string());
    CHECK(writeGolden(readGoldenFile(file)) == readFile(file));
    ++goldens;
  }
  CHECK(goldens > 50);
}
