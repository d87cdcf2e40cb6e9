// A run short of memory was reported as a bug or broken hardware, for it differed from an earlier one. Drawing crashed
// in OpenGL: exit 70 or a signal. The checkpoint, and with it all computed steps, was thrown away. Now an end for lack
// of memory is compared with nothing, and drawing is refused with a sentence.
#include "catch.h"
#include "hostile.h"
#include "store/store.h"

using namespace morula::test;

namespace {

/// A scenario of twelve divisions without bodies.
const std::string tree =
    "morula: 1\nname: tree\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\nstop: {cycles: 12}\n";

}  // namespace

TEST_CASE("a run that memory fails says nothing against one that came to its end") {
  const TemporaryFolder folder;
  writeWhole(folder / "tree.yaml", tree);
  const Words words{"run",   folder / "tree.yaml", "--quiet", "--no-pictures",  "--no-check",
                    "--out", folder.path(),        "--db",    folder / "run.db"};
  succeeds(words);
  const auto run = endsWith(4, joined(words, {"--memory-limit", "300k"}));
  CHECK_THAT(run.out + run.err, ContainsSubstring("--memory-limit") && !ContainsSubstring("NONDETERMINISM"));
  const auto stored = morula::Store::openForReading(folder / "run.db").runs();
  REQUIRE(stored.size() == 1);
  CHECK(stored[0].status == morula::RunStatus::done);
}

TEST_CASE("a run that memory ends keeps its checkpoint, and goes on from there where there is more") {
  const TemporaryFolder folder;
  writeWhole(folder / "tree.yaml", tree);
  const Words words{"run",  folder / "tree.yaml", "--no-pictures",      "--no-check", "--out", folder.path(),
                    "--db", folder / "run.db",    "--checkpoint-every", "2"};
  endsWith(4, joined(words, {"--memory-limit", "300k"}));
  CHECK_THAT(succeeds(joined(words, {"--resume"})).err, ContainsSubstring("tree continues from step"));
  CHECK(launch({"replay", folder / "run.db"}).code == 0);
}

TEST_CASE("a picture for which there is no memory is refused, and the run is kept") {
  if (!memoryCanBeLimited) return;
  const TemporaryFolder folder;
  writeWhole(folder / "body.yaml", smallBody);
  const auto code = [&](rlim_t limit, const std::string& database) {
    const Limit addresses(RLIMIT_AS, limit);
    const auto run = launch(
        {"run", folder / "body.yaml", "--quiet", "--no-check", "--out", folder.path(), "--db", folder / database});
    CAPTURE(limit, run.err);
    if (run.code == 0) return 0;
    if (run.err.find("loading shared libraries") != std::string::npos) return 2;  // the program itself did not start
    CHECK(run.code == 4);
    CHECK_THAT(run.err, ContainsSubstring("memory"));
    if (run.err.find("to draw") != std::string::npos) {
      CHECK_THAT(run.err, ContainsSubstring("is stored in"));
      CHECK(morula::Store::openForReading(folder / database).runs().at(0).status == morula::RunStatus::done);
      return 1;
    }
    return 2;
  };
  int refused = 0;
  for (rlim_t limit = 160; limit <= 640; limit += 20) refused += code(limit << 20, std::to_string(limit) + ".db") == 1;
  CHECK(refused > 2);
  CHECK(code(8'000'000'000, "plenty.db") == 0);
}

TEST_CASE("an OSMesa that does not fit into memory is told as that") {
  const TemporaryFolder folder;
  const auto run = launch({"render", uniqueFour, "-o", folder / "four.png"}, {{"LD_LIBRARY_PATH", MORULA_LARGE}});
  refuses(run, 4, "there is not enough memory to draw: ");
  CHECK_THAT(run.err,
             ContainsSubstring("failed to map segment from shared object, however small the picture; draw on a machine"));
}
