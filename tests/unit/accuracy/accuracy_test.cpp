// Accuracy reports: manufactured rows, and one small scene from its settings to its report.
#include "accuracy/accuracy.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "catch.h"
#include "drawing/palette.h"
#include "physics/integrator.h"
#include "reader.h"

using namespace morula;

namespace {

AccuracyRow row(const std::string& series, double timeStep, double error, double seconds,
                Integrator integrator = Integrator::velocityVerlet) {
  AccuracyRow r;
  r.series = series;
  r.setting.integrator = integrator;
  r.setting.timeStep = timeStep;
  r.error = error;
  r.resolved = true;
  r.cpuSeconds = seconds;
  r.forceEvaluations = static_cast<std::uint64_t>(1000 * seconds);
  return r;
}

/// A blown-up cell that oscillates, with enough drag for explicit Euler.
const std::string swinging =
    "morula: 1\nname: swinging\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {time: 1}\n"
    "physics:\n  mesh: {icosphere: 1}\n  membrane: {stiffness: 10, damping: 0.02}\n"
    "  pressure: {constant: 8, outside: 0}\n  drag: 4\n";

const SeriesOrder& orderIn(const AccuracyReport& report, const std::string& series) {
  const auto found = std::ranges::find(report.orders, series, &SeriesOrder::series);
  INFO("series " << series);
  REQUIRE(found != report.orders.end());
  return *found;
}

/// Returns the integrators that have time steps.
std::vector<Integrator> integratorsOfTime() {
  std::vector<Integrator> integrators;
  for (Integrator integrator : valuesOf<Integrator>())
    if (!kindOf(integrator).settles) integrators.push_back(integrator);
  return integrators;
}

}  // namespace

TEST_CASE("Every setting is read back by a scenario as what it is") {
  for (Integrator integrator : integratorsOfTime())
    for (Precision precision : {Precision::binary64, Precision::binary32})
      for (ContactLaw law : {ContactLaw::pair, ContactLaw::thesis}) {
        Setting setting;
        setting.integrator = integrator, setting.precision = precision, setting.law = law;
        setting.timeStep = 0x1p-9, setting.level = 2;
        if (integrator == Integrator::xpbd) setting.substeps = 3;
        const Scenario scenario = reader(swinging + "  contact: {}\n")(changesFor(setting));
        const Setting back = settingOf(scenario, 0x1p-9);
        CHECK(back.integrator == integrator);
        CHECK(back.substeps == setting.substeps);
        CHECK(back.precision == precision);
        CHECK(back.law == law);
        CHECK(back.level == 2u);
        CHECK(scenario.scene.mechanics->physics.timeStep == 0x1p-9);
      }
}

TEST_CASE("Orders and speeds follow from rows; what failed, parted or is not resolved is left out") {
  std::vector<AccuracyRow> rows;
  for (double h : {0.1, 0.05, 0.025}) {
    rows.push_back(row("slow", h, 3.9 * h, 1 / h));
    rows.push_back(row("fast", h, 15.9 * h * h, 2 / h));
  }
  rows.push_back(row("slow", 0.0125, 1e-9, 80));
  rows.back().resolved = false;
  rows.push_back(row("fast", 0.0125, 1e-9, 160));
  rows.back().partedAt = 0.5;
  AccuracyRow failed;
  failed.series = "broken", failed.failure = "why";
  rows.push_back(failed);

  const auto orders = findOrders(rows);
  REQUIRE(orders.size() == 3);
  CHECK(orders[0].observed->slope == Approx(1).epsilon(1e-9));
  CHECK(orders[1].observed->slope == Approx(2).epsilon(1e-9));
  CHECK(orders[0].observed->points == 3);
  CHECK_FALSE(orders[2].observed);

  // Error 0.1: slow takes 1/h s at h = 0.1/3.9, fast 2/h s at h = √(0.1/15.9). Error 0.01: only fast.
  const auto speeds = findSpeeds(rows, "slow");
  REQUIRE(speeds.size() == 3);
  CHECK(speeds[0].cpuSeconds == Approx(39).epsilon(1e-9));
  CHECK(*speeds[0].speed == Approx(1));
  CHECK(speeds[1].cpuSeconds == Approx(2 / std::sqrt(0.1 / 15.9)).epsilon(1e-9));
  CHECK(*speeds[1].speed == Approx(19.5 * std::sqrt(0.1 / 15.9)).epsilon(1e-9));
  CHECK(speeds[2].series == "fast");
  CHECK_FALSE(speeds[2].speed);

  AccuracyReport report;
  report.rows = rows;
  CHECK(thatHold(report, 0.5).front()->cpuSeconds == 10);
  CHECK(thatHold(report, 0.05).front()->cpuSeconds == 40);
  CHECK(thatHold(report, 0.05).front()->series == "fast");
  CHECK(thatHold(report, 1e-12).empty());
  const auto list = thatHold(report, 0.05);
  CHECK(std::ranges::is_sorted(list, {}, &AccuracyRow::cpuSeconds));
  report.reference.left.error = 0.02;  // is added: 0.03975 + 0.02 > 0.05
  CHECK(thatHold(report, 0.05).front()->cpuSeconds == 80);
}

