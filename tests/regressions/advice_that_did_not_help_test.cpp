// A cell inside out always led to the advice to lower physics.time_step, which in 9 of 11 cases changed nothing: the
// contents' rest volume was not the mesh's, or contact was too soft. Now the advice has been tried.
#include "catch.h"
#include "launch.h"

using namespace morula::test;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string onlyCell(const std::string& physics) {
  return "morula: 1\nname: one\ndna: 'START: a'\nstop: {time: 2}\nphysics:\n  mesh: {icosphere: 1}\n" + physics;
}

}  // namespace

TEST_CASE("contents at rest with a fortieth of the mesh's volume: the failure names pressure, not the time step") {
  const std::string squeezed = "  membrane: {stiffness: 1}\n  pressure: {constant: 2, outside: 20}\n";
  const auto run = runText(onlyCell(squeezed));
  CAPTURE(run.err);
  REQUIRE(run.code == 4);
  CHECK(has(run.err, "outer pressure did "));
  CHECK(has(run.err, "of the work"));
  CHECK(has(run.err, "stability limit"));
  CHECK(has(run.err, "physics.pressure.outside"));
  CHECK(has(run.err, "helps: use it"));
  CHECK(!has(run.err, "lower physics.time_step"));
  // The advice helps.
  const auto at = run.err.rfind("physics.pressure.outside ") + std::string("physics.pressure.outside ").size();
  const std::string value = run.err.substr(at, run.err.find(' ', at) - at);
  CHECK(runText(onlyCell("  membrane: {stiffness: 1}\n  pressure: {constant: 2, outside: " + value + "}\n")).code == 0);
}

TEST_CASE("a failure reads the same with any number of threads") {
  const TemporaryFolder folder;
  writeWhole(folder / "s.yaml", onlyCell("  pressure: {constant: 0}\n"));
  const auto said = [&](const char* threads) {
    return endsWith(4, {"run", folder / "s.yaml", "--out", folder / threads, "--threads", threads}).err;
  };
  CHECK(said("1") == said("2"));
}
