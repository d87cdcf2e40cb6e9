// Where files may not grow (ulimit -f) the first large write killed the program by SIGXFSZ. It ends with exit 6 and a
// sentence, and the database keeps what it had.
#include <sys/resource.h>

#include <chrono>

#include "catch.h"
#include "hostile.h"
#include "store/store.h"

using namespace morula::test;

namespace {

/// Programs started meanwhile write no file beyond so many bytes.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

}  // namespace

TEST_CASE("a limit of file sizes is told, and costs no earlier run") {
  const TemporaryFolder folder;
  const auto scenario = folder / "small.yaml", database = folder / "run.db";
  writeWhole(scenario, smallScene);
  const std::vector<std::string> run{"run", "--quiet", "--no-check", "--no-pictures", "--db", database, "--seed"};
  const auto withSeed = [&](const char* seed) {
    auto words = run;
    words.insert(words.end(), {seed, scenario});
    return launch(words);
  };
  REQUIRE(withSeed("1").code == 0);
  {
    const FileSizeLimit limit(20'000);  // less than the database has, enough for messages
    const auto refused = withSeed("2");
    CAPTURE(refused.err);
    CHECK(refused.code == 6);
    CHECK(refused.err.find("ulimit -f") != std::string::npos);
  }
  {
    const FileSizeLimit limit(2'000);
    const auto picture = launch({"render", "--quiet", "--style", "lineage", "-o", folder / "a.png", scenario});
    CAPTURE(picture.err);
    CHECK(picture.code == 6);
    CHECK(picture.err.find("File too large") != std::string::npos);
  }
  CHECK(readWhole(folder / "a.png").empty());
  CHECK(morula::Store::openForReading(database).runs().size() == 1);
  CHECK(launch({"replay", database}).code == 0);
}
