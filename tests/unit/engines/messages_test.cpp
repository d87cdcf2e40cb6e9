// Messages between the program and its worker.

#include <cmath>
#include <limits>
#include <sstream>

#include "catch.h"
#include "engines/bullet_world.h"
#include "engines/engine_worker.h"
#include "lab.h"

using namespace morula;

namespace {

BulletRequest everything() {
  BulletRequest request{pressurisedCell(0, Baseline::b2, 1.0 / 3), 7, {2, 5}};
  BulletScene& s = request.scene;
  s.physics.membrane.damping = 0.1;
  s.physics.pressure.outside = 1e-300;
  s.physics.shell = ShellParameters{{1, 2, 1.0 / 7}};
  s.timeStep = 0x1p-9;
  s.contact = true;
  s.margin = 0.0125;
  s.iterations = 3;
  s.physics.integrator = Integrator::thesisVerlet;
  s.cells.push_back(s.cells[0]);
  s.cells[1].velocity[3] = {-0.0, std::numeric_limits<double>::denorm_min(), 1e308};
  s.cells[1].mass = 0.1, s.cells[1].restScale = 0.2, s.cells[1].pressureConstant = 0.3;
  return request;
}

bool same(const Body& a, const Body& b) {
  return a.position == b.position && a.velocity == b.velocity && a.mass == b.mass && a.restScale == b.restScale &&
         a.pressureConstant == b.pressureConstant;
}

}  // namespace

TEST_CASE("A request arrives as it was sent") {
  const BulletRequest sent = everything();
  const BulletRequest got = bulletRequestFrom(parseJson(jsonText(toJson(sent))));
  const BulletScene &a = sent.scene, &b = got.scene;
  CHECK(got.steps == sent.steps);
  CHECK(got.reports == sent.reports);
  CHECK(b.baseline == a.baseline);
  CHECK(b.mesh.vertices == a.mesh.vertices);
  CHECK(b.mesh.faces == a.mesh.faces);
  CHECK(b.physics.membrane.stiffness == a.physics.membrane.stiffness);
  CHECK(b.physics.membrane.damping == a.physics.membrane.damping);
  CHECK(b.physics.pressure.outside == a.physics.pressure.outside);
  CHECK(b.physics.drag == a.physics.drag);
  REQUIRE(b.physics.shell);
  for (int i = 0; i < 3; ++i) CHECK(b.physics.shell->semiAxes[i] == a.physics.shell->semiAxes[i]);
  CHECK(b.timeStep == a.timeStep);
  CHECK(b.contact == a.contact);
  CHECK(b.margin == a.margin);
  CHECK(b.iterations == a.iterations);
  CHECK(b.physics.integrator == a.physics.integrator);
  REQUIRE(b.cells.size() == 2);
  CHECK(same(b.cells[0], a.cells[0]));
  CHECK(same(b.cells[1], a.cells[1]));
}

TEST_CASE("A result arrives as it was sent") {
  const auto cells = everything().scene.cells;
  BulletResult sent{cells, {1e-6, 0.25}, {{cells[1]}, cells}};
  sent.cells[0].position[0].x = std::numeric_limits<double>::quiet_NaN();
  sent.cells[0].velocity[0].z = std::numeric_limits<double>::infinity();
  const BulletResult got = bulletResultFrom(parseJson(jsonText(toJson(sent))));
  CHECK(got.stepSeconds == sent.stepSeconds);
  REQUIRE(got.cells.size() == 2);
  CHECK(same(got.cells[1], sent.cells[1]));
  CHECK(std::isnan(got.cells[0].position[0].x));  // NaN stays NaN
  CHECK(std::isnan(got.cells[0].velocity[0].z));
  REQUIRE((got.reports.size() == 2 && got.reports[0].size() == 1 && got.reports[1].size() == 2));
  CHECK(same(got.reports[0][0], cells[1]));
}

TEST_CASE("A broken question is told, wherever it breaks") {
  const auto serve = [](const std::string& text) {
    std::istringstream in(text);
    std::ostringstream out;
    serveEngine(in, out);
  };
  const Json whole = toJson(everything());
  const std::string text = jsonText(whole);
  for (std::size_t length = 0; length + 1 < text.size(); length += 97)
    CHECK_THROWS_AS(serve(text.substr(0, length)), InputError);
  for (const auto& [key, value] : whole.items()) {
    if (key == "shell") continue;  // a scene may have no shell
    CAPTURE(key);
    Json changed = whole;
    changed.erase(key);
    CHECK_THROWS_WITH(serve(jsonText(changed)), ContainsSubstring("cannot be read"));
    changed[key] = "x";
    CHECK_THROWS_AS(serve(jsonText(changed)), InputError);
  }
}

TEST_CASE("The worker answers a request, the same each time") {
  NEEDS_BULLET
  const BulletRequest request{pressurisedCell(1, Baseline::b1, 0), 5, {2, 5}};
  std::vector<Body> first;
  for (int turn = 0; turn < 2; ++turn) {
    std::istringstream in(jsonText(toJson(request)));
    std::ostringstream out;
    serveEngine(in, out);
    const BulletResult result = bulletResultFrom(parseJson(out.str()).at("answer"));
    CHECK(result.stepSeconds.size() == 5);
    REQUIRE(result.cells.size() == 1);
    REQUIRE(result.reports.size() == 2);  // one on the way, and the end once more
    CHECK_FALSE(same(result.reports[0][0], result.cells[0]));
    CHECK(same(result.reports[1][0], result.cells[0]));
    CHECK(meanRadius(result.cells[0]) > 1);
    if (turn == 0) first = result.cells;
    else CHECK(same(result.cells[0], first[0]));
  }
}

#ifdef MORULA_SINGLE_BULLET_PROGRAM
TEST_CASE("Bullet in single precision answers the same to rounding, and not to the bit") {
  for (const Baseline baseline : {Baseline::b1, Baseline::b2}) {
    const BulletRequest request{pressurisedCell(2, baseline, 0.25), 64};
    const auto world = makeBulletWorld(request.scene);
    for (int i = 0; i < request.steps; ++i) world->step();
    const Body twice = world->cells()[0], once = runInBullet(request, MORULA_SINGLE_BULLET_PROGRAM).cells.at(0);
    double apart = 0;
    for (std::size_t v = 0; v < twice.position.size(); ++v)
      apart = std::max(apart, norm(twice.position[v] - once.position[v]));
    CHECK(apart > 1e-9);
    CHECK(apart < 1e-5);  // 64 steps, each rounded to 6e-8
  }
}
#endif

TEST_CASE("A program that is no worker is an error, not a hang") {
  const BulletRequest request{pressurisedCell(2, Baseline::b1, 0), 1};
  CHECK_THROWS_AS(runInBullet(request, "/bin/false"), FileError);
  CHECK_THROWS_AS(runInBullet(request, "/bin/true"), InputError);  // ends well and says nothing
  CHECK_THROWS_WITH(runInBullet(request, "/nowhere/morula"), ContainsSubstring("code 127"));
}
