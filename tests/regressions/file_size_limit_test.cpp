// With limited file sizes (ulimit -f) the first large write killed the program by SIGXFSZ. Now it ends with exit 6 and
// a sentence, and the database keeps its contents.
#include "catch.h"
#include "hostile.h"
#include "store/store.h"

using namespace morula::test;

TEST_CASE("a limit of file sizes is told, and costs no earlier run") {
  const TemporaryFolder folder;
  const auto scenario = folder / "small.yaml", database = folder / "run.db";
  writeWhole(scenario, smallScene);
  const auto withSeed = [&](const char* seed) {
    return launch({"run", "--quiet", "--no-check", "--no-pictures", "--db", database, "--seed", seed, scenario});
  };
  REQUIRE(withSeed("1").code == 0);
  {
    const Limit files(RLIMIT_FSIZE, 20'000);  // less than the database's size, enough for messages
    refuses(withSeed("2"), 6, "ulimit -f");
  }
  {
    const Limit files(RLIMIT_FSIZE, 2'000);
    refuses({"render", "--quiet", "--style", "lineage", "-o", folder / "a.png", scenario}, 6, "File too large");
  }
  CHECK(readWhole(folder / "a.png").empty());
  CHECK(morula::Store::openForReading(database).runs().size() == 1);
  CHECK(launch({"replay", database}).code == 0);
}
