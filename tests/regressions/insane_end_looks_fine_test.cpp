// Runs that ended with cells crushed to a thousandth, inside each other or out of sight were reported as "done", exit
// 0. Now the end of every run with bodies is measured: a run that is not sane says which cell and why, and exits 1.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

const std::string dividing = "dna: |\n  START: a\n  g1(a|a)\n  g2(divide|a)\n";

/// A scenario of two cells that begin with coinciding centres: contacts separate only surfaces that face each other.
std::string overlapping(const std::string& check = "") {
  return "morula: 1\nname: overlapping\n" + dividing +
         "stop: {time: 0.5}\ncells: [{at: [-5e-10, 0, 0]}, {at: [5e-10, 0, 0]}]\n"
         "physics: {drag: 1, mesh: {icosphere: 1}, contact: {}}\n" +
         check;
}

/// A scenario of three cells, one of them very far away.
const std::string farAway =
    "morula: 1\nname: far\ndna: 'START: a'\nstop: {time: 0.1}\n"
    "physics: {mesh: {icosphere: 1}, contact: {}}\n"
    "cells:\n  - {at: [0, 0, 0]}\n  - {at: [2.5, 0, 0]}\n  - {at: [1e12, 0, 0]}\n";

/// A scenario whose contents at rest hold a fifth of the mesh, with an integrator that gains energy.
const std::string crushed =
    "morula: 1\nname: crushed\n" + dividing +
    "stop: {time: 2.9}\nphysics:\n  integrator: explicit-euler\n  drag: 0.2\n  mesh: {icosphere: 1}\n"
    "  cell: {radius: 1.72}\n  contact: {}\n";

struct Run {
  Launched launched;
  Json json;
};

Run run(const std::string& scenario, const Words& more = {}) {
  Run r{runText(scenario, joined({"--json"}, more)), {}};
  if (!r.launched.out.empty()) r.json = Json::parse(r.launched.out);
  return r;
}

Json failedOf(const Run& r) {
  Json failed = Json::array();
  for (const auto& check : r.json.at("sanity"))
    if (!check.at("passed")) failed.push_back(check);
  return failed;
}

}  // namespace

TEST_CASE("cells that end in one another fail the run, with and without --no-check") {
  for (const Words& more : {Words{}, {"--no-check"}, {"--seed", "7"}}) {
    const Run r = run(overlapping(), more);
    CAPTURE(r.launched.err, r.launched.out);
    CHECK(r.launched.code == 1);
    CHECK(r.json.at("status") == "done");
    CHECK(r.json.at("sane") == false);
    REQUIRE(!failedOf(r).empty());
    CHECK(failedOf(r).dump().find("sanity overlap") != std::string::npos);
    CHECK(r.launched.err.find("physics.contact") != std::string::npos);
  }
}

TEST_CASE("a cell out of sight fails the run, and is named") {
  const Run r = run(farAway);
  CAPTURE(r.launched.err, r.launched.out);
  CHECK(r.launched.code == 1);
  REQUIRE(failedOf(r).size() == 1);
  CHECK(failedOf(r)[0].at("check") == "sanity gap");
  CHECK(failedOf(r)[0].at("cell") == "B");
}

TEST_CASE("a cell that ends crushed does not look fine") {
  const Run r = run(crushed);
  CAPTURE(r.launched.err, r.launched.out);
  CHECK(r.launched.code != 0);
}

TEST_CASE("a scene that is about an end that is not sane says so, and must then not be sane") {
  const std::string excuse = "check: {sane: false, because: it shows what contacts do not know}\n";
  const Run r = run(overlapping(excuse));
  CAPTURE(r.launched.err, r.launched.out);
  CHECK(r.launched.code == 0);
  CHECK(r.json.at("sane") == true);
  const std::string harmless =
      "morula: 1\nname: one\ndna: 'START: a'\nstop: {time: 0.1}\nphysics: {mesh: {icosphere: 1}}\n";
  CHECK(run(harmless).launched.code == 0);
  const Run needless = run(harmless + excuse);
  CHECK(needless.launched.code == 1);
  CHECK(needless.launched.err.find("check.sane") != std::string::npos);
}

TEST_CASE("the results of a run that is not sane are stored as such, and no golden is made of them") {
  const TemporaryFolder folder;
  writeWhole(folder / "s.yaml", overlapping());
  CHECK_THAT(endsWith(1, {"check", folder / "s.yaml", "--json"}).out, ContainsSubstring("\"kind\": \"sanity\""));
  const auto accepted = endsWith(3, {"review", folder / "s.yaml", "--accept", "--why", "as it is", "--by", "a test"},
                                 {{"CI", ""}, {"GITHUB_ACTIONS", ""}});
  CHECK_THAT(accepted.err, ContainsSubstring("nothing accepted"));
}
