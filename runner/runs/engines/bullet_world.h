#pragma once
// A scene in motion in Bullet. One per process: what Bullet computes depends on what it did before.
#include <memory>
#include <vector>

#include "engines/bullet_scene.h"

namespace morula {

class BulletWorld {
 public:
  /// Throws FileError if Bullet is absent, BugError if its library is not the one of its headers.
  explicit BulletWorld(const BulletScene& scene);
  ~BulletWorld();
  BulletWorld(const BulletWorld&) = delete;
  BulletWorld& operator=(const BulletWorld&) = delete;

  void step();
  std::vector<Body> cells() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace morula
