#include "bench/bullet_subject.h"

#include <algorithm>

#include "mesh/mesh_measures.h"
#include "system/clock.h"

namespace morula {
namespace {

constexpr double margins[] = {0.0025, 0.005, 0.01, 0.02};  // [share radii]
constexpr int maxIterations = 4;
// Morula's cells at rest press on each other. Bullet pushes them apart to its own distance, and meanwhile finds five
// times as many contacts. After about 40 steps their number stays.
constexpr int settlingSteps = 40;
constexpr int warmUpSteps = 3, timedSteps = 5;
constexpr std::size_t fastest = 3;  // number of settings that are timed in every round

/// Returns true if no cell is crushed, inside out or NaN: Bullet continues, but its time means nothing.
bool areWhole(const BulletScene& scene, const std::vector<Body>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double before = measureVolume(scene.cells[i].position, scene.mesh.faces),
                 now = measureVolume(cells[i].position, scene.mesh.faces);
    if (!(now > 0.5 * before && now < 2 * before)) return false;
  }
  return true;
}

}  // namespace

BulletSubject::BulletSubject(const BulletScene& scene, double shareRadius, Run run)
    : scene_(scene), shareRadius_(shareRadius), run_(std::move(run)) {
  scene_.physics.integrator = Integrator::velocityVerlet;
}

double BulletSubject::vertices() const { return double(scene_.cells.size()) * double(scene_.mesh.vertices.size()); }

BulletResult BulletSubject::ask(double margin, int iterations, const std::vector<Body>& start, int steps) const {
  BulletRequest request{scene_, steps};
  request.scene.cells = start;
  request.scene.margin = margin * shareRadius_;
  request.scene.iterations = iterations;
  return run_(request);
}

void BulletSubject::settle() {
  for (const double margin : margins) {
    settled_.push_back(ask(margin, 1, scene_.cells, settlingSteps).cells);
    for (int iterations = 1; iterations <= maxIterations; ++iterations) timings_.push_back({margin, iterations});
  }
}

void BulletSubject::time(BulletSettingRow& timing) {
  const auto which = std::find(std::begin(margins), std::end(margins), timing.margin) - std::begin(margins);
  const BulletResult result =
      ask(timing.margin, timing.iterations, settled_[static_cast<std::size_t>(which)], warmUpSteps + timedSteps);
  if (!areWhole(scene_, result.cells)) return;
  for (int i = warmUpSteps; i < warmUpSteps + timedSteps; ++i)
    timing.samples.push_back(result.stepSeconds[static_cast<std::size_t>(i)] / vertices());
  timing.nsPerVertexStep = 1e9 * median(timing.samples);
}

void BulletSubject::round() {
  const bool first = settled_.empty();
  if (first) settle();
  std::ranges::stable_sort(timings_, {}, &BulletSettingRow::nsPerVertexStep);
  for (std::size_t i = 0; i < (first ? timings_.size() : std::min(fastest, timings_.size())); ++i) time(timings_[i]);
}

std::vector<BulletSettingRow> BulletSubject::timings() const {
  std::vector<BulletSettingRow> list = timings_;
  std::erase_if(list, [](const BulletSettingRow& t) { return t.samples.empty(); });
  std::ranges::stable_sort(list, {}, &BulletSettingRow::nsPerVertexStep);
  return list;
}

}  // namespace morula
