// Stands in where Bullet is not installed: this part says so, and the rest works.
#include "engines/bullet_world.h"

#include "base/error.h"

namespace morula {

struct BulletWorld::State {};

BulletWorld::BulletWorld(const BulletScene&) {
  throw FileError("this program was built without Bullet: install libbullet-dev and build again");
}
BulletWorld::~BulletWorld() = default;
void BulletWorld::step() {}
std::vector<Body> BulletWorld::cells() const { return {}; }

bool bulletIsAvailable() { return false; }

}  // namespace morula
