// DNA that divides forever, many cells with fine meshes, and thousands of cells in one place took memory until the
// system killed the program, or ended as a bug (exit code 70). Now predictable cases are refused (exit code 3). A run
// that exceeds its limit ends as a numerical failure (exit code 4), which is stored and says what to change.
#include "catch.h"
#include "launch.h"
#include "stored.h"

using namespace morula;
using namespace morula::test;

namespace {

const std::string endless =
    "morula: 1\nname: endless\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\nstop: {cycles: 40}\n";

std::string cellsAt(int count, double apart, const std::string& mesh) {
  std::string text =
      "morula: 1\nname: many\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {time: 1}\nphysics:\n  mesh: " + mesh +
      "\n  contact: {}\ncells:\n";
  for (int i = 0; i < count; ++i) text += "  - {at: [" + std::to_string(apart * i) + ", 0, 0]}\n";
  return text;
}

}  // namespace

TEST_CASE("a lineage that divides for ever ends at the memory limit, and is stored as failed") {
  for (const std::string physics : {"",
                                    "physics: {mesh: {icosphere: 0}, cell: {model: sphere}, drag: 1, time_step: 0.5}\n"
                                    "division: {plane: random}\n"}) {
    const TemporaryFolder folder;
    writeWhole(folder / "scene.yaml", endless + physics);
    const auto run = endsWith(4, {"run", folder / "scene.yaml", "--quiet", "--no-pictures", "--memory-limit", "2M",
                                  "--db", folder / "runs.db", "--out", folder / "out"});
    CAPTURE(physics, run.out, run.err);
    const std::string text = run.out + run.err;
    for (const char* word : {"memory", "limit of 2 MB", "stop.cells", "--memory-limit", "cell ", "step "})
      CHECK(text.find(word) != std::string::npos);
    Database db = opened(folder / "runs.db");
    Statement status(db, "SELECT status, failure FROM run");
    REQUIRE(status.next());
    CHECK(status.text(0) == "failed");
    CHECK(status.text(1).find("memory") != std::string::npos);
  }
}

TEST_CASE("more cells than memory holds are refused before they are made") {
  const TemporaryFolder folder;
  writeWhole(folder / "scene.yaml", cellsAt(500, 3, "{icosphere: 4}"));
  for (const Words& verb : {Words{"validate"}, {"parts"}, {"run", "--dry-run"}}) {
    const auto run = endsWith(3, joined(verb, {folder / "scene.yaml", "--memory-limit", "100M"}));
    for (const char* word : {"cells: 500 cells of 2562 vertices", "limit of 100 MB", "--memory-limit"})
      CHECK_THAT(run.err, ContainsSubstring(word));
  }
}

TEST_CASE("cells that all stand in one place are refused: each vertex would have all others near it") {
  const TemporaryFolder folder;
  writeWhole(folder / "scene.yaml", cellsAt(200, 0, "{icosphere: 1}"));
  for (const char* search : {"grid", "aabb-tree", "spatial-hash", "brute-force"}) {
    const auto run = endsWith(3, {"parts", folder / "scene.yaml", "--memory-limit", "30M", "--search", search});
    for (const char* word : {"within reach of each other", "30 MB", "physics.contact.radius"})
      CHECK_THAT(run.err, ContainsSubstring(word));
  }
}

TEST_CASE("a size is a number and a letter") {
  for (const char* size : {"200000000", "1.5G", "300M", "1T"}) {
    CAPTURE(size);
    CHECK(launch({"validate", "scenarios/organisms/spheres.yaml", "--memory-limit", size}).code == 0);
  }
}
