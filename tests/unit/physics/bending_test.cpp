// Bending: its forces are the gradient of its energy, which converges with the mesh, and its stiffness bounds the step.
#include "physics/bending.h"

#include <Eigen/Dense>
#include <numbers>

#include "catch.h"
#include "lab.h"
#include "physics/stability.h"

using namespace morula;

namespace {

PhysicsParameters bent(double rigidity) {
  PhysicsParameters p = softCell();
  p.membrane.bending = rigidity;
  return p;
}

/// Returns a cell without springs, fluid and damping, whose membrane only bends.
PhysicsParameters onlyBent(double rigidity) {
  PhysicsParameters p = bent(rigidity);
  p.membrane.stiffness = 0, p.membrane.damping = 0;
  p.pressure = {0, 0};
  return p;
}

Lab labOf(const PhysicsParameters& p, const Mesh& mesh, const Body& body) {
  Lab lab(p, mesh, {body}, bestIsa());
  lab.start();
  return lab;
}

Body bodyOf(const Mesh& mesh, const std::vector<Point>& places) {
  Body body = shakenBody(mesh, 0, 0);
  body.position = places;
  return body;
}

double energyOf(const PhysicsParameters& p, const Mesh& mesh, const std::vector<Point>& places) {
  return measureBendingEnergy(labOf(p, mesh, bodyOf(mesh, places)).bodies, 0);
}

/// Returns the mesh's points under diag(a, b, c).
std::vector<Point> stretched(const Mesh& mesh, const Vector& by) {
  std::vector<Point> points = mesh.vertices;
  for (Point& x : points) x = {by.x * x.x, by.y * x.y, by.z * x.z};
  return points;
}

/// Returns W A⁻¹ W of the bending of a mesh at scale 1.
Eigen::MatrixXd stiffnessOf(const MeshTemplate& mesh, const Bending& bending) {
  const int n = mesh.vertexCount();
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(n, n), inverse = Eigen::MatrixXd::Zero(n, n);
  for (int v = 0; v < n; ++v) {
    inverse(v, v) = bending.inverseAreas[v];
    for (int k = mesh.ringStart[v]; k < mesh.ringStart[v + 1]; ++k) {
      w(v, mesh.ring[k].vertexOffset / vertexStride) += bending.weights[k];
      w(v, v) -= bending.weights[k];
    }
  }
  return w * inverse * w;
}

}  // namespace

TEST_CASE(
    "Bending forces are the gradient of its energy, in the kernel and in doubles, and have neither sum nor torque") {
  for (const Mesh& mesh : {makeIcosphere(1), makeIcosphere(2), zoo::scaled(zoo::torus(7, 5), {0.33, 0.33, 0.33})}) {
    Body body = shakenBody(mesh, 0.1, 3);
    body.restScale = 0.8;
    const PhysicsParameters p = onlyBent(0.7);
    const Lab lab = labOf(p, mesh, body);
    const std::vector<Vector> forces = measureBendingForces(lab.bodies, 0);
    Vector sum, torque;
    Worst off, difference, largest;
    for (int v = 0; v < lab.bodies.vertexCount(); ++v) {
      sum += forces[v], torque += cross(lab.bodies.vertex(0, v), forces[v]);
      off.see(norm(forces[v] - lab.bodies.vertexMass[0] * lab.bodies.read(lab.bodies.acceleration, 0, v)));
      largest.see(norm(forces[v]));
      for (double Vector::*axis : {&Vector::x, &Vector::y, &Vector::z}) {
        const double step = 1e-4;
        Bodies moved = lab.bodies;
        const auto at = [&](double by) {
          Point x = lab.bodies.vertex(0, v);
          x.*axis += by;
          moved.write(moved.position, 0, v, x);
          return measureBendingEnergy(moved, 0);
        };
        difference.see(std::abs((at(-step) - at(step)) / (2 * step) - forces[v].*axis));
      }
    }
    CAPTURE(mesh.vertices.size(), double(largest));
    CHECK(largest > 0.1);
    CHECK(off < 1e-12 * largest);
    CHECK(difference < 1e-8 * largest);
    CHECK(norm(sum) < 1e-12 * largest);
    CHECK(norm(torque) < 1e-12 * largest);
  }
}

