// Quantities that a cell keeps when it takes a coarser mesh.
#include "division/coarsen.h"

#include "catch.h"
#include "cuts.h"
#include "division/cut.h"
#include "division/principal_axis.h"
#include "mesh_oracles.h"
#include "unit/physics/lab.h"

using namespace morula;

namespace {

/// Returns bodies of 642 vertices; cells whose mean edge is at most `longestEdge` on 162 vertices take 162.
Bodies bodiesWith(double longestEdge, int level = 3, std::vector<Mesh> coarser = {makeIcosphere(2)}) {
  PhysicsParameters p = softCell();
  p.coarsen = longestEdge;
  return makeBodies(p, makeIcosphere(level), 1, coarser);
}

Body moving(const std::vector<Point>& shape) {
  Body b{shape, std::vector<Vector>(shape.size()), 3, 0.9, 5};
  for (std::uint32_t v = 0; v < shape.size(); ++v) b.velocity[v] = Vector{1, 2, 3} + noiseVector(v);
  return b;
}

/// Returns spheres and cells that are stretched, flattened or pressed between two plates in random directions, and the
/// daughters of each, cut across its longest extent.
std::vector<Body> bodies() {
  std::vector<Body> all;
  const Mesh ball = makeIcosphere(3);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Vector m = randomDirection({seed, {}, 0, Purpose::test});
    const auto add = [&](auto&& shape) {
      std::vector<Point> x;
      for (const Point& v : ball.vertices) x.push_back(shape(v, dot(v, m)));
      all.push_back(moving(x));
      const CutResult cut = cutBody(all.back(), ball.faces, throughMean(all.back(), principalAxis(x)), 1.26);
      REQUIRE(cut.failure == "");
      all.push_back(cut.daughters.a);
      all.push_back(cut.daughters.b);
    };
    add([&](const Point& x, double) { return x; });
    add([&](const Point& x, double h) { return x + 0.5 * h * m; });
    add([&](const Point& x, double h) { return x - 0.5 * h * m; });
    add([&](const Point& x, double h) { return x + (std::clamp(h, -0.7, 0.6) - h) * m; });
  }
  return all;
}

}  // namespace

TEST_CASE("Round, pressed and freshly cut cells keep volume, area, mass, gas, centre and momentum") {
  const Bodies b = bodiesWith(1);
  const Faces faces = b.meshAt(0).mesh.faces, fewer = b.meshAt(1).mesh.faces;
  Worst volume, area, centre, push;
  for (const Body& before : bodies()) {
    const Body after = coarsen(b, before);
    REQUIRE(after.meshLevel == 1);
    REQUIRE(after.position.size() == 162);
    REQUIRE(after.velocity.size() == 162);
    volume.see(std::abs(measureVolume(after.position, fewer) / measureVolume(before.position, faces) - 1));
    area.see(std::abs(measureArea(after.position, fewer) / measureArea(before.position, faces) - 1));
    centre.see(norm(measureCentroid(after.position) - measureCentroid(before.position)));
    push.see(norm(momentumOf(after) - momentumOf(before)) / norm(momentumOf(before)));
    CHECK(after.mass == before.mass);
    CHECK(after.pressureConstant == before.pressureConstant);
    CHECK(after.restScale == before.restScale);
    CHECK(countFacesTurnedInward(after.position, fewer, measureCentroid(after.position)) == 0);
  }
  CHECK(volume < 1e-12);
  CHECK(area < 0.007);
  CHECK(centre < 1e-14);
  CHECK(push < 1e-14);
}

TEST_CASE("However a cut slants, volume is kept, and area to 1 %") {
  const Bodies b = bodiesWith(1);
  Worst volume, area;
  int coarser = 0, all = 0;
  std::uint64_t seed = 100;
  for (const Body& mother : bodies()) {
    const Vector normal = randomDirection({seed++, {}, 0, Purpose::test});
    const CutResult cut = cutBody(mother, b.mesh.mesh.faces, throughMean(mother, normal), 1.26);
    if (cut.failure != "") continue;
    for (const Body& before : {cut.daughters.a, cut.daughters.b}) {
      const Body after = coarsen(b, before);
      const Faces faces = b.meshAt(after.meshLevel).mesh.faces;
      volume.see(
          std::abs(measureVolume(after.position, faces) / measureVolume(before.position, b.mesh.mesh.faces) - 1));
      area.see(std::abs(measureArea(after.position, faces) / measureArea(before.position, b.mesh.mesh.faces) - 1));
      coarser += after.meshLevel;
      ++all;
    }
  }
  CHECK(volume < 1e-12);
  CHECK(area <= 0.01);
  CHECK(coarser == all);
}

TEST_CASE("A round cell is under equal tension and pressure on either mesh") {
  // Springs in a sphere hold the pressure Σ f l over 3V.
  const Bodies b = bodiesWith(1);
  for (double stretch : {1.02, 1.1, 1.5}) {
    const auto held = [&](const Body& body) {
      const MeshTemplate& mesh = b.meshAt(body.meshLevel);
      double sum = 0;
      for (int e = 0; e < mesh.edgeCount(); ++e) {
        const double length = norm(body.position[mesh.edges[2 * e]] - body.position[mesh.edges[2 * e + 1]]);
        sum += (length - body.restScale * mesh.restLengths[e]) * length;
      }
      return sum / (3 * measureVolume(body.position, mesh.mesh.faces));
    };
    Body fine = moving(zoo::scaled(makeIcosphere(3), {stretch, stretch, stretch}).vertices);
    fine.restScale = 1;
    CHECK(held(coarsen(b, fine)) == Approx(held(fine)).epsilon(0.01));
  }
}

TEST_CASE("The coarsest mesh whose edges are short enough is taken, by the rest lengths") {
  const Bodies b = bodiesWith(0.2, 4, {makeIcosphere(3), makeIcosphere(2)});
  for (const auto& [scale, meshLevel] :
       std::vector<std::pair<double, int>>{{1.4, 0}, {1.3, 1}, {0.7, 1}, {0.65, 2}, {0.1, 2}}) {
    Body body = moving(makeIcosphere(4).vertices);
    body.restScale = scale;
    const Body after = coarsen(b, body);
    CAPTURE(scale);
    CHECK(after.meshLevel == meshLevel);
    if (meshLevel < 2) CHECK(scale * b.meshAt(meshLevel + 1).meanRestLength > 0.2);
    if (meshLevel > 0) CHECK(scale * b.meshAt(meshLevel).meanRestLength <= 0.2);
    CHECK((coarsen(b, after).position == after.position));
  }
}

TEST_CASE("Without coarser meshes a body stays as it is") {
  const Bodies b = makeBodies(softCell(), makeIcosphere(2), 1);
  const Body body = moving(makeIcosphere(2).vertices);
  CHECK((coarsen(b, body).position == body.position));
}

TEST_CASE("A crumpled body, whose area the coarser mesh cannot have, keeps its mesh") {
  const Bodies b = bodiesWith(1);
  const Body crumpled = shakenBody(makeIcosphere(3), 0.1, 1);
  CHECK(coarsen(b, crumpled).meshLevel == 0);
  CHECK((coarsen(b, crumpled).position == crumpled.position));
}
