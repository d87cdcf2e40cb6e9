// The state of rest of a cell: springs against gas.
#include <numbers>

#include "base/maths.h"
#include "catch.h"
#include "lab.h"

using namespace morula;

namespace {

PhysicsParameters restingCell(double drag) {
  PhysicsParameters p = softCell();
  p.membrane = {10, 0.05, 1.26, Springs::equal};
  p.pressure = {8, 0};
  p.drag = drag;
  return p;
}

/// Steps until no vertex moves faster than 1e-13.
void settle(Lab& lab, double timeStep) {
  lab.start();
  for (int i = 0; i < 40000; ++i) {
    lab.step(timeStep);
    if (i % 100 == 99 && fastestVertex(lab.bodies) < 1e-13) return;
  }
  FAIL("it does not come to rest");
}

}  // namespace

TEST_CASE("An icosahedron rests where its springs balance its gas: 30 edges, one unknown") {
  // The shape stays similar: L = λ L0, V = λ³ V0, and k_s (λ − 1) λ Σ L0² = 3 k_p at the minimum of E = ½ k_s Σ (L −
  // L0)² − k_p ln V.
  const Mesh mesh = makeIcosphere(0);
  Lab lab(restingCell(2), mesh);
  settle(lab, 0x1p-7);
  const double edge = norm(mesh.vertices[lab.bodies.mesh.edges[0]] - mesh.vertices[lab.bodies.mesh.edges[1]]);
  const double q = 3 * 8 / (10 * 30 * edge * edge);
  CHECK(meanRadius(lab) == Approx((1 + std::sqrt(1 + 4 * q)) / 2).epsilon(1e-12));
}

TEST_CASE("The cell of 642 vertices rests at a radius of 1.053101148") {
  Lab lab(restingCell(4), makeIcosphere(3), bestIsa());
  settle(lab, 0x1p-8);
  const double volumeRadius = cubeRoot(3 * lab.bodies.volume[0] / (4 * std::numbers::pi));
  CAPTURE(volumeRadius);
  CHECK(meanRadius(lab) == Approx(1.053101148).margin(1e-8));
}
