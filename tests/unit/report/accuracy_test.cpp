// Pages of accuracy runs: the verdict, the cheapest settings, and texts that stay texts.
#include "accuracy/accuracy.h"

#include <fstream>

#include "catch.h"
#include "report/page_parts.h"
#include "temporary_folder.h"

namespace morula {
namespace {

Setting setting(Integrator integrator, double timeStep) {
  Setting setting;
  setting.integrator = integrator, setting.timeStep = timeStep, setting.level = 2;
  return setting;
}

/// Returns an error of volumes alone.
StateError sizes(double volume) { return {.volume = volume}; }

AccuracyRow row(MeasuredEngine engine, const std::string& series, double timeStep, double error, double seconds) {
  AccuracyRow row;
  row.setting = setting(Integrator::rungeKutta4, timeStep);
  row.cpuSeconds = seconds, row.steps = 100, row.forceEvaluations = 100, row.vertexSteps = 4200;
  row.series = series, row.engine = engine;
  row.error = error, row.errors = sizes(error);
  row.parts = {.time = error, .mesh = 0.01, .precision = 1e-15, .model = {}};
  row.until = 1, row.resolved = true;
  return row;
}

/// Returns the output of accuracy --json for four runs.
Json output() {
  AccuracyReport report;
  report.scenario = "<script>alert(1)</script>";
  report.own = row(MeasuredEngine::morula, "as it is", 0.25, 0.05, 1);
  report.mesh.levels = {{2, sizes(0.01), sizes(0.01)}};
  report.mesh.own = 2, report.mesh.order = 2, report.mesh.orderIsObserved = true;
  report.mesh.until = 1, report.mesh.touch = true, report.mesh.cpuSeconds = 1;
  report.times = {0.5, 1}, report.end = 2;
  report.reference = {.setting = setting(Integrator::rungeKutta4, 0.01),
                      .witness = setting(Integrator::velocityVerlet, 0.01),
                      .left = {1e-6, 4},
                      .witnessLeft = {1e-7, 2},
                      .distance = 1e-7,
                      .agrees = true};
  report.rows = {row(MeasuredEngine::morula, "velocity-verlet", 0.25, 0.05, 1),
                 row(MeasuredEngine::morula, "rk4", 0.25, 0.0005, 2),
                 row(MeasuredEngine::bulletB1, "bullet b1", 0.125, 0.04, 3),
                 row(MeasuredEngine::bulletB1, "bullet b1", 0.0625, 0.03, 6)};
  report.stated.errors = {{"position", 0.0004, 0.075, 1, {}, 0.015, 1}};
  report.stated.unstated = {{"mesh", {"a <reason>"}}};
  report.stated.times = 70, report.stated.quietTimes = 31, report.stated.events = 2;
  report.remarks = {"a <remark>"};
  return toJson(report, "");
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

TEST_CASE("An accuracy page shows the errors of the scenario as it is, at rest and at worst") {
  const std::string stated = blockOf(partOf(output()), "stated");
  for (const char* part : {"position [radii of the egg]", "0.0004", "0.075", "0.015", "not known",
                           "compared at 70 times, 31 of them at rest; 2 events", "mesh: a &lt;reason&gt;"})
    CHECK_THAT(stated, ContainsSubstring(part));
  Json without = output();
  without["stated"]["errors"] = without["stated"]["unstated"] = Json::array();
  CHECK(blockOf(partOf(without), "stated").empty());
}

TEST_CASE("An accuracy page says first what does not hold") {
  const auto verdict = [](const Json& json) { return htmlOf(partOf(json).verdict); };
  CHECK_THAT(verdict(output()), ContainsSubstring("error 0.06: 0.05 of the time step, 0.01 of the mesh"));
  CHECK_THAT(verdict(output()), ContainsSubstring("Compared up to time 1 of 2"));
  CHECK_THAT(verdict(output()), !ContainsSubstring("mark bad"));
  Json diverged = output();
  diverged["reference"]["observed_order"] = 0.0;
  CHECK_THAT(verdict(diverged), ContainsSubstring("The reference has not converged"));
  CHECK_THAT(verdict(diverged), ContainsSubstring("mark bad"));
  Json alone = output();
  alone["reference"]["agrees"] = false;
  CHECK_THAT(verdict(alone), ContainsSubstring("The reference is not confirmed"));
  Json unknown = output();
  unknown["mesh"]["error"] = nullptr, unknown["mesh"]["unknown"] = "it comes from a file";
  unknown["as_it_is"]["parts"]["mesh"] = nullptr;
  CHECK_THAT(verdict(unknown), ContainsSubstring("error at least 0.05: 0.05 of the time step, an unknown part"));
  CHECK_THAT(verdict(unknown), ContainsSubstring("The mesh&#39;s error is not known"));
  Json untargeted = output();
  untargeted["target"] = {{"error", 1e-9}, {"run_to_the_end", nullptr}};
  CHECK_THAT(
      verdict(untargeted),
      ContainsSubstring("None of the settings tried has an error of at most <span class=\"whole\">1e-09</span>"));
}

TEST_CASE("Bullet's best stands beside ours, and failures have a table of their own") {
  Json json = output();
  json["rows"].push_back(json["rows"][0]);
  Json& failed = json["rows"].back();
  failed["failed"] = true, failed["failure"] = "unstable, \"they\" say";
  failed["error"] = failed["parts"] = failed["errors"] = failed["error_on_scenario_mesh"] = nullptr;
  const PagePart part = partOf(json);
  CHECK_THAT(blockOf(part, "cheapest"), ContainsSubstring("bullet b1, time step 1/8"));
  CHECK_THAT(blockOf(part, "cheapest"), ContainsSubstring("<td class=\"number\">3</td>"));
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
  CHECK_THROWS_WITH(partOf(broken), ContainsSubstring("not those of an accuracy run"));
  CHECK_THROWS_WITH(partOf({{"rows", 3}}), ContainsSubstring("accuracy --json"));
}

}  // namespace
}  // namespace morula
