// Settings and order of Bullet's timings, with a substitute for Bullet that only counts.
#include "bench/bullet_subject.h"

#include <set>

#include "catch.h"

using namespace morula;

namespace {

BulletScene twoCells() {
  BulletScene scene;
  scene.mesh = makeIcosphere(0);
  Body cell{scene.mesh.vertices, std::vector<Vector>(12), 1, 1, 1};
  scene.cells = {cell, cell};
  scene.physics.integrator = Integrator::thesisVerlet;
  return scene;
}

/// A substitute for Bullet. Each of its first three steps takes a second; later steps take longer the larger margin and
/// iterations are. Cells' masses count their steps.
struct Pretender {
  std::vector<BulletRequest> heard = {};
  double brokenMargin = -1;  // with this margin cells are crushed

  BulletResult operator()(const BulletRequest& request) {
    heard.push_back(request);
    BulletResult result{request.scene.cells, std::vector<double>(std::size_t(request.steps), 1.0)};
    for (std::size_t i = 3; i < result.stepSeconds.size(); ++i)
      result.stepSeconds[i] = 24 * (request.scene.margin + 0.001 * request.scene.iterations);
    for (Body& cell : result.cells) {
      cell.mass += request.steps;
      if (request.scene.margin == brokenMargin)
        for (Point& x : cell.position) x = 0.1 * x;
    }
    return result;
  }
};

}  // namespace

TEST_CASE("Bullet settles before it is timed, in all its settings, and the fastest come first") {
  Pretender bullet;
  BulletSubject subject(twoCells(), 2, std::ref(bullet));
  subject.round();
  REQUIRE(bullet.heard.size() == 4 + 16);
  std::set<std::pair<double, int>> settings;
  for (std::size_t i = 0; i < bullet.heard.size(); ++i) {
    const BulletRequest& request = bullet.heard[i];
    CHECK(request.scene.physics.integrator == Integrator::velocityVerlet);
    if (i < 4) {
      CHECK(request.steps == 40);
      CHECK(request.scene.cells[0].mass == 1);
      continue;
    }
    CHECK(request.scene.cells[0].mass == 1 + 40);  // settled cells are timed
    settings.emplace(request.scene.margin, request.scene.iterations);
  }
  CHECK(settings.size() == 16);
  CHECK(settings.contains({2 * 0.0025, 1}));
  CHECK(settings.contains({2 * 0.02, 4}));

  const auto timings = subject.timings();
  REQUIRE(timings.size() == 16);
  CHECK((timings[0].margin == 0.0025 && timings[0].iterations == 1));
  CHECK((timings[15].margin == 0.02 && timings[15].iterations == 4));
  for (const double s : timings[0].samples) CHECK(s == Approx(2 * 0.0025 + 0.001));  // without the first steps

  subject.round();
  REQUIRE(bullet.heard.size() == 20 + 3);  // only the fastest setting runs again
  for (std::size_t i = 20; i < 23; ++i) CHECK(bullet.heard[i].scene.margin == 2 * 0.0025);
  CHECK(subject.timings()[0].samples.size() == 2 * timings[0].samples.size());
}

TEST_CASE("A setting with which cells do not stay whole is no measure of Bullet") {
  Pretender bullet{.brokenMargin = 2 * 0.0025};
  BulletSubject subject(twoCells(), 2, std::ref(bullet));
  subject.round();
  const auto timings = subject.timings();
  REQUIRE(timings.size() == 12);
  CHECK((timings[0].margin == 0.005 && timings[0].iterations == 1));
}