TEST_CASE("The energy of spheres and ellipsoids converges with the square of the mesh's edges") {
  // The metric is that of the sphere at rest, on which Δx = −2x/r²: ½ κ ∫ |Δ diag(a, b, c) x|² = 8π/3 κ (a² + b² + c²).
  const double rigidity = 0.4;
  for (const Vector& axes : {Vector{1, 1, 1}, Vector{1.3, 1, 0.8}, Vector{2, 0.7, 0.7}}) {
    const double exact = 8 * std::numbers::pi / 3 * rigidity * dot(axes, axes);
    std::vector<double> errors;
    for (int level : {1, 2, 3, 4}) {
      const Mesh mesh = makeIcosphere(level);
      Mesh onSphere = mesh;
      for (Point& x : onSphere.vertices) x = x / norm(x);
      errors.push_back(std::abs(energyOf(onlyBent(rigidity), onSphere, stretched(onSphere, axes)) / exact - 1));
    }
    CAPTURE(axes.x, axes.y, axes.z, errors[0], errors[1], errors[2], errors[3]);
    CHECK(errors[1] < 0.03);
    CHECK(errors[1] < 0.35 * errors[0]);
    CHECK(errors[2] < 0.35 * errors[1]);
    CHECK(errors[3] < 0.35 * errors[2]);
  }
}

TEST_CASE("The stiffest mode of bending is that of the whole matrix, and the time step's limit is where it explodes") {
  for (const Mesh& mesh : {makeIcosphere(1), makeIcosphere(2), zoo::scaled(zoo::torus(7, 5), {0.33, 0.33, 0.33})}) {
    const MeshTemplate rest = makeTemplate(mesh, Springs::dual);
    const Bending bending = makeBending(rest);
    const double exact =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(stiffnessOf(rest, bending)).eigenvalues().maxCoeff();
    CAPTURE(mesh.vertices.size(), exact);
    CHECK(bending.stiffest >= exact);
    CHECK(bending.stiffest < 1.02 * exact);

    const PhysicsParameters p = onlyBent(0.3);
    Body body = shakenBody(mesh, 1e-3, 0);
    body.pressureConstant = 0;
    Lab lab = labOf(p, mesh, body);
    const double limit = measureLimits(lab.bodies, 0).bending;
    const auto motionAfter = [&](double timeStep) {
      Lab moved = labOf(p, mesh, body);
      for (int i = 0; i < 2000; ++i) moved.step(timeStep);
      return fastestVertex(moved.bodies);
    };
    CHECK(motionAfter(0.99 * limit) < 10);
    CHECK_FALSE(motionAfter(1.02 * limit) < 1e3);
  }
}

TEST_CASE(
    "A membrane that only bends keeps its energy with the square of the step, and none has energy without bending") {
  const Mesh mesh = makeIcosphere(1);
  const PhysicsParameters p = onlyBent(0.5);
  const auto deviation = [&](double timeStep) {
    Lab lab = labOf(p, mesh, shakenBody(mesh, 0.05, 0.3, 1));
    const auto energy = [&] {
      double sum = measureBendingEnergy(lab.bodies, 0);
      for (int v = 0; v < lab.bodies.vertexCount(); ++v)
        sum += 0.5 * lab.bodies.vertexMass[0] * dot(lab.velocity(0, v), lab.velocity(0, v));
      return sum;
    };
    const double before = energy();
    Worst off;
    for (int i = 0; i < 0.5 / timeStep; ++i) {
      lab.step(timeStep);
      off.see(std::abs(energy() / before - 1));
    }
    return double(off);
  };
  const double whole = deviation(0x1p-8), half = deviation(0x1p-9);
  CAPTURE(whole, half);
  CHECK(whole > 1e-6);
  CHECK(whole / half > 3);
  CHECK(whole / half < 5);
  CHECK(energyOf(softCell(), mesh, mesh.vertices) == 0);
}