TEST_CASE("Rivals are as exact as the scene is, between two runs or beyond; Bullet's best is held against ours") {
  const auto ours = [](const char* series, double error, double seconds) { return row(series, 0, error, seconds); };
  const auto bullets = [](const char* baseline, double error, double seconds) {
    AccuracyRow r = row(std::string("bullet ") + baseline, 0, error, seconds);
    r.engine = parseChoice<MeasuredEngine>(std::string("bullet-") + baseline);
    return r;
  };
  const AccuracyRow own = ours("as it is", 0.01, 8);
  // A line through 1 s at 0.1 and 100 s at 0.001 gives 10 s at 0.01. A run of 4 s at 0.002 is more exact than required.
  std::vector<AccuracyRow> rows{ours("slow", 0.1, 1), ours("slow", 0.001, 100), bullets("b1", 0.1, 30),
                                bullets("b1", 0.001, 3000), bullets("b2", 0.2, 1)};
  REQUIRE(findRival(own, rows));
  CHECK(findRival(own, rows)->series == "slow");
  CHECK(findRival(own, rows)->speed == Approx(0.8));
  rows.push_back(ours("single", 0.002, 4));
  CHECK(findRival(own, rows)->series == "single");
  CHECK(findRival(own, rows)->speed == Approx(2));
  rows.back().partedAt = 1;  // a run with other cells does not count
  CHECK(findRival(own, rows)->series == "slow");
  rows.back().partedAt.reset();

  const auto speeds = compareSpeeds(rows);
  REQUIRE(speeds.size() == 3);  // at errors 0.1, 0.01, 0.001
  CHECK(speeds[0].ours == "slow");
  CHECK(speeds[1].error == Approx(0.01));
  CHECK(speeds[1].ours == "single");
  CHECK(speeds[1].ourSeconds == 4);
  CHECK(speeds[1].bullets == "bullet b1");
  CHECK(speeds[1].bulletSeconds == Approx(300));
  CHECK(speeds[2].ourSeconds == Approx(100));
}

TEST_CASE("The picture shows a run that parts by a hollow point of its series' colour, joined to nothing") {
  AccuracyReport report;
  report.times = {1};
  report.rows = {row("one", 0.1, 0.1, 1), row("one", 0.05, 0.01, 2), row("one", 0.025, 0.03, 8)};
  const auto inked = [&] {
    const Image picture = drawAccuracy(report).pixels();
    return std::count(picture.pixels.begin(), picture.pixels.end(), seriesColour(0));
  };
  const auto joined = inked();
  report.rows.back().partedAt = 0.5;
  const auto apart = inked();
  CHECK(apart > 0);
  CHECK(apart < joined);
  report.rows.pop_back();
  CHECK(inked() != apart);  // the hollow point has its place on the sheet, and its ring
}

