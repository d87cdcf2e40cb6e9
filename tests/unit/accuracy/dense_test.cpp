// Stated errors cover what a dense test finds at other times. Only `./morula test --all` runs it.
#include <algorithm>
#include <cmath>

#include "accuracy/run_distance.h"
#include "catch.h"
#include "reader.h"
#include "system/clock.h"

using namespace morula;

namespace {

struct DenseScene {
  std::string name, physics, rest;  // `physics`: further keys of that block; `rest`: further blocks
};

const std::string still = "dna: |\n  START: a0\n  g1(a0|a0)\n";
const std::string cleaving = "dna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\n";
const std::string soft =
    "  membrane: {stiffness: 10, damping: 0.02}\n  pressure: {constant: 8, outside: 0}\n  cell: {radius: 1, mass: 1}\n";
const std::string taut =
    "  membrane: {stiffness: 10, damping: 0.02}\n  pressure: {constant: 800, outside: 166}\n"
    "  cell: {radius: 1, mass: 1}\n";
const std::string growing =
    "  membrane: {stiffness: 10, damping: 0.02, production: 1.26}\n  pressure: {constant: 172, outside: 47}\n"
    "  cell: {radius: 0.95, mass: 1}\n";
const std::string tight = "  shell: {ellipsoid: [1.95, 1.3, 1.3]}\n  contact: {}\n  drag: 8\n";
const std::string pressed =
    "cells:\n  - {at: [-0.85, 0, 0], stretch: [0.8, 0.8, 0.8]}\n  - {at: [0.85, 0, 0], stretch: [0.8, 0.8, 0.8]}\n";
const std::string turned =
    "cells:\n  - {at: [-0.85, 0, 0], stretch: [0.8, 0.8, 0.8], turn: [20, 30, 40]}\n"
    "  - {at: [0.85, 0, 0], stretch: [0.8, 0.8, 0.8], turn: [-50, 10, 70]}\n";

/// Returns two cells that fly at each other along x with the given speed, apart along y by `aside`.
std::string meeting(const std::string& speed, const std::string& aside) {
  return still + "stop: {time: 1}\ncells:\n  - {at: [-1.3, 0, 0], velocity: [" + speed + ", 0, 0]}\n  - {at: [1.3, " +
         aside + ", 0], velocity: [-" + speed + ", 0, 0]}\n";
}

const std::vector<DenseScene> denseScenes{
    {"swinging", soft + "  drag: 4\n", still + "stop: {time: 1}\n"},
    {"ringing", soft + "  drag: 0.5\n",
     still + "stop: {time: 2}\ncells:\n  - {at: [0, 0, 0], stretch: [1.2, 1, 0.8]}\n"},
    {"meeting", soft + "  contact: {}\n", meeting("1", "0")},
    {"meeting-fast", soft + "  contact: {}\n", meeting("3", "0")},
    {"grazing", soft + "  contact: {}\n", meeting("1.5", "1.2")},
    {"grazing-rubbing", soft + "  contact: {viscosity: 0.3}\n", meeting("1.5", "1.2")},
    {"meeting-slowed", soft + "  contact: {}\n  drag: 4\n", meeting("3", "0.3")},
    {"meeting-rk4", soft + "  contact: {}\n  integrator: rk4\n", meeting("1", "0.2")},
    {"meeting-symplectic", soft + "  contact: {}\n  integrator: symplectic-euler\n", meeting("1", "0.2")},
    {"sticking", soft + "  contact: {adhesion: 0.3}\n  drag: 2\n", meeting("1", "0")},
    {"pressed", taut + tight, still + "stop: {time: 2}\n" + pressed},
    {"pressed-turned", taut + tight, still + "stop: {time: 2}\n" + turned},
    {"pressed-single", taut + tight + "  precision: single\n", still + "stop: {time: 1}\n" + pressed},
    {"falling", soft + "  shell: {sphere: 2}\n  contact: {}\n",
     still + "stop: {time: 1}\ncells:\n  - {at: [0.5, 0, 0], velocity: [2, 0, 0]}\n"},
    {"row", soft + "  contact: {}\n  drag: 4\n",
     still + "stop: {time: 1}\ncells:\n  - {at: [-2.2, 0, 0], velocity: [2, 0, 0]}\n  - {at: [0, 0.1, 0]}\n"
             "  - {at: [2.2, 0, 0.2], velocity: [-2, 0, 0]}\n"},
    {"cleaving", growing + "  shell: {sphere: 1}\n  contact: {}\n  drag: 20\n",
     cleaving + "cycle: {length: 0.5}\nstop: {time: 1.25}\n"},
    {"cleaving-alternating",
     growing + "  shell: {ellipsoid: [1.1, 1.1, 0.83], fill: 0.75}\n  contact: {}\n  drag: 20\n",
     cleaving + "cycle: {length: 0.5}\nstop: {time: 1.25}\ndivision: {plane: {alternating: [1, 0, 0]}}\n"},
    {"cleaving-free", growing + "  contact: {}\n  drag: 8\n", cleaving + "cycle: {length: 0.5}\nstop: {time: 0.95}\n"},
    {"cleaving-twice",
     growing + "  time_step: 0.001953125\n  shell: {ellipsoid: [1.2, 1, 0.96]}\n  contact: {}\n  drag: 40\n",
     cleaving + "cycle: {length: 0.25}\nstop: {time: 0.7}\n"},
    {"cleaving-bound", growing + "  contact: {}\n  drag: 10\n",
     cleaving + "cycle: {length: 0.5}\nstop: {time: 0.95}\nconnections: {make: at-division, strength: 0.5}\n"},
};

ReadScenario readScene(const DenseScene& scene) {
  const std::string step = scene.physics.find("time_step") == std::string::npos ? "  time_step: 0.00390625\n" : "";
  return reader("morula: 1\nname: " + scene.name + "\n" + scene.rest + "physics:\n  mesh: {icosphere: 1}\n" + step +
                scene.physics);
}

/// Returns 40 multiples of the step up to `end`, evenly spread over those at which the stated errors were not measured.
std::vector<double> otherTimes(double end, double step, const std::vector<double>& stated) {
  std::vector<double> others, times;
  for (int i = 1; i * step <= end; ++i)
    if (!std::ranges::binary_search(stated, i * step)) others.push_back(i * step);
  REQUIRE(others.size() >= 40);
  for (std::size_t i = 0; i < 40; ++i) times.push_back(others[i * others.size() / 40]);
  return times;
}

/// The largest pressure and contact area of a run.
struct Scale {
  double pressure = 0, area = 0;
};

Scale scaleOf(const Trial& trial) {
  Scale scale;
  for (const Shapes& shapes : trial.shapes) {
    if (shapes.time == 0) continue;  // nothing is compared there
    for (const ComparedCell& cell : shapes.cells) scale.pressure = std::max(scale.pressure, std::abs(cell.pressure));
    for (const ContactMeasures& contact : shapes.contacts) scale.area = std::max(scale.area, contact.at("area"));
  }
  return scale;
}

/// Returns the largest errors at `times`. Pressures and areas are relative to the largest of the times at which errors
/// are stated, too: a few times may miss the largest.
StateError findLargest(const ReadScenario& read, const Setting& setting, const Setting& finer,
                       const std::vector<double>& times, std::vector<double> all) {
  all.insert(all.end(), times.begin(), times.end());
  sortTimes(all);
  const Trial one = runTrial(read, setting, all, {}, 1), other = runTrial(read, finer, all, {}, 1),
              few = runTrial(read, finer, times, {}, 1);
  INFO(one.failure << other.failure);
  REQUIRE((one.failure.empty() && other.failure.empty()));
  StateError error = compareRuns(one, other, read({}).scene.mechanics->physics.cell.radius, {.at = times}).worst;
  const Scale whole = scaleOf(other), part = scaleOf(few);
  error.pressure *= part.pressure / whole.pressure;
  if (whole.area > 0 && part.area > 0) error.contactArea *= part.area / whole.area;
  return error;
}

/// The largest stated errors over the largest found, [quantity]; below 1 where an error is not covered.
struct Coverage {
  std::string scene;
  std::vector<double> ratios;
  bool isCovered() const {
    return std::ranges::all_of(ratios, [](double ratio) { return ratio >= 1; });
  }
};

Coverage cover(const DenseScene& scene) {
  const ReadScenario read = readScene(scene);
  AccuracyOptions options;
  options.brief = true;
  const AccuracyReport report = measureAccuracy(read, options);
  Coverage coverage{scene.name, {}};
  INFO(scene.name << ": " << textOf(describe(report)));
  REQUIRE_FALSE(report.stated.errors.empty());
  Setting own = report.own.setting, half = own, fine = own;
  half.timeStep /= 2, half.precision = Precision::binary64;
  fine.timeStep /= 4, fine.precision = Precision::binary64, *fine.level += 1;
  const auto found = [&](const Setting& a, const Setting& b, double until) {
    return findLargest(read, a, b, otherTimes(until, own.timeStep, report.times), report.times);
  };
  const StateError time = found(own, half, report.stated.errors[0].until),
                   mesh = found(half, fine, report.stated.errors[0].meshUntil.value());
  for (const GoldenError& stated : report.stated.errors)
    for (const ErrorQuantity& q : errorQuantities) {
      // The share of other neighbours of few cells is one of few numbers. Errors of rounding are covered by chance.
      if (stated.quantity != q.name || q.of == &StateError::neighbours) continue;
      if (time.*q.of > 1e-9) coverage.ratios.push_back(stated.worst / time.*q.of);
      if (mesh.*q.of > 1e-9) coverage.ratios.push_back(*stated.meshWorst / mesh.*q.of);
    }
  return coverage;
}

}  // namespace

TEST_CASE("Stated errors cover those at 40 other times in 19 of 20 scenes, and are no more than 4 times as large",
          "[.][dense]") {
  REQUIRE(denseScenes.size() == 20);
  int covered = 0;
  std::vector<double> ratios;
  for (const DenseScene& scene : denseScenes) {
    const Coverage coverage = cover(scene);
    UNSCOPED_INFO(scene.name << ": the least ratio is " << std::ranges::min(coverage.ratios));
    covered += coverage.isCovered();
    ratios.insert(ratios.end(), coverage.ratios.begin(), coverage.ratios.end());
  }
  CHECK(covered >= 19);
  CHECK(median(ratios) <= 4);
}
