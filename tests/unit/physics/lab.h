#pragma once
// A bench for the mechanics alone: a few bodies, moved and evaluated by hand, without world, biology or contact.
#include <vector>

#include "base/random.h"
#include "physics/stages.h"
#include "unit/mesh/zoo.h"
#include "worst.h"

namespace morula {

/// Returns the cell of the tests: new defaults for users must not change what the tests prove.
inline PhysicsParameters softCell() {
  PhysicsParameters p;
  p.membrane = {40, 0.05, 1.26, Springs::equal};
  p.pressure = {4, 0};
  return p;
}

struct Lab {
  Bodies bodies;
  PhysicsStages stages;

  Lab(const PhysicsParameters& p, const Mesh& egg, Isa isa = Isa::scalar)
      : bodies(makeBodies(p, egg, 1)), stages(chooseStages(p, isa)) {
    setBodies(bodies, {makeEgg(bodies)});
  }
  Lab(const PhysicsParameters& p, const Mesh& egg, const std::vector<Body>& cells, Isa isa = Isa::scalar)
      : bodies(makeBodies(p, egg, 1)), stages(chooseStages(p, isa)) {
    setBodies(bodies, cells);
  }

  /// Evaluates forces at the present positions; force(slot, v) reads them.
  void evaluate() {
    for (int i = 0; i < bodies.blockCount(); ++i) advance(stages, bodies, bodies.block(i, 0), 0);
  }
  void endEvaluation(double timeStep = 0) {
    for (int i = 0; i < bodies.blockCount(); ++i) kick(stages, bodies, bodies.block(i, 0), timeStep);
  }
  /// Evaluates the accelerations for the first step.
  void start() { step(0); }
  void step(double timeStep) {
    for (int i = 0; i < bodies.blockCount(); ++i) {
      advance(stages, bodies, bodies.block(i, 0), timeStep);
      kick(stages, bodies, bodies.block(i, 0), timeStep);
      for (std::size_t k = 0; k < stages.furtherDrifts.size(); ++k) {
        const PhysicsStages further = furtherStages(stages, k);
        advance(further, bodies, bodies.block(i, 0), timeStep);
        kick(further, bodies, bodies.block(i, 0), timeStep);
      }
    }
  }

  Vector force(int slot, int v) const { return bodies.read(bodies.acceleration, slot, v); }
  Vector velocity(int slot, int v) const { return bodies.read(bodies.velocity, slot, v); }
  /// Returns the net force on a cell.
  Vector forceOn(int slot) const {
    Vector sum;
    for (int v = 0; v < bodies.vertexCount(slot); ++v) sum += force(slot, v);
    return sum;
  }
  std::vector<Point> positions(int slot = 0) const { return takeBody(bodies, slot).position; }
  void setPosition(int slot, int v, const Point& x) { bodies.write(bodies.position, slot, v, x); }
  void setVelocity(int slot, int v, const Vector& u) { bodies.write(bodies.velocity, slot, v, u); }
};

/// Returns the lab with forces evaluated at its present positions.
inline Lab evaluated(Lab lab) {
  lab.evaluate();
  return lab;
}

/// Returns the lab after `steps` steps from the start.
inline Lab stepped(Lab lab, int steps, double timeStep) {
  lab.start();
  for (int i = 0; i < steps; ++i) lab.step(timeStep);
  return lab;
}

/// Returns a reproducible number in [−1, 1), keyed by two numbers.
inline double noise(std::uint32_t a, std::uint32_t b = 0) {
  return 2 * randomUnit({20080617, {}, b, Purpose::test}, a) - 1;
}
inline Vector noiseVector(std::uint32_t a, std::uint32_t b = 0) {
  return {noise(3 * a, b), noise(3 * a + 1, b), noise(3 * a + 2, b)};
}

/// A random rotation by a unit quaternion, keyed by a number.
struct Turn {
  double w;
  Vector v;
  explicit Turn(std::uint32_t key) {
    const double a = noise(0, key);
    const Vector b{noise(1, key), noise(2, key), noise(3, key)};
    const double size = std::sqrt(a * a + dot(b, b));
    w = a / size, v = b / size;
  }
  Vector operator()(const Vector& a) const { return a + 2 * cross(v, cross(v, a) + w * a); }
};

/// Returns a body of the mesh without gas, with every vertex displaced and moving at random.
inline Body shakenBody(const Mesh& mesh, double shift, double speed, std::uint32_t key = 0) {
  Body b{mesh.vertices, std::vector<Vector>(mesh.vertices.size()), 1, 1, 0};
  for (std::uint32_t v = 0; v < b.position.size(); ++v) {
    b.position[v] += shift * noiseVector(v, 2 * key);
    b.velocity[v] = speed * noiseVector(v, 2 * key + 1);
  }
  return b;
}

/// Returns a body of the mesh at `place`, at rest.
inline Body ballAt(const Mesh& mesh, const Vector& place, double pressureConstant = 0) {
  Body b = shakenBody(zoo::moved(mesh, place), 0, 0);
  b.pressureConstant = pressureConstant;
  return b;
}

/// Return the momentum of a cell or of all cells, from vertices. [mass·length/time]
inline Vector momentumOf(const Bodies& b, int slot) {
  Vector sum;
  for (int v = 0; v < b.vertexCount(slot); ++v) sum += b.vertexMass[slot] * b.read(b.velocity, slot, v);
  return sum;
}
inline Vector momentumOf(const Bodies& b) {
  Vector sum;
  for (int slot : b.slots) sum += momentumOf(b, slot);
  return sum;
}

/// Return the largest speed [length/time] and the largest force [force] of all vertices of all cells.
inline double fastestVertex(const Bodies& b) {
  Worst speed;
  for (int slot : b.slots)
    for (int v = 0; v < b.vertexCount(slot); ++v) speed.see(norm(b.read(b.velocity, slot, v)));
  return speed;
}
inline double largestForce(const Lab& lab) {
  Worst force;
  for (int slot : lab.bodies.slots)
    for (int v = 0; v < lab.bodies.vertexCount(slot); ++v) force.see(norm(lab.force(slot, v)));
  return force;
}

/// Returns the mean distance of the first cell's vertices from the origin. [length]
inline double meanRadius(const Lab& lab) {
  double sum = 0;
  for (int v = 0; v < lab.bodies.vertexCount(); ++v) sum += norm(lab.bodies.vertex(0, v));
  return sum / lab.bodies.vertexCount();
}

}  // namespace morula
