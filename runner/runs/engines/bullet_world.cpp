#include "engines/bullet_world.h"

#include "engines/bullet_engine.h"

namespace morula {

struct BulletWorld::State {
  std::unique_ptr<BulletEngine> engine;
};

BulletWorld::BulletWorld(const BulletScene& scene)
    : state_(std::make_unique<State>(
          State{scene.baseline == Baseline::b3 ? makeImplicitEngine(scene) : makeExplicitEngine(scene)})) {}
BulletWorld::~BulletWorld() = default;

void BulletWorld::step() { state_->engine->step(); }
std::vector<Body> BulletWorld::cells() const { return state_->engine->cells(); }

bool bulletIsAvailable() { return true; }

}  // namespace morula
