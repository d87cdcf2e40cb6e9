// The springs' force is the slope of their energy; damping takes energy and keeps momentum [Nilsson 2008, eq. 4.2].
#include "catch.h"
#include "lab.h"
#include "mesh/connectivity.h"

using namespace morula;

namespace {

PhysicsParameters springsOnly(double damping, Springs springs = Springs::equal) {
  PhysicsParameters p = softCell();
  p.membrane = {40, damping, 1.26, springs};
  p.pressure = {0, 0};
  return p;
}

/// Returns E = ½ k_s Σ w (l − s L0)² in long double, from the mesh and the springs' weights (1 if there are none).
long double springEnergy(const std::vector<Point>& x, const Mesh& rest, double scale, double stiffness,
                         std::span<const double> weights) {
  long double energy = 0;
  std::size_t edge = 0;
  for (const auto& [i, j] : makeConnectivity(rest).edges) {
    const auto length = [i = i, j = j](const std::vector<Point>& at) {
      const long double dx = static_cast<long double>(at[j].x) - at[i].x,
                        dy = static_cast<long double>(at[j].y) - at[i].y,
                        dz = static_cast<long double>(at[j].z) - at[i].z;
      return std::sqrt(dx * dx + dy * dy + dz * dz);
    };
    const long double stretch = length(x) - scale * length(rest.vertices);
    energy += 0.5L * (weights.empty() ? 1 : weights[edge++]) * stiffness * stretch * stretch;
  }
  return energy;
}

const std::vector<zoo::Animal>& meshes() {
  static const std::vector<zoo::Animal> some{{"icosahedron", makeIcosphere(0)},
                                             {"icosphere 2", makeIcosphere(2)},
                                             {"tetrahedron", zoo::tetrahedron()},
                                             {"cube", zoo::box({-1, -1, -1}, {1, 1, 1})},
                                             {"torus", zoo::torus(12, 8), 1}};
  return some;
}

}  // namespace

TEST_CASE("The spring force is −dE/dx by central differences, of equal springs and of weighted ones") {
  for (const Springs springs : {Springs::equal, Springs::dual})
    for (const auto& [name, mesh, handles] : meshes()) {
      CAPTURE(name, static_cast<int>(springs));
      Body body = shakenBody(mesh, 0.1, 0);
      body.restScale = 0.8;
      const Lab lab = evaluated({springsOnly(0, springs), mesh, {body}});
      const auto energyAt = [&, &mesh = mesh](const std::vector<Point>& x) {
        return springEnergy(x, mesh, 0.8, 40, lab.bodies.mesh.springWeights);
      };
      Worst error;
      for (int v = 0; v < lab.bodies.vertexCount(); v += 7) {
        Vector slope;
        for (double Point::*component : {&Point::x, &Point::y, &Point::z}) {
          constexpr double h = 0x1p-17;
          std::vector<Point> x = body.position;
          x[v].*component += h;
          const long double above = energyAt(x);
          x[v].*component -= 2 * h;
          slope.*component = static_cast<double>((above - energyAt(x)) / (2 * h));
        }
        error.see(norm(lab.force(0, v) + slope));
      }
      CHECK(error < 1e-7);  // h² E‴/6, with forces of about 10
    }
}

TEST_CASE("A mesh at its rest lengths feels no springs") {
  for (const auto& [name, mesh, handles] : meshes()) {
    CHECK(largestForce(evaluated({springsOnly(0.5), mesh})) < 1e-13);
  }
}

TEST_CASE("Springs, damped or not, give no net force and no net moment") {
  for (const auto& [name, mesh, handles] : meshes()) {
    INFO(name);
    const Body body = shakenBody(mesh, 0.2, 3);
    const Lab lab = evaluated({springsOnly(0.5), mesh, {body}});
    Vector sum, moment;
    double size = 0;
    for (int v = 0; v < lab.bodies.vertexCount(); ++v) {
      sum += lab.force(0, v);
      moment += cross(body.position[v], lab.force(0, v));
      size += norm(lab.force(0, v));
    }
    CHECK(norm(sum) <= 1e-14 * size);
    CHECK(norm(moment) <= 1e-14 * size * 4);
  }
}

TEST_CASE("Damping works along the edge, against the change of its length") {
  const Mesh mesh = zoo::tetrahedron();
  Body body{mesh.vertices, std::vector<Vector>(4), 1, 1, 0};
  body.velocity[0] = {1, 2, 3};
  const Lab lab = evaluated({springsOnly(0.5), mesh, {body}});
  Vector onMoving;
  for (int v = 1; v < 4; ++v) {
    const Vector edge = mesh.vertices[v] - mesh.vertices[0], along = edge / norm(edge);
    const Vector force = 0.5 * dot(body.velocity[0], along) * along;  // k_d Δv: vertex v is dragged along
    CHECK(norm(lab.force(0, v) - force) < 1e-14);
    onMoving -= force;
  }
  CHECK(norm(lab.force(0, 0) - onMoving) < 1e-14);
}

TEST_CASE("Damping does not brake a body that moves or turns as one piece") {
  const Mesh mesh = makeIcosphere(2);
  Body body = shakenBody(mesh, 0, 0);
  for (std::size_t v = 0; v < body.position.size(); ++v)
    body.velocity[v] = Vector{5, -3, 2} + cross({0.3, 0.2, -0.9}, body.position[v]);
  CHECK(largestForce(evaluated({springsOnly(10), mesh, {body}})) < 1e-12);
}

TEST_CASE("Two vertices at one place do not make the force infinite") {
  const Mesh mesh = makeIcosphere(0);
  Body body = shakenBody(mesh, 0, 1);
  body.position[1] = body.position[makeConnectivity(mesh).ringVertex[makeConnectivity(mesh).ringStart[1]]];
  CHECK(largestForce(evaluated({springsOnly(0.5), mesh, {body}})) < 1000);
}
