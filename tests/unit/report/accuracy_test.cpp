// Pages of accuracy runs: the verdict, the cheapest settings, and texts that stay texts.
#include "accuracy/accuracy.h"

#include <fstream>

#include "catch.h"
#include "report/parts.h"
#include "temporary_folder.h"

namespace morula {
namespace {

Json setting(const std::string& integrator, double timeStep) {
  return {{"integrator", integrator}, {"time_step", timeStep}, {"automatic_share", nullptr},
          {"icosphere", 2},           {"substeps", 1},         {"precision", "double"},
          {"contact_law", nullptr},   {"cell_model", nullptr}, {"set", {"physics.integrator=" + integrator}}};
}

/// By quantity; that of volumes is the largest.
Json sizes(double volume) {
  Json json = Json::object();
  for (const ErrorQuantity& q : errorQuantities) json[q.name] = q.of == &StateError::volume ? volume : 0.0;
  return json;
}

Json row(const std::string& engine, const std::string& series, double timeStep, double error, double seconds) {
  Json errors = sizes(error);
  errors["birth_times"] = 0.0;
  return {{"settings", setting("rk4", timeStep)},
          {"engine", engine},
          {"series", series},
          {"error", error + 0.01},
          {"parts", {{"time", error}, {"mesh", 0.01}, {"precision", 1e-15}, {"model", nullptr}}},
          {"error_on_scenario_mesh", error},
          {"divided_elsewhere", nullptr},
          {"errors", errors},
          {"resolved", true},
          {"lineages_part_at", nullptr},
          {"until", 1.0},
          {"cpu_seconds", seconds},
          {"force_evaluations", 100},
          {"vertex_steps", 4200},
          {"steps", 100},
          {"failed", false},
          {"failure", nullptr}};
}

/// What accuracy --json would say of four runs.
Json output() {
  const Json most = sizes(0.01);
  const Json level{{"icosphere", 2}, {"error", 0.01}, {"largest", most}, {"at_end", most}};
  Json rows = Json::array();
  rows.push_back(row("morula", "velocity-verlet", 0.25, 0.05, 1));
  rows.push_back(row("morula", "rk4", 0.25, 0.0005, 2));
  rows.push_back(row("bullet-b1", "bullet b1", 0.125, 0.04, 3));
  rows.push_back(row("bullet-b1", "bullet b1", 0.0625, 0.03, 6));
  return {{"morula", 1},
          {"scenario", "<script>alert(1)</script>"},
          {"times", {0.5, 1.0}},
          {"end", 2.0},
          {"reference",
           {{"settings", setting("rk4", 0.01)},
            {"own_error", 1e-6},
            {"observed_order", 4.0},
            {"witness", setting("velocity-verlet", 0.01)},
            {"witness_distance", 1e-7},
            {"witness_own_error", 1e-7},
            {"agrees", true}}},
          {"mesh",
           {{"error", 0.01},
            {"unknown", nullptr},
            {"limit", nullptr},
            {"icosphere", 2},
            {"levels", Json::array({level})},
            {"order", 2.0},
            {"order_is_observed", true},
            {"surface_at_start", 0.0},
            {"until", 1.0},
            {"lineages_part_at", nullptr},
            {"divided_elsewhere", nullptr},
            {"cells_touch", true},
            {"time_error", 0.0},
            {"cpu_seconds", 1.0}}},
          {"as_it_is", row("morula", "as it is", 0.25, 0.05, 1)},
          {"rival", nullptr},
          {"rows", rows},
          {"orders", Json::array()},
          {"speed_at_error", Json::array()},
          {"beside_bullet", Json::array()},
          {"remarks", {"a <remark>"}},
          {"picture", ""}};
}

PagePart partOf(const Json& json) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "a.json";
  std::ofstream(file) << jsonText(json);
  return accuracyPart(file);
}

std::string blockOf(const PagePart& part, const std::string& id) {
  for (const PageSection& section : part.sections)
    if (section.id == id) return htmlOf(section.body);
  return {};
}

TEST_CASE("The cheapest settings for an error are those of the runs made, ours and Bullet's") {
  const AccuracyReport report = accuracyFrom(output());
  REQUIRE(!thatHold(report, 0.1).empty());
  CHECK(thatHold(report, 0.1)[0]->series == "velocity-verlet");
  CHECK(thatHold(report, 0.01).at(0)->series == "rk4");
  CHECK(thatHold(report, 0.1, false).at(0)->setting.timeStep == 0.125);
  CHECK(thatHold(report, 0.01, false).empty());
  CHECK(thatHold(report, 0.0005).empty());  // the reference's own error is added
}

TEST_CASE("An accuracy page says first what does not hold") {
  const auto verdict = [](const Json& json) { return htmlOf(partOf(json).verdict); };
  CHECK_THAT(verdict(output()), ContainsSubstring("error 0.06: 0.05 of the time step, 0.01 of the mesh"));
  CHECK_THAT(verdict(output()), ContainsSubstring("Compared up to time 1 of 2"));
  CHECK_THAT(verdict(output()), !ContainsSubstring("mark bad"));
  Json diverged = output();
  diverged["reference"]["observed_order"] = 0.0;
  CHECK_THAT(verdict(diverged), ContainsSubstring("No converged reference"));
  CHECK_THAT(verdict(diverged), ContainsSubstring("mark bad"));
  Json alone = output();
  alone["reference"]["agrees"] = false;
  CHECK_THAT(verdict(alone), ContainsSubstring("The reference is not confirmed"));
  Json unknown = output();
  unknown["mesh"]["error"] = nullptr, unknown["mesh"]["unknown"] = "it comes from a file";
  unknown["as_it_is"]["parts"]["mesh"] = nullptr;
  CHECK_THAT(verdict(unknown), ContainsSubstring("error at least 0.05: 0.05 of the time step, an unknown part"));
  CHECK_THAT(verdict(unknown), ContainsSubstring("What the mesh adds is not known"));
  Json untargeted = output();
  untargeted["target"] = {{"error", 1e-9}, {"run_to_the_end", nullptr}};
  CHECK_THAT(verdict(untargeted), ContainsSubstring("None of the settings tried holds an error of 1e-09"));
}

TEST_CASE("Bullet's best stands beside ours, and failures have a table of their own") {
  Json json = output();
  json["rows"].push_back(row("morula", "explicit-euler", 0.25, 0, 0));
  Json& failed = json["rows"].back();
  failed["failed"] = true, failed["failure"] = "unstable, \"they\" say";
  failed["error"] = failed["parts"] = failed["errors"] = failed["error_on_scenario_mesh"] = nullptr;
  const PagePart part = partOf(json);
  CHECK_THAT(blockOf(part, "cheapest"), ContainsSubstring("bullet b1, time step 1/8"));
  CHECK_THAT(blockOf(part, "cheapest"), ContainsSubstring("<td>3</td>"));
  CHECK_THAT(blockOf(part, "rows"), ContainsSubstring("What failed"));
  CHECK_THAT(htmlOf(part.verdict), ContainsSubstring("1 of 5 settings failed"));
  const std::string csv = accuracyCsv(json["rows"]);
  CHECK_THAT(csv, ContainsSubstring("true,\"unstable, \"\"they\"\" say\"\r\n"));
  CHECK(csv.starts_with("series,engine,integrator,time_step,"));
}

TEST_CASE("Texts of an accuracy run stay texts, and the page the same; other JSON is refused") {
  const PagePart part = partOf(output());
  std::string all = htmlOf(part.verdict);
  for (const PageSection& section : part.sections) all += htmlOf(section.body);
  CHECK_THAT(all, !ContainsSubstring("<script"));
  CHECK_THAT(all, ContainsSubstring("a &lt;remark&gt;"));
  Json broken = output();
  broken["rows"][0].erase("series");
  CHECK_THROWS_WITH(partOf(broken), ContainsSubstring("none of an accuracy run"));
  CHECK_THROWS_WITH(partOf({{"rows", 3}}), ContainsSubstring("accuracy --json"));
}

}  // namespace
}  // namespace morula
