#pragma once
// Scenes of cells that connect.
#include "worlds.h"

namespace morula {

/// Returns a scene of cells that touch, are cut across x and connect.
inline Scene connecting(const std::string& dna, const ConnectionParameters& parameters) {
  Scene scene = scenes::withBodies(dna, 9);
  scene.mechanics->contact = scenes::pairContact;
  scene.mechanics->division = {DivisionPlane::axis, {1, 0, 0}};
  scene.mechanics->connections = parameters;
  scene.mechanics->physics.drag = 5;  // sisters that round off must not fly apart
  return scene;
}

inline ConnectionParameters withPolicy(MakeConnections make, ConnectionsOnDivision onDivision) {
  ConnectionParameters p;
  p.make = make;
  p.onDivision = onDivision;
  p.strength = 0.05;
  return p;
}

inline Scene connecting(const std::string& dna, MakeConnections make, ConnectionsOnDivision onDivision) {
  return connecting(dna, withPolicy(make, onDivision));
}

}  // namespace morula
