// `render --time 99` of a run that ends at 10 silently drew the end; `--time 0`, which is a sample, was refused.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;

namespace {

const std::string head = "morula: 1\nname: s\ncycle: {length: 0.125}\ndna: |\n  START: a\n  g1(a|a)\n";
const std::string bodies = "physics:\n  mesh: {icosphere: 0}\n";

Launched rendered(const std::string& text, const std::string& time, const std::string& style = "solid") {
  const TemporaryFolder folder;
  writeWhole(folder / "s.yaml", text);
  return launch({"render", folder / "s.yaml", "--time", time, "--size", "64", "--style", style, "--json", "-o",
                 folder / "s.png"});
}

}  // namespace

TEST_CASE("render refuses times after the end of the run, planned or not") {
  for (const auto& [rest, style] : {std::pair<std::string, std::string>{"stop: {time: 1}\n" + bodies, "solid"},
                                    {"stop: {cycles: 8}\n" + bodies, "solid"},
                                    {"stop: {cycles: 8}\n", "lineage"},
                                    {"  g2(divide|a)\nstop: {cells: 2}\n" + bodies, "solid"},
                                    {"  g2(die|a)\nstop: {time: 1}\n" + bodies, "solid"}}) {
    const auto run = rendered(head + rest, "0.99", style);
    const auto late = rendered(head + rest, "99", style);
    CAPTURE(rest, late.err, run.err);
    refuses(late, 2, "--time: 99 is after the end of the run, ");
    const bool endsEarly = rest.find("g2") != rest.npos;
    CHECK(run.code == (endsEarly ? 2 : 0));
    if (endsEarly) CHECK(run.err.find("after the end of the run, 0.125") != std::string::npos);
  }
}

TEST_CASE("render draws the start, and the end itself") {
  for (const std::string style : {"solid", "lineage"}) {
    const auto start = rendered(head + "stop: {time: 1}\n" + bodies, "0", style);
    CAPTURE(start.err);
    REQUIRE(start.code == 0);
    CHECK(nlohmann::json::parse(start.out)["time"] == 0);
    CHECK(rendered(head + "stop: {time: 1}\n" + bodies, "1", style).code == 0);
    CHECK(rendered(head + "stop: {time: 1}\n", "0", "lineage").code == 0);
  }
  CHECK(rendered(head + "stop: {time: 1}\n" + bodies, "-1").code == 2);
}
