#pragma once
// Judges worlds by measures that share no code with those of the program: volumes by a sum over faces, overlap by
// points in meshes, the shell by its equation.
#include <map>
#include <string>

#include "simulation/simulation.h"

namespace morula::chance {

/// Returns the first fault of the world; "" if there is none.
std::string ownVerdict(const World& world);

/// Returns all cells that ever lived, and their substances.
std::map<std::string, std::string> familyOf(const World& world);

/// Returns true if genes alone decide the lineage. Cells that perceive bodies, or wait for a size, also depend on
/// bodies.
bool isOfGenesAlone(const Scene& scene);

/// Returns true if measureEnergy measures all energy, and none is added while no cell divides, dies or connects.
bool isClosedBetweenEvents(const World& world);

/// A turn or a mirror image of scenes: `place` only changes the order and the signs of coordinates.
struct Turn {
  const char* name;
  Vector (*place)(const Vector&);
  bool mirrors = false;
  bool isExact = false;  // keeps the order of all sums, so that the copy has the same bits
};
extern const Turn turns[3];
Scene turned(Scene scene, const Turn& turn);

}  // namespace morula::chance
