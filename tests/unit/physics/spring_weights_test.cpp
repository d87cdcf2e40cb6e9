// Springs weighted by dual over own length: the tension of a surface, whatever its triangles.
#include <numbers>

#include "catch.h"
#include "lab.h"
#include "mesh/mesh_measures.h"
#include "physics/integrator.h"

using namespace morula;

namespace {

const double root3 = std::sqrt(3.0);

/// Returns the pressure of a free cell at rest.
double pressureOfFreeCell(int level, Springs springs, Integrator integrator = Integrator::velocityVerlet,
                          Isa isa = Isa::scalar, Precision precision = Precision::binary64) {
  PhysicsParameters p;
  p.membrane = {10, 0.02, 1.26, springs};
  p.pressure = {800, 166};
  p.drag = 8;
  p.integrator = integrator;
  p.precision = precision;
  const double timeStep = kindOf(integrator).solvesForces ? 0x1p-11 : 0x1p-5 / (1 << level);
  return stepped({p, scaleToRadius(makeIcosphere(level), 1), isa}, static_cast<int>(4 / timeStep), timeStep)
      .bodies.pressure[0];
}

}  // namespace

TEST_CASE("Weights are 1 in a mesh of equilateral triangles, and none is below 0.05") {
  const Mesh regular = makeIcosphere(0);
  const MeshTemplate even = makeTemplate(regular, Springs::dual);
  for (double weight : even.springWeights) CHECK(weight == Approx(1).epsilon(1e-14));
  CHECK(even.ringWeight == Approx(5).epsilon(1e-14));
  const Mesh flat = zoo::scaled(regular, {1, 1, 0.02});
  double least = 1;
  for (double weight : makeTemplate(flat, Springs::dual).springWeights) least = std::min(least, weight);
  CHECK(least == 0.05);
  CHECK(makeTemplate(regular).springWeights.empty());
}

TEST_CASE("Weighted squares of edges give the area in each direction of the surface") {
  for (const Mesh& mesh : {makeIcosphere(1), makeIcosphere(3), zoo::scaled(makeIcosphere(2), {1.1, 1, 0.9})}) {
    const MeshTemplate t = makeTemplate(mesh, Springs::dual);
    double edges[3][3] = {}, areas[3][3] = {};
    for (int e = 0; e < t.edgeCount(); ++e) {
      const Vector d = mesh.vertices[t.edges[2 * e + 1]] - mesh.vertices[t.edges[2 * e]];
      const double u[3] = {d.x, d.y, d.z};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) edges[i][j] += t.springWeights[e] * u[i] * u[j];
    }
    for (const Face& f : mesh.faces) {
      const Vector twice = cross(mesh.vertices[f[1]] - mesh.vertices[f[0]], mesh.vertices[f[2]] - mesh.vertices[f[0]]);
      const double area = 0.5 * norm(twice),
                   n[3] = {twice.x / norm(twice), twice.y / norm(twice), twice.z / norm(twice)};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) areas[i][j] += area * ((i == j) - n[i] * n[j]);
    }
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) CHECK(edges[i][j] == Approx(root3 * areas[i][j]).margin(1e-12));
  }
}

TEST_CASE("A free cell under pressure: the closed form, to second order in the edges; equal springs miss it") {
  // The radius λR, by bisection: T = √3 k (1 − 1/λ) and P = 2T/(λR) with P = k_p/V − P_0 and V = 4π/3 λ³.
  double low = 1, high = 2;
  const auto ofFluid = [](double l) { return 800 / (4 * std::numbers::pi / 3 * l * l * l) - 166; };
  const auto ofMembrane = [](double l) { return 2 * root3 * 10 * (1 - 1 / l) / l; };
  for (int i = 0; i < 60; ++i) {
    const double l = 0.5 * (low + high);
    (ofFluid(l) > ofMembrane(l) ? low : high) = l;
  }
  const double exact = ofFluid(low);
  double before = 0;
  for (int level : {1, 2, 3}) {
    const double off = std::abs(pressureOfFreeCell(level, Springs::dual) - exact) / exact;
    CHECK(off < 0.04 * std::pow(3.5, 1 - level));
    if (before > 0) CHECK(std::log2(before / off) > 1.8);
    before = off;
  }
  CHECK(pressureOfFreeCell(3, Springs::equal) < exact * 0.995);
}

TEST_CASE("All integrators, instruction sets and precisions know the weights") {
  const double verlet = pressureOfFreeCell(1, Springs::dual);
  for (const auto& [integrator, word, meaning] : choices<Integrator>) {
    if (kindOf(integrator).needsDrag) continue;  // the cell has too little drag for these
    CAPTURE(word);
    CHECK(pressureOfFreeCell(1, Springs::dual, integrator) ==
          Approx(verlet).epsilon(kindOf(integrator).solvesForces ? 0.01 : 1e-4));
  }
  for (const Isa isa : availableIsas())
    CHECK(pressureOfFreeCell(1, Springs::dual, Integrator::velocityVerlet, isa) == verlet);
  CHECK(pressureOfFreeCell(1, Springs::dual, Integrator::velocityVerlet, Isa::scalar, Precision::binary32) ==
        Approx(verlet).epsilon(1e-3));
}
