#include "report_data/bullet_again.h"

#include <algorithm>

#include "engines/bullet_run.h"

namespace morula {
namespace {

std::size_t vertexCount(const World& world) {
  std::size_t count = 0;
  for (const int slot : world.bodies->slots) count += static_cast<std::size_t>(world.bodies->vertexCount(slot));
  return count;
}

std::vector<double> evenTimes(double end, std::size_t count) {
  std::vector<double> times;
  for (std::size_t k = 0; k + 1 < count; ++k)
    times.push_back(end * static_cast<double>(k) / static_cast<double>(count - 1));
  times.push_back(end);
  return times;
}

}  // namespace

std::unique_ptr<BulletAgain> runInBulletAgain(const Scenario& scenario, const World& ours, std::size_t most,
                                              bool quiet) {
  const std::size_t fit = mostFrameVertices / std::max<std::size_t>(1, vertexCount(ours));
  const auto times = evenTimes(ours.clock.time, std::clamp<std::size_t>(fit, 1, std::max<std::size_t>(1, most)));
  auto again = std::make_unique<BulletAgain>();
  again->found = checkAgainstBullet(scenario, ours, quiet, times);
  if (again->found.bullet) again->frames = framesOf(scenario, again->found.bullet->frames);
  return again;
}

Frames framesOf(const Scenario& scenario, const std::vector<ExternalFrame>& frames) {
  World world = makeBulletStart(scenario);
  FrameTaker taker(0, frames.size());
  for (const ExternalFrame& frame : frames) {
    world.clock.time = frame.time, world.clock.step = frame.step;
    placeCells(world, frame.shapes);
    taker.take(world);
  }
  return std::move(taker.frames());
}

BulletStored compareWithStored(const std::vector<CheckResult>& found, const std::vector<CheckResult>& stored) {
  std::vector<CheckResult> then;
  for (const CheckResult& r : stored)
    if (r.kind == "bullet" && !wasSkipped(r)) then.push_back(r);
  if (then.empty()) return BulletStored::none;
  const bool same =
      std::equal(found.begin(), found.end(), then.begin(), then.end(), [](const CheckResult& a, const CheckResult& b) {
        return a.check == b.check && a.expected == b.expected && a.actual == b.actual && a.passed == b.passed;
      });
  return same ? BulletStored::same : BulletStored::other;
}

std::string bulletName() {
  for (const auto& [library, version] : buildInfo().libraries)
    if (library == "Bullet") return "Bullet " + version;
  return "Bullet";
}

}  // namespace morula
