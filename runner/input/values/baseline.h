#pragma once
// The baseline in Bullet that a scene is compared with.

namespace morula {

/// The part of the physics that Bullet computes.
enum class Baseline {
  b1,  // our forces; Bullet's integrator and contact. The primary baseline: nothing else differs
  b2,  // Bullet's own links and pressure too, mapped to our constants; another spring law, so other
       // equilibria
  b3,  // our springs and pressure in Bullet's implicit world: equilibria, in large time steps; no
       // contact, no shell
};

inline const char* name(Baseline baseline) {
  constexpr const char* names[] = {"b1", "b2", "b3"};
  return names[static_cast<int>(baseline)];
}

}  // namespace morula
