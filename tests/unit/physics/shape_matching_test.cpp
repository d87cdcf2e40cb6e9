// Shape matching: the rotation that the kernel finds, its forces, and how cells oscillate and explode.
#include <Eigen/LU>
#include <Eigen/SVD>
#include <numbers>

#include "catch.h"
#include "lab.h"
#include "physics/stability.h"

using namespace morula;

namespace {

using Matrix3 = Eigen::Matrix3d;

PhysicsParameters matched(double linear = 0, double damping = 0) {
  PhysicsParameters p;
  p.cell.model = CellModel::shapeMatching;
  p.shapeMatching = {400, linear, damping};
  return p;
}

Eigen::Vector3d toEigen(const Vector& a) { return {a.x, a.y, a.z}; }
Vector fromEigen(const Eigen::Vector3d& a) { return {a[0], a[1], a[2]}; }

Body mapped(const Mesh& mesh, const Matrix3& map, const Vector& place = {}) {
  Body body = shakenBody(mesh, 0, 0);
  for (Point& x : body.position) x = place + fromEigen(map * toEigen(x));
  return body;
}

/// Returns the paper's rotation: U Vᵀ for A = U Σ Vᵀ, with the smallest direction reversed if U Vᵀ mirrors.
Matrix3 rotationBySvd(const Matrix3& a) {
  const Eigen::JacobiSVD<Matrix3> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix3 sign = Matrix3::Identity();
  sign(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * sign * svd.matrixV().transpose();
}

Matrix3 randomMatrix(std::uint32_t key) {
  Matrix3 m;
  for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = noise(static_cast<std::uint32_t>(i), key);
  return m;
}

/// Returns Σ q qᵀ.
Matrix3 secondMoments(const Mesh& mesh) {
  Matrix3 sum = Matrix3::Zero();
  for (const Point& q : mesh.vertices) sum += toEigen(q) * toEigen(q).transpose();
  return sum;
}

/// Returns the goal of a vertex relative to the centre: x + a/k.
Eigen::Vector3d goalOf(const Lab& lab, int slot, int v) {
  const Vector centre = measureCentre(lab.bodies, slot);
  const double k = lab.bodies.parameters.shapeMatching.stiffness * lab.bodies.vertexMass[slot];
  return toEigen(lab.bodies.vertex(slot, v) - centre + lab.force(slot, v) / k);
}

/// Returns a brick, whose second moments along its axes differ; its centre is the origin.
Mesh brick() { return zoo::box({-0.3, -0.5, -0.9}, {0.3, 0.5, 0.9}); }

}  // namespace

TEST_CASE("Goals are the rest shape under the rotation that a singular value decomposition gives") {
  for (const Mesh& mesh : {makeIcosphere(1), brick()}) {
    const Matrix3 moments = secondMoments(mesh);
    Worst off;
    int proper = 0, mirrored = 0;
    for (std::uint32_t key = 0; key < 3000; ++key) {
      Matrix3 map = randomMatrix(key);
      if (key % 3 == 1) map.col(2) = map.col(0) * 0.3 + map.col(1) * 0.1;  // flat
      const Matrix3 products = map * moments;
      const Eigen::Vector3d s = Eigen::JacobiSVD<Matrix3>(products).singularValues();
      const double gap = s[1] + (products.determinant() < 0 ? -s[2] : s[2]);  // at 0 no nearest rotation exists
      if (gap < 1e-3 * s[0]) continue;
      (products.determinant() < 0 ? mirrored : proper)++;
      const Lab lab = evaluated({matched(), mesh, {mapped(mesh, map, {3, -2, 5})}});
      const Matrix3 rotation = rotationBySvd(products);
      for (int v = 0; v < lab.bodies.vertexCount(); ++v)
        off.see((goalOf(lab, 0, v) - rotation * toEigen(mesh.vertices[v])).norm() * gap / s[0]);
    }
    CHECK(proper > 1000);
    CHECK(mirrored > 700);
    CHECK(off < 2e-14);
  }
}

TEST_CASE("Needles, points and half turns have goals too, of the rest shape's size") {
  const Mesh mesh = brick();
  const Matrix3 halfTurn = Eigen::Vector3d(-1, 1, -1).asDiagonal(), mirror = -Matrix3::Identity();
  const Matrix3 needle = Eigen::Vector3d(0, 0, 4).asDiagonal(), point = Matrix3::Zero();
  for (const double linear : {0.0, 0.5})
    for (const Matrix3& map : {halfTurn, mirror, needle, point}) {
      const Lab lab = evaluated({matched(linear, 1), mesh, {mapped(mesh, map)}});
      for (int v = 0; v < 8; ++v) {
        const double size = goalOf(lab, 0, v).norm();
        CHECK(size > 0.4 * norm(mesh.vertices[v]));
        CHECK(size < 4 * norm(mesh.vertices[v]));
        if (linear == 0) CHECK(size == Approx(norm(mesh.vertices[v])).epsilon(1e-13));
        if (linear == 0 && map == halfTurn) CHECK(norm(lab.force(0, v)) < 1e-12);
      }
    }
}

TEST_CASE("With β goals follow the linear map, at the volume at rest") {
  const Mesh mesh = brick();
  for (std::uint32_t key = 0; key < 50; ++key) {
    const Matrix3 map = Matrix3::Identity() + 0.3 * randomMatrix(key);
    REQUIRE(map.determinant() > 0.2);
    for (const double linear : {0.3, 1.0}) {
      Lab lab(matched(linear), mesh, {mapped(mesh, map)});
      lab.bodies.restScale[0] = 1.25;
      lab.evaluate();
      const Matrix3 goal =
          linear * map / std::cbrt(map.determinant()) + (1 - linear) * rotationBySvd(map * secondMoments(mesh));
      Worst off;
      for (int v = 0; v < 8; ++v) off.see((goalOf(lab, 0, v) - 1.25 * goal * toEigen(mesh.vertices[v])).norm());
      CHECK(off < 1e-13);
    }
  }
}

TEST_CASE("Forces sum to zero and to no torque, whatever the shape, β and damping") {
  for (const Mesh& mesh : {makeIcosphere(1), brick()})
    for (const double linear : {0.0, 0.5, 1.0})
      for (std::uint32_t key = 0; key < 20; ++key) {
        Body body = mapped(mesh, Matrix3::Identity() + 0.5 * randomMatrix(key), {7, 8, 9});
        for (std::uint32_t v = 0; v < body.position.size(); ++v) {
          body.position[v] += 0.1 * noiseVector(v, key);
          body.velocity[v] = noiseVector(v, key + 100);
        }
        const Lab lab = evaluated({matched(linear, 5), mesh, {body}});
        const Point centre = measureCentre(lab.bodies, 0);
        Vector sum, torque;
        double size = 0;
        for (int v = 0; v < lab.bodies.vertexCount(); ++v) {
          sum += lab.force(0, v), torque += cross(lab.bodies.vertex(0, v) - centre, lab.force(0, v));
          size += norm(lab.force(0, v));
        }
        CHECK(size > 1);
        CHECK(norm(sum) < 1e-13 * size);  // rounding of the centre, at 14 lengths
        CHECK(norm(torque) < 1e-13 * size);
      }
}

TEST_CASE("Damping takes neither flight nor spin") {
  const Mesh mesh = brick();
  Body body = mapped(mesh, Matrix3::Identity());
  for (std::size_t v = 0; v < body.velocity.size(); ++v)
    body.velocity[v] = Vector{1, 2, 3} + cross(Vector{0.5, -0.2, 0.7}, body.position[v]);
  Lab lab = evaluated({matched(0, 100), mesh, {body}});
  for (int v = 0; v < 8; ++v) CHECK(norm(lab.force(0, v)) < 1e-12);
  lab.setVelocity(0, 3, {1, 2, 4});
  lab.evaluate();
  CHECK(norm(lab.force(0, 3)) > 1);
}

TEST_CASE("A stretched body rings at √k; with β its shape at √((1 − β) k), its volume at √k") {
  // x = F q with F symmetric and near 1: R = 1, and (F − 1)'' = −k (F − T). T is 1 + β times the traceless
  // part of F.
  const Mesh mesh = makeIcosphere(1);
  struct Case {
    double linear, square;  // ω²/k
    Vector stretch;
  };
  for (const auto& [linear, square, stretch] :
       {Case{0, 1, {0.2, 0, 0}}, Case{0, 1, {0.01, -0.02, 0.03}}, Case{0.5, 0.5, {1e-3, -1e-3, 0}},
        Case{0.9, 0.1, {1e-3, -5e-4, -5e-4}}, Case{0.9, 1, {1e-3, 1e-3, 1e-3}}})
    for (const Integrator integrator : {Integrator::velocityVerlet, Integrator::rungeKutta4}) {
      PhysicsParameters p = matched(linear);
      p.integrator = integrator;
      Lab lab(p, mesh, {mapped(mesh, Eigen::Vector3d(1 + stretch.x, 1 + stretch.y, 1 + stretch.z).asDiagonal())});
      const int far = [&] {  // a vertex that the first stretch moves
        int best = 0;
        for (int v = 0; v < 42; ++v) best = mesh.vertices[v].x > mesh.vertices[best].x ? v : best;
        return best;
      }();
      lab.start();
      constexpr double dt = 0x1p-12;
      const auto off = [&] { return lab.bodies.vertex(0, far).x - mesh.vertices[far].x; };
      double before = off(), first = 0, last = 0;
      int crossings = 0;
      for (int i = 1; i * dt < 8; ++i) {
        lab.step(dt);
        const double now = off();
        if ((now > 0) != (before > 0)) {
          last = i * dt - dt * now / (now - before);
          if (crossings++ == 0) first = last;
        }
        before = now;
      }
      CAPTURE(linear, stretch.x, stretch.y, static_cast<int>(integrator), crossings);
      REQUIRE(crossings > 10);
      CHECK(std::numbers::pi * (crossings - 1) / (last - first) == Approx(std::sqrt(square * 400)).epsilon(1e-5));
    }
}

TEST_CASE("Up to their limit cells swing, and beyond it they explode, with every integrator") {
  const Mesh mesh = makeIcosphere(1);
  for (const Integrator integrator : {Integrator::velocityVerlet, Integrator::thesisVerlet, Integrator::explicitEuler,
                                      Integrator::symplecticEuler, Integrator::rungeKutta4})
    for (const double damping : {0.0, 4.0, 30.0, 100.0})
      for (const double linear : {0.0, 0.5})
        for (const double drag : {0.0, 5.0}) {
          PhysicsParameters p = matched(linear, damping);
          p.integrator = integrator;
          p.drag = drag;
          Body body = shakenBody(mesh, 1e-3, 0);
          const Lab lab = evaluated({p, mesh, {body}, bestIsa()});
          const StabilityLimits limits = measureLimits(lab.bodies, 0);
          CHECK(limits.pressure == INFINITY);
          const auto growth = [&](double timeStep, int steps) {
            Lab swinging(p, mesh, {body}, bestIsa());
            swinging.start();
            Worst farthest;
            for (int i = 0; i < steps && farthest < 2; ++i) {
              swinging.step(timeStep);
              if (i % 100 == 0)
                for (int v = 0; v < 42; ++v)
                  farthest.see(norm(swinging.bodies.vertex(0, v) - measureCentre(swinging.bodies, 0)));
            }
            return double(farthest);
          };
          CAPTURE(static_cast<int>(integrator), damping, linear, drag, limits.spring);
          if (integrator == Integrator::explicitEuler && damping + drag == 0) {
            CHECK(limits.spring == 0);
            continue;
          }
          // A hundredth beyond the limit a deviation grows by a fiftieth or more per step, with explicit Euler by some
          // ten-thousandths.
          CHECK(growth(0.95 * limits.spring, integrator == Integrator::explicitEuler ? 20000 : 2000) < 1.01);
          CHECK_FALSE(growth(1.05 * limits.spring, 20000) < 1.5);
        }
}

TEST_CASE("The volume without a ring pass is the mesh's own for linear deformations") {
  const Mesh mesh = brick();
  const Matrix3 map = Matrix3::Identity() + 0.3 * randomMatrix(1);
  const PhysicsParameters p = matched();
  Lab lab(p, mesh, {mapped(mesh, map)});
  lab.stages = chooseStages(p, Isa::scalar, false);
  lab.evaluate();
  const double measured = measureVolume(lab.positions(), mesh.faces);
  CHECK(lab.bodies.volume[0] == Approx(measured).epsilon(1e-13));
  lab.stages = chooseStages(p, Isa::scalar, true);
  lab.bodies.volume[0] = 0;
  lab.evaluate();
  CHECK(lab.bodies.volume[0] == Approx(measured).epsilon(1e-13));
  CHECK(lab.bodies.pressure[0] == 0);
}
