// Only people may write a golden, and with a reason.
#include "golden/accept.h"

#include <stdlib.h>

#include "catch.h"
#include "example_facts.h"
#include "golden/project_files.h"
#include "temporary_folder.h"

using namespace morula;

namespace {

/// Sets the environment variable CI, and restores it afterwards.
class Ci {
 public:
  explicit Ci(const char* value) {
    if (const char* before = getenv("CI")) before_ = before;
    if (value) setenv("CI", value, 1);
    else unsetenv("CI");
  }
  ~Ci() {
    if (before_) setenv("CI", before_->c_str(), 1);
    else unsetenv("CI");
  }

 private:
  std::optional<std::string> before_;
};

std::size_t filesIn(const std::filesystem::path& folder) {
  const std::filesystem::directory_iterator files(folder);
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

}  // namespace

TEST_CASE("an accepted golden passes, and says who and why") {
  const Ci ci(nullptr);
  TemporaryFolder folder;
  const auto file = folder / "golden/thesis/example.golden";
  acceptGolden(file, exampleGolden({rule("final/* rel 1e-12 why \"w\"")}), {"A. Tester", "first result"});
  const Golden golden = readGoldenFile(file);
  CHECK(golden.acceptedBy == "A. Tester");
  CHECK(golden.why == "first result");
  CHECK(golden.rules.size() == 1);
  CHECK(compareGolden(golden, exampleData()).passed());
  CHECK(filesIn(file.parent_path()) == 1);  // no draft is left

  // A second acceptance replaces the golden.
  acceptGolden(file, exampleGolden(), {"A. Tester", "second result"});
  CHECK(readGoldenFile(file).why == "second result");
  CHECK(filesIn(file.parent_path()) == 1);
}

TEST_CASE("what is refused leaves the golden as it was") {
  TemporaryFolder folder;
  const auto file = folder / "example.golden";
  writeText(file, "the old one");
  const auto refuses = [&](const GoldenData& data, std::vector<ToleranceRule> rules, const Acceptance& acceptance,
                           const char* because) {
    CHECK_THROWS_WITH(acceptGolden(file, {data, "", "", std::move(rules)}, acceptance), ContainsSubstring(because));
    CHECK(readText(file) == "the old one");
    CHECK(filesIn(folder.path()) == 1);
  };
  {
    const Ci ci("true");
    refuses(exampleData(), {}, {"A. Tester", "why"}, "while CI is set");
  }
  const Ci ci(nullptr);
  for (const char* why : {"", "  ", "two\nlines"})
    refuses(exampleData(), {}, {"A. Tester", why}, "a golden is accepted with a reason");
  refuses(exampleData(), {}, {"", "why"}, "who accepts");
  refuses(exampleData(), {rule("nothing abs 1 why \"w\"")}, {"A. Tester", "why"}, "matches no value");
  GoldenFacts broken = exampleFacts();
  broken.end["volume"] = std::numeric_limits<double>::quiet_NaN();
  refuses(makeGoldenData(broken), {}, {"A. Tester", "why"}, "a finite number");
}

TEST_CASE("an empty CI is no CI") {
  const Ci ci("");
  TemporaryFolder folder;
  acceptGolden(folder / "x.golden", exampleGolden(), {"A. Tester", "why"});
  CHECK(std::filesystem::exists(folder / "x.golden"));
}

TEST_CASE("a golden that cannot be written or read") {
  const Ci ci(nullptr);
  TemporaryFolder folder;
  writeText(folder / "file", "");
  CHECK_THROWS_AS(acceptGolden(folder / "file/x.golden", exampleGolden(), {"A. Tester", "why"}), FileError);
  CHECK_THROWS_WITH(readGoldenFile(folder / "none.golden"), ContainsSubstring("there is no golden file"));
  CHECK_THROWS_AS(readGoldenFile(folder / "none.golden"), InputError);
}

TEST_CASE("a scenario's golden lies where its name says") {
  CHECK(goldenName("/a/scenarios/thesis/unique-four.yaml") == "thesis/unique-four");
  CHECK(goldenPath("/a/scenarios/thesis/unique-four.yaml") == "/a/golden/thesis/unique-four.golden");
  CHECK(goldenPath("scenarios/thesis/unique-four.yaml") == "golden/thesis/unique-four.golden");
  CHECK(goldenPath("/a/scenarios/b/scenarios/x.yaml") == "/a/scenarios/b/golden/x.golden");
  CHECK(goldenPath("/a/scenarios/deep/er/x.yaml") == "/a/golden/deep/er/x.golden");
  CHECK(goldenName("/a/elsewhere/x.yaml") == "x");
  CHECK(goldenPath("/a/elsewhere/x.yaml") == "/a/elsewhere/x.golden");
}

TEST_CASE("a scenario named from within its folder has the same golden") {
  TemporaryFolder folder;
  std::filesystem::create_directories(folder / "scenarios/thesis");
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder / "scenarios/thesis");
  const auto path = goldenPath("x.yaml");
  const std::string name = goldenName("x.yaml");
  std::filesystem::current_path(before);
  CHECK(name == "thesis/x");
  CHECK(path.lexically_normal().string().ends_with("/golden/thesis/x.golden"));
}

TEST_CASE("goldens without a scenario are found") {
  TemporaryFolder folder;
  for (const char* name : {"golden/a", "golden/b", "scenarios/a"}) std::filesystem::create_directories(folder / name);
  writeText(folder / "scenarios/a/kept.yaml", "");
  for (const char* name : {"golden/a/kept.golden", "golden/b/lost.golden", "golden/a/lost.golden", "golden/README.md"})
    writeText(folder / name, "");
  const auto orphans = goldensWithoutScenario(folder / "golden", folder / "scenarios");
  REQUIRE(orphans.size() == 2);
  CHECK(orphans[0] == folder / "golden/a/lost.golden");
  CHECK(orphans[1] == folder / "golden/b/lost.golden");
}

TEST_CASE("every golden file that the project ships has its scenario") {
  REQUIRE(std::filesystem::exists("golden/thesis/unique-four.golden"));
  CHECK(goldensWithoutScenario("golden", "scenarios").empty());
}
