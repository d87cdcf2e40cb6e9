// morula parts, as users and other programs see it. Times are not judged.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

Json part(const Json& json, const std::string& name) {
  for (const auto& p : json["parts"])
    if (p["part"] == name) return p;
  return {};
}

}  // namespace

TEST_CASE("parts --json: what is engaged, why, and its shares of one whole") {
  const auto json = jsonOf({"parts", uniqueFour});
  CHECK(json["morula"] == 1);
  CHECK(json["scenario"] == "unique-four");
  CHECK(json["cells"] == 4);
  CHECK(json["vertices"] == 162);
  CHECK(json["rehearsed"] == true);
  CHECK(json["remarks"].empty());
  double shares = 0, bytes = 0;
  for (const auto& p : json["parts"]) {
    CAPTURE(p.dump());
    if (!p["engaged"]) {
      CHECK(p["needs"].is_string());
      continue;
    }
    CHECK(p["why"].is_string());
    if (p["share"].is_number()) shares += p["share"].get<double>();
    if (p["bytes"].is_number()) bytes += p["bytes"].get<double>();
    CHECK(p["share"].is_null() == p["ns_per_vertex_step"].is_null());
    CHECK(p["bytes"].is_null() == p["bytes_per_vertex"].is_null());
  }
  CHECK(shares == Approx(1));
  CHECK(bytes == Approx(json["bytes"].get<double>()));
  CHECK(part(json, "drag")["why"] == uniqueFour + ":33:9: physics.drag");
  CHECK(part(json, "hashes")["why"] == "golden file golden/thesis/unique-four.golden");
  CHECK(part(json, "growth")["engaged"] == false);
  CHECK(part(json, "pictures")["seconds"] > 0);
  CHECK(part(json, "pictures")["share"].is_null());
}

TEST_CASE("parts foresees the steps that the run then takes") {
  const TemporaryFolder folder;
  CHECK(jsonOf({"parts", uniqueFour})["steps"] ==
        jsonOf({"run", uniqueFour, "--no-pictures", "--no-check", "--out", folder.path()})["steps"]);
}

TEST_CASE("parts follows changes of the scene and of the search") {
  const auto changed =
      jsonOf({"parts", uniqueFour, "--set", "physics.drag=0", "--search", "aabb-tree", "--isa", "scalar"});
  CHECK(part(changed, "drag")["engaged"] == false);
  CHECK(part(changed, "search")["how"] == "aabb-tree");
  CHECK(part(changed, "search")["why"] == "--search");
  CHECK(part(changed, "golden")["engaged"] == false);  // a changed scene is not compared with the golden
  CHECK(part(changed, "hashes")["why"] == uniqueFour + ":41:8: check");
  CHECK(changed["isa"] == "scalar");
}

TEST_CASE("parts of a lineage: genes only") {
  const auto json = jsonOf({"parts", "scenarios/thesis/elegans-1024.yaml"});
  CHECK(json["cells"] == 1024);
  CHECK(json["vertices"] == 0);
  CHECK(part(json, "bodies")["engaged"] == false);
  CHECK(part(json, "contact")["needs"] == "physics.contact");
  CHECK_THAT(succeeds({"parts", "scenarios/thesis/elegans-1024.yaml"}).out,
             ContainsSubstring("elegans-1024") && ContainsSubstring("4094 genes") &&
                 ContainsSubstring("absent parts, which cost nothing") && !ContainsSubstring("B/vertex"));
}

TEST_CASE("parts: a time step that the scene does not bear is refused, as everywhere") {
  const auto run = endsWith(3, {"parts", uniqueFour, "--set", "physics.time_step=1"});
  CHECK_THAT(run.err, ContainsSubstring("--set physics.time_step") && ContainsSubstring("stability limit"));
}
