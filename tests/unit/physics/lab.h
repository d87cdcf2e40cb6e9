#pragma once
// A bench for the mechanics alone: a few bodies, moved and asked by hand, without world, biology or contact.
#include <vector>

#include "base/random.h"
#include "physics/stages.h"
#include "unit/mesh/zoo.h"
#include "worst.h"

namespace morula {

/// The cell of these tests. Their own, so that better defaults for users do not change what they prove.
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

  /// Forces at the positions now: force(slot, v) reads them.
  void evaluate() {
    for (int i = 0; i < bodies.blockCount(); ++i) advance(stages, bodies, bodies.block(i, 0), 0);
  }
  void endEvaluation(double timeStep = 0) {
    for (int i = 0; i < bodies.blockCount(); ++i) kick(stages, bodies, bodies.block(i, 0), timeStep);
  }
  /// Accelerations for the first step.
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
  /// On a cell as a whole.
  Vector forceOn(int slot) const {
    Vector sum;
    for (int v = 0; v < bodies.vertexCount(slot); ++v) sum += force(slot, v);
    return sum;
  }
  std::vector<Point> positions(int slot = 0) const { return takeBody(bodies, slot).position; }
  void setPosition(int slot, int v, const Point& x) { bodies.write(bodies.position, slot, v, x); }
  void setVelocity(int slot, int v, const Vector& u) { bodies.write(bodies.velocity, slot, v, u); }
};

/// With the forces of where its bodies are.
inline Lab evaluated(Lab lab) {
  lab.evaluate();
  return lab;
}

/// After so many steps from the start.
inline Lab stepped(Lab lab, int steps, double timeStep) {
  lab.start();
  for (int i = 0; i < steps; ++i) lab.step(timeStep);
  return lab;
}

/// The same every time: a number in [−1, 1), keyed by two numbers.
inline double noise(std::uint32_t a, std::uint32_t b = 0) {
  return 2 * randomUnit({20080617, {}, b, Purpose::test}, a) - 1;
}
inline Vector noiseVector(std::uint32_t a, std::uint32_t b = 0) {
  return {noise(3 * a, b), noise(3 * a + 1, b), noise(3 * a + 2, b)};
}

/// A rotation at random, by a unit quaternion.
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

/// A body of the mesh, without gas, with every vertex moved and moving at random.
inline Body shakenBody(const Mesh& mesh, double shift, double speed, std::uint32_t key = 0) {
  Body b{mesh.vertices, std::vector<Vector>(mesh.vertices.size()), 1, 1, 0};
  for (std::uint32_t v = 0; v < b.position.size(); ++v) {
    b.position[v] += shift * noiseVector(v, 2 * key);
    b.velocity[v] = speed * noiseVector(v, 2 * key + 1);
  }
  return b;
}

/// Of the mesh, at rest in itself, round a place.
inline Body ballAt(const Mesh& mesh, const Vector& place, double pressureConstant = 0) {
  Body b = shakenBody(zoo::moved(mesh, place), 0, 0);
  b.pressureConstant = pressureConstant;
  return b;
}

/// [mass·length/time] Of a cell, and of all, by their vertices.
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

/// The largest of all vertices of all cells. [length/time], [force]
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

/// [length] Of the first cell, around the origin.
inline double meanRadius(const Lab& lab) {
  double sum = 0;
  for (int v = 0; v < lab.bodies.vertexCount(); ++v) sum += norm(lab.bodies.vertex(0, v));
  return sum / lab.bodies.vertexCount();
}

}  // namespace morula
