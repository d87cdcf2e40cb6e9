#pragma once
// A bench for the mechanics alone: a few bodies, moved and asked by hand, without world, biology or contact.
#include <vector>

#include "base/random.h"
#include "mesh/measures.h"
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
  std::vector<Point> positions(int slot = 0) const { return takeBody(bodies, slot).position; }
  void setPosition(int slot, int v, const Point& x) { bodies.write(bodies.position, slot, v, x); }
  void setVelocity(int slot, int v, const Vector& u) { bodies.write(bodies.velocity, slot, v, u); }
};

/// The same every time: a number in [−1, 1), keyed by two numbers.
inline double noise(std::uint32_t a, std::uint32_t b = 0) {
  return 2 * randomUnit({20080617, {}, b, Purpose::test}, a) - 1;
}
inline Vector noiseVector(std::uint32_t a, std::uint32_t b = 0) {
  return {noise(3 * a, b), noise(3 * a + 1, b), noise(3 * a + 2, b)};
}

/// A body of the mesh, without gas, with every vertex moved and moving at random.
inline Body shakenBody(const Mesh& mesh, double shift, double speed, std::uint32_t key = 0) {
  Body b{mesh.vertices, std::vector<Vector>(mesh.vertices.size()), 1, 1, 0};
  for (std::uint32_t v = 0; v < b.position.size(); ++v) {
    b.position[v] += shift * noiseVector(v, 2 * key);
    b.velocity[v] = speed * noiseVector(v, 2 * key + 1);
  }
  return b;
}

/// [length] Of the first cell, around the origin.
inline double meanRadius(const Lab& lab) {
  double sum = 0;
  for (int v = 0; v < lab.bodies.vertexCount(); ++v) sum += norm(lab.bodies.vertex(0, v));
  return sum / lab.bodies.vertexCount();
}

}  // namespace morula
