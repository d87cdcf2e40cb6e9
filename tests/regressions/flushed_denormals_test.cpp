// A preloaded library that made the processor flush denormal numbers to zero, or round upward, changed results. An
// ordinary run of the same scene was then reported as having changed input. Now the program sets rounding and denormals
// itself.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"
#include "stored.h"

using namespace morula;
using namespace morula::test;

namespace {

struct Seen {
  std::string stateHash, fpEnvironment;
};

Seen runWith(const std::string& rounding, const std::string& threads) {
  const TemporaryFolder folder;
  Environment environment;
  if (!rounding.empty())
    environment = {{"LD_PRELOAD", MORULA_OTHER_ROUNDING},
                   {"OTHER_ROUNDING", rounding},
                   {"ASAN_OPTIONS", "verify_asan_link_order=0:detect_leaks=0"}};
  const auto file = folder / "runs.db";
  const auto run =
      succeeds({"run", "scenarios/hard/denormal-velocity.yaml", "--json", "--quiet", "--no-pictures", "--no-check",
                "--threads", threads, "--set", "stop.time=0.25", "--db", file, "--out", folder / "out"},
               environment);
  Database db = opened(file);
  Statement environmentOfRun(db, "SELECT fp_environment FROM run");
  REQUIRE(environmentOfRun.next());
  return {nlohmann::json::parse(run.out).at("state_hash"), environmentOfRun.text(0)};
}

}  // namespace

TEST_CASE("the environment's rounding and denormals change no result") {
  const Seen usual = runWith("", "1");
  CHECK(usual.fpEnvironment.find("nearest, denormals kept") == 0);
  for (const char* rounding : {"flush", "up"})
    for (const char* threads : {"1", "2"}) {
      CAPTURE(rounding, threads);
      const Seen other = runWith(rounding, threads);
      CHECK(other.stateHash == usual.stateHash);
      CHECK(other.fpEnvironment == usual.fpEnvironment);
    }
}