TEST_CASE("A smooth scene: every integrator has its order, and the reference its witness") {
  AccuracyOptions options;
  options.integrators = integratorsOfTime();
  options.levels = {0};
  options.rounds = 1;
  options.cheaperModels = false;  // see cheaper_model_test.cpp
  const AccuracyReport report = measureAccuracy(reader(swinging), options);
  INFO(textOf(describe(report)));
  CHECK(report.reference.agrees);
  CHECK(report.reference.setting.integrator == Integrator::rungeKutta4);
  CHECK(report.times.back() == 1);
  CHECK_FALSE(report.horizon->parted);
  REQUIRE(report.rows.size() == 5 * 9);
  double smallest = 1;
  for (const AccuracyRow& r : report.rows)
    if (r.error && r.resolved) smallest = std::min(smallest, *r.error);
  CHECK(report.reference.left.error <= smallest / 10);

  CHECK(orderIn(report, "velocity-verlet").observed->slope == Approx(2).margin(0.2));
  CHECK(orderIn(report, "rk4").observed->slope == Approx(4).margin(0.2));
  CHECK(orderIn(report, "symplectic-euler").observed->slope == Approx(1).margin(0.2));
  CHECK(orderIn(report, "thesis-verlet").observed->slope == Approx(1).margin(0.2));
  CHECK(orderIn(report, "xpbd, 4 sub-steps").observed->slope == Approx(1).margin(0.2));
  // A coarser mesh is another cell, and no time step makes up for the difference.
  CHECK(std::abs(orderIn(report, "velocity-verlet, icosphere 0").observed->slope) < 0.5);
  for (const AccuracyRow& r : report.rows) {
    if (!r.failure.empty()) {
      // Time steps that an integrator does not bear are reported, not dropped.
      CHECK_THAT(r.failure, ContainsSubstring("physics.time_step"));
      continue;
    }
    CHECK(r.steps == static_cast<std::uint64_t>(1 / r.setting.timeStep));
    const bool four = r.setting.integrator == Integrator::rungeKutta4 || r.setting.substeps == 4u;
    CHECK(r.forceEvaluations == r.steps * (four ? 4 : 1));
    CHECK(r.vertexSteps == r.steps * (r.setting.level == 0u ? 12 : 42));
    CHECK(r.cpuSeconds > 0);
  }
  const Image picture = drawAccuracy(report).pixels();
  CHECK(std::count(picture.pixels.begin(), picture.pixels.end(), seriesColour(0)) > 100);
}

TEST_CASE("A scene without bodies has no error, and says so") {
  const auto read = reader("morula: 1\nname: genes\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {cycles: 1}\n");
  CHECK_THROWS_WITH(measureAccuracy(read, {}), ContainsSubstring("physics") && ContainsSubstring("test.yaml"));
}

TEST_CASE("Cells that touch are compared only up to where chaos begins, unless one insists") {
  const std::string crowd =
      "morula: 1\nname: crowd\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\ncycle: {length: 0.25}\n"
      "stop: {time: 1.5}\nphysics:\n  mesh: {icosphere: 1}\n  drag: 10\n  shell: {sphere: 1}\n"
      "  cell: {radius: 0.95}\n  contact: {}\n";
  AccuracyOptions options = fewSettings();
  const AccuracyReport report = measureAccuracy(reader(crowd), options);
  INFO(textOf(describe(report)));
  CHECK(report.horizon->parted);
  CHECK(report.times.back() <= report.horizon->end);
  CHECK(report.times.back() < 1.5);
  CHECK(report.horizon->rounding > 0);
  CHECK(report.reference.left.error >= report.horizon->rounding / 0.95);
  options.until = 1;
  const AccuracyReport longer = measureAccuracy(reader(crowd), options);
  CHECK(longer.times.back() == 1);
  REQUIRE_FALSE(longer.remarks.empty());
  CHECK_THAT(longer.remarks[0], ContainsSubstring("chaos"));
  CHECK(longer.reference.left.error >= longer.reference.distance);
}
