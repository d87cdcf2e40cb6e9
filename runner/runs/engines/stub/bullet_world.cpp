// Replaces the engine where Bullet is not installed: reports that, and lets the rest work.
#include "engines/bullet_world.h"

#include "base/error.h"

namespace morula {

std::unique_ptr<BulletWorld> makeBulletWorld(const BulletScene&) {
  throw FileError("this program was built without Bullet: install libbullet-dev and build again");
}

bool bulletIsAvailable() { return false; }

}  // namespace morula
