// Engine comparisons: from runs to verdicts and a table.
#include "engines/engine_comparison.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <sstream>
#include <thread>

#include "base/error.h"
#include "catch.h"
#include "engines/bullet_scene.h"

using namespace morula;
using End = ExternalRun::End;

namespace {

CheckResult failing(const char* check, const char* expected, const char* actual, std::uint64_t step) {
  CheckResult r;
  r.check = check, r.expected = expected, r.actual = actual;
  r.passed = false;
  r.firstStep = step;
  return r;
}

ExternalRun runWith(End end, std::vector<CheckResult> results = {}, std::string why = "") {
  ExternalRun run;
  run.end = end, run.why = std::move(why), run.step = 12;
  run.results = std::move(results);
  run.volumes = {0.25, 3};
  return run;
}

CheckParameters mustStop() {
  CheckParameters check;
  check.fails = {"inside out"};
  return check;
}

}  // namespace

TEST_CASE("A verdict names all that is broken, in few digits, with its bounds and its step") {
  CHECK(judge({}, runWith(End::done)).text == "holds");
  // A hash may begin like a number that no double holds.
  CHECK(judge({}, CheckReport{"x", {failing("scenario", "725e710d75e6", "1e999", 0)}}).text.find("725e710d75e6") !=
        std::string::npos);
  const Verdict v =
      judge({}, runWith(End::done, {failing("volume", "from 0.5 to 1.5", "from 0.98765432 to 3.2109876", 50),
                                    failing("energy", "at most 0.6", "0.71234567", 9),
                                    failing("end-roundness", "at least 0.95", "0.2", 12)}));
  CHECK(v.kind == Verdict::Kind::breaks);
  CHECK(v.step == 50u);
  CHECK(v.text ==
        "breaks: volume 0.9877 to 3.211 of [0.5, 1.5] at step 50; energy 0.7123 > 0.6 at step 9; "
        "end-roundness 0.2 < 0.95 at step 12");
}

TEST_CASE("A run that ends early says how, and only where it must stop is that well") {
  CHECK(judge({}, runWith(End::stopped, {}, "step 12: its volume is 0; use a smaller step")).text ==
        "stops: step 12: its volume is 0");
  CHECK(judge(mustStop(), runWith(End::stopped, {}, "step 12: inside out")).text == "stops, as it must");
  CHECK(judge(mustStop(), runWith(End::done)).text == "goes on: volume 0.25 to 3 of that at rest");
  CHECK(judge({}, runWith(End::silent, {}, "the engine's answer is cut short")).text ==
        "the engine's answer is cut short, at step 12");
  CHECK(judge({}, runWith(End::broken, {failing("volume", "", "", 12)})).text == "breaks: inside out at step 12");
  CHECK(judge({}, runWith(End::broken, {failing("volume", "", "", 12), failing("extent", "", "nan", 12)})).text ==
        "breaks: no number at step 12");
}

TEST_CASE("Engines are named, and a name that is none is refused") {
  CHECK(parseEngines("thesis,bullet") == std::vector{Engine::thesis, Engine::b1, Engine::b2});
  CHECK(parseEngines("").empty());
  CHECK_THROWS_AS(parseEngines("bulet"), InputError);
  CHECK_THROWS_AS(parseEngines("b1,,b2"), InputError);
}

TEST_CASE("A table has a row for each scenario and a column for each engine; bars do not break it") {
  const std::vector<ComparisonRow> rows{
      {"hard/one", {{Verdict::Kind::holds, "holds", {}}, {Verdict::Kind::notAsked, "a|b", {}}}}};
  CHECK(comparisonTable(rows, {Engine::b1}) ==
        "| case | ours | Bullet, B1 |\n|---|---|---|\n| `one` | holds | a\\|b |\n");
  const Json json = toJson(rows, {Engine::b1});
  REQUIRE(json.size() == 2);
  CHECK(json[0]["engine"] == "morula");
  CHECK(json[1]["verdict"] == "not-asked");
}

TEST_CASE("Whatever goes wrong with a question ends that question alone") {
  // The worker takes no text that is not UTF-8 as DNA. An unexpected kind of error once ended the program from a
  // worker's thread.
  Scenario scenario = readScenario(
      "morula: 1\nname: odd\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {time: 1}\nphysics: {}\n", "odd.yaml", ".");
  scenario.files.push_back({"dna", "odd.dna", "\xff"});
  if (!bulletIsAvailable()) return;
  const auto rows = compareEngines({scenario, scenario}, {{}, {}}, {{Engine::b1, Engine::b2}, 1, true});
  REQUIRE(rows.size() == 2);
  for (const ComparisonRow& row : rows)
    for (const std::size_t engine : {1, 2}) {
      CHECK(row.verdicts[engine].kind == Verdict::Kind::noAnswer);
      CHECK_FALSE(row.verdicts[engine].text.empty());
    }
}

namespace {

/// A slow replacement of stderr, so that others may write in between.
class SlowConsole : public std::streambuf {
 public:
  SlowConsole() : before_(std::cerr.rdbuf(this)) {}
  ~SlowConsole() override { std::cerr.rdbuf(before_); }
  std::string text() const { return text_; }

 protected:
  std::streamsize xsputn(const char* from, std::streamsize n) override {
    {
      const std::lock_guard<std::mutex> alone(mutex_);
      text_.append(from, static_cast<std::size_t>(n));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    return n;
  }
  int overflow(int c) override {
    const char letter = static_cast<char>(c);
    return xsputn(&letter, 1) == 1 ? c : EOF;
  }

 private:
  std::streambuf* before_;
  std::mutex mutex_;
  std::string text_;
};

}  // namespace

TEST_CASE("What several workers tell at a time stays in lines") {
  // Text and line end were once written one after the other, so that lines ran into each other.
  const Scenario scenario =
      readScenario("morula: 1\nname: genes\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {cycles: 1}\n", "genes.yaml", ".");
  std::string told;
  {
    const SlowConsole console;
    compareEngines(std::vector<Scenario>(20, scenario), std::vector<Verdict>(20),
                   {{Engine::thesis, Engine::b1}, 1, false});
    told = console.text();
  }
  std::istringstream lines(told);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    CAPTURE(line);
    CHECK(line.ends_with(": cannot be asked: cells without bodies"));
    CHECK(line.find("cannot be asked") == line.rfind("cannot be asked"));
  }
  CHECK(count == 40);
}

TEST_CASE("The table of the hard cases has a row for every one of them, and no empty cell") {
  std::ifstream page("scenarios/hard/README.md");
  const std::string text{std::istreambuf_iterator<char>(page), {}};
  const auto table = text.find("| case | ours | thesis' contact law | Bullet, B1 | Bullet, B2 |");
  REQUIRE(table != text.npos);
  int cases = 0;
  for (const auto& entry : std::filesystem::directory_iterator("scenarios/hard")) {
    if (entry.path().extension() != ".yaml") continue;
    ++cases;
    const std::string name = entry.path().stem().string();
    INFO(name);
    const auto at = text.find("\n| `" + name + "` | ", table);
    REQUIRE(at != text.npos);
    const std::string row = text.substr(at + 1, text.find('\n', at + 1) - at - 1);
    CHECK(std::count(row.begin(), row.end(), '|') == 6);
    CHECK(row.find("|  |") == row.npos);
  }
  CHECK(cases >= 24);
}
