// The scenarios that the project ships.
#include "helpers.h"

using namespace morula;
using namespace morula::test;

TEST_CASE("every shipped scenario loads, bears its file's name and says what it is") {
  namespace fs = std::filesystem;
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator("scenarios")) {
    if (entry.path().extension() != ".yaml" || entry.path().stem().extension() == ".study") continue;
    INFO(entry.path().string());
    const auto s = loadScenario(entry.path());
    CHECK(s.scene.name == entry.path().stem());
    CHECK(!s.summary.empty());
    CHECK(readScenario(s.resolved, "resolved.json", entry.path().parent_path()).resolved == s.resolved);
    ++count;
  }
  CHECK(count >= 5);
}

TEST_CASE("the thesis' numbers of genes") {
  CHECK(loadScenario("scenarios/thesis/unique-four.yaml").scene.dna.genes.size() == 13);
  CHECK(loadScenario("scenarios/thesis/equal-subtrees.yaml").scene.dna.genes.size() == 13);
  const auto worm = loadScenario("scenarios/thesis/elegans-1024.yaml");
  CHECK(worm.scene.dna.genes.size() == 4094);
  CHECK(!worm.scene.mechanics);
}
