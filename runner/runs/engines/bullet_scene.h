#pragma once
// A scene for Bullet, in plain structs: the questions to this module and its answers.
#include <vector>

#include "mesh/mesh.h"
#include "physics/bodies.h"
#include "physics/parameters.h"
#include "values/baseline.h"

namespace morula {

struct BulletScene {
  Baseline baseline = Baseline::b1;
  Mesh mesh;  // the egg in its size, to which rest lengths refer
  // Used: membrane, pressure.outside, drag and shell; and for B1, whether the integrator is thesisVerlet. Bullet's step
  // is v' = v + Δt a, x' = x + Δt v'. With half a first kick, and forces for the velocity at the time of the positions,
  // this is velocity Verlet, of second order: B1's default. With a whole first kick, and Bullet's own velocity, half a
  // step old, it is the thesis' Verlet, of first order: B1 for thesisVerlet, so that both can be compared vertex by
  // vertex.
  PhysicsParameters physics;
  std::vector<Body> cells;
  double timeStep = 0x1p-8;  // [time] a power of two: Bullet takes the step as a float, even in double precision
  bool contact = true;       // vertices of a cell against faces of others
  double margin = 0.01;      // [length] of each surface: cells at rest against each other are two margins apart
  int iterations = 1;        // iterations of Bullet's position solver in a step: contacts, B2's links

  bool touching() const { return contact && cells.size() > 1; }
};

struct BulletRequest {
  BulletScene scene;
  int steps = 1;
  std::vector<int> reports = {};  // rising: steps after which cells are reported, too
};

struct BulletResult {
  std::vector<Body> cells;                      // after the last step
  std::vector<double> stepSeconds;              // CPU time of each step
  std::vector<std::vector<Body>> reports = {};  // after the requested steps
};

/// Returns true if this program was built with Bullet in double precision.
bool bulletIsAvailable();

}  // namespace morula
