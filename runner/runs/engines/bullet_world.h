#pragma once
// A scene in motion in Bullet. Each needs a process of its own: Bullet's results depend on earlier computations.
#include <memory>
#include <vector>

#include "engines/bullet_scene.h"

namespace morula {

class BulletWorld {
 public:
  virtual ~BulletWorld() = default;
  virtual void step() = 0;
  virtual std::vector<Body> cells() = 0;  // velocities at the time of the positions
};

/// Makes a world. B1 and B2: btSoftRigidDynamicsWorld, symplectic Euler, with contact. B3:
/// btDeformableMultiBodyDynamicsWorld, implicit, without contact and shell. Throws FileError if Bullet is absent,
/// BugError if its library does not match its headers.
std::unique_ptr<BulletWorld> makeBulletWorld(const BulletScene& scene);

}  // namespace morula
