#pragma once
// The baseline in Bullet that a scene is compared with.

namespace morula {

/// How much of the physics is Bullet's.
enum class Baseline {
  b1,  // our forces; Bullet's integrator and contact. The primary one: it differs in nothing else
  b2,  // Bullet's own links and pressure too, mapped to our constants; another spring law, so other
       // equilibria
  b3,  // our springs and pressure in Bullet's implicit world: where a cell rests, in large time steps; no
       // contact, no shell
};

/// "b1", "b2", "b3".
inline const char* name(Baseline baseline) {
  constexpr const char* names[] = {"b1", "b2", "b3"};
  return names[static_cast<int>(baseline)];
}

}  // namespace morula
