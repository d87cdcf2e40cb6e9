#pragma once
// Whether a world is fine, by measures that share nothing with those of the program: volumes by a sum over faces,
// overlap by points in meshes, the shell by its equation.
#include <map>
#include <string>

#include "simulation/world.h"

namespace morula::chance {

/// What is wrong with the world; "" if nothing is.
std::string ownVerdict(const World& world);

/// All cells that ever lived, and what they hold.
std::map<std::string, std::string> familyOf(const World& world);

/// Whether genes alone decide the lineage; where cells perceive bodies, or wait for a size, bodies do, too.
bool isOfGenesAlone(const Scene& scene);

/// True where nothing but what is measured (measureEnergy) holds energy, and nothing adds any while no cell divides,
/// dies or connects.
bool isClosedBetweenEvents(const World& world);

/// A copy of the scene that is turned or mirrored: `place` only changes the order and the signs of coordinates.
struct Turn {
  const char* name;
  Vector (*place)(const Vector&);
  bool mirrors = false;
  bool isExact = false;  // it changes no order in which numbers are added, so the copy has the same bits
};
extern const Turn turns[3];
Scene turned(Scene scene, const Turn& turn);

}  // namespace morula::chance
