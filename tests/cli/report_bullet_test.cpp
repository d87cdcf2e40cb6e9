// Reports of runs with Bullet, and of accuracy runs, as users ask for them.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"
#include "stored.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

const std::string oneCell = R"(morula: 1
name: one
dna: |
  START: a0
  g1(a0|a0)
cycle: {length: 100}
stop: {time: 1}
cells: [{at: [0, 0, 0], stretch: [1.1, 1, 1]}]
physics: {time_step: 0.0078125, integrator: thesis-verlet, drag: 1, mesh: {icosphere: 1}}
record: {every: 0.5}
check: {bullet: {}}
)";

/// Returns the text of the page's element with this id.
std::string element(const std::string& page, const std::string& id) {
  const auto at = page.find("id=\"" + id + "\">");
  if (at == page.npos) return {};
  const auto begin = at + id.size() + 6;
  return page.substr(begin, page.find("</script>", begin) - begin);
}

struct Made {
  TemporaryFolder folder;
  std::string database = folder / "one-0/run.db", page = folder / "page.html";
  bool hasBullet = false;
  Made() {
    writeWhole(folder / "one.yaml", oneCell);
    const auto run = succeeds({"run", folder / "one.yaml", "--out", folder.path(), "--no-pictures"});
    hasBullet = run.err.find("the same in Bullet") != run.err.npos;
  }
  std::string report(const Words& more) {
    succeeds(joined({"report", database, "-o", page, "--quiet"}, more));
    return readWhole(page);
  }
};

}  // namespace

TEST_CASE("A page shows ours, Bullet's and their distance, held to what is stored") {
  Made made;
  const std::string page = made.report({"--frames", "5"});
  if (!made.hasBullet) {
    CHECK_THAT(page, ContainsSubstring("this program was built without it"));
    return;
  }
  CHECK_THAT(page, ContainsSubstring("<h2>Beside Bullet</h2>"));
  CHECK_THAT(page, ContainsSubstring("digit for digit"));
  CHECK_THAT(page, ContainsSubstring("Bullet&#39;s, at time 1") || ContainsSubstring("Bullet's, at time 1"));
  CHECK(page == made.report({"--frames", "5"}));
  const std::string without = made.report({"--frames", "5", "--no-bullet"});
  CHECK_THAT(without, !ContainsSubstring("<h2>Beside Bullet</h2>"));
  // If the explorer was built, it has our run and Bullet's with five frames each.
  if (element(page, "data").empty()) {
    WARN("this build has no explorer");
    return;
  }
  const auto data = Json::parse(element(page, "data"));
  REQUIRE(data["runs"].size() == 2);
  CHECK(Json::parse(element(without, "data"))["runs"].size() == 1);
  CHECK(data["runs"][1]["title"].get<std::string>().starts_with("Bullet 3"));
  for (const int k : {0, 1}) {
    const auto& frames = data["runs"][static_cast<std::size_t>(k)]["frames"];
    REQUIRE(frames.size() == 5);
    CHECK(frames[4][0] == 1.0);
    CHECK(frames[4][1] == 128);
  }
}

TEST_CASE("A check's page shows Bullet, too, and the scenario that differs from it first") {
  const TemporaryFolder folder;
  writeWhole(folder / "one.yaml", oneCell);
  writeWhole(folder / "far.yaml",
             replaced(replaced(oneCell, "bullet: {}", "bullet: {positions: 1e-30}"), "name: one", "name: far"));
  const auto check =
      launch({"check", folder / "one.yaml", folder / "far.yaml", "--reports", folder / "out", "--quiet"});
  CHECK(check.code == 1);  // neither has a golden
  const std::string page = readWhole(folder / "out/report.html");
  if (check.out.find("this build has no Bullet") != check.out.npos) return;
  const auto first = page.find("<section id=\"bullet-1\">"), second = page.find("<section id=\"bullet-2\">");
  REQUIRE(first != page.npos);
  REQUIRE(second != page.npos);
  CHECK_THAT(page, ContainsSubstring("differ by more than the tolerance in 1 of 1 quantity"));
  CHECK_THAT(page, ContainsSubstring("agree within every tolerance"));
}

TEST_CASE("accuracy --json makes a page: its verdict, the cheapest settings, where it comes from, the same bytes") {
  const TemporaryFolder folder;
  writeWhole(folder / "one.yaml", oneCell);
  writeWhole(folder / "a.json",
             succeeds({"accuracy", folder / "one.yaml", "--quick", "--json", "--quiet", "--out", folder.path()}).out);
  const auto page = [&] {
    succeeds({"report", folder / "a.json", "-o", folder / "a.html"});
    return readWhole(folder / "a.html");
  };
  const std::string first = page();
  CHECK(first == page());
  CHECK_THAT(first, ContainsSubstring("one as it is: error "));
  CHECK_THAT(first, ContainsSubstring("Compared up to time 0.25 of 1"));
  CHECK(first.find("id=\"verdict\"") < first.find("id=\"cheapest\""));
  CHECK_THAT(first, ContainsSubstring("Instruction set"));
  CHECK_THAT(first, ContainsSubstring("download=\"settings.csv\""));
  CHECK_THAT(first, ContainsSubstring("morula run " + (folder / "one.yaml") + " --set physics.integrator="));
}
