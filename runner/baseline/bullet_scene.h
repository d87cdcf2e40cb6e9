#pragma once
// A scene for Bullet, in plain structs: what this room is asked and what it answers.
#include <vector>

#include "mesh/mesh.h"
#include "physics/bodies.h"
#include "physics/parameters.h"

namespace morula {

/// How much of the physics is Bullet's.
enum class Baseline {
  b1,  // our forces; Bullet's integrator and contact. The primary one: it differs in nothing else
  b2,  // Bullet's own links and pressure too, mapped to our constants; another spring law, so other
       // equilibria
  b3,  // our springs and pressure in Bullet's implicit world: where a cell rests, in large time steps; no
       // contact, no shell
};

struct BulletScene {
  Baseline baseline = Baseline::b1;
  Mesh mesh;                  // the egg in its size: what rest lengths refer to
  PhysicsParameters physics;  // membrane, pressure.outside, drag and shell count; not the integrator
  std::vector<Body> cells;
  double timeStep = 0x1p-8;  // [time] a power of two: Bullet takes it as a float, even in double precision
  bool contact = true;       // vertices of a cell against faces of others
  double margin = 0.01;  // [length] of each surface: cells at rest against each other are two of them apart
};

struct BulletRequest {
  BulletScene scene;
  int steps = 1;
};

struct BulletResult {
  std::vector<Body> cells;          // after the last step
  std::vector<double> stepSeconds;  // CPU time of each step
};

/// True if this program was built with Bullet in double precision.
bool bulletIsAvailable();

/// "b1", "b2", "b3".
const char* name(Baseline baseline);

}  // namespace morula
