#pragma once
// Bullet's two worlds behind one interface: the explicit one of B1 and B2, and the implicit one of B3.
#include <memory>
#include <vector>

#include "engines/bullet_scene.h"
#include "engines/bullet_soft_body.h"

namespace morula {

class BulletEngine {
 public:
  virtual ~BulletEngine() = default;
  virtual void step() = 0;
  virtual std::vector<Body> cells() = 0;  // velocities at the time of the positions
};

/// B1 and B2: btSoftRigidDynamicsWorld, symplectic Euler, with contact.
std::unique_ptr<BulletEngine> makeExplicitEngine(const BulletScene& scene);

/// B3: btDeformableMultiBodyDynamicsWorld, implicit; without contact and shell.
std::unique_ptr<BulletEngine> makeImplicitEngine(const BulletScene& scene);

}  // namespace morula
