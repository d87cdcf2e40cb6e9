#pragma once
// What a scene consists of, struct by struct: the one list that writing and reading share (scene_format.cpp). A member that is
// missing in it does not compile. Whatever changes here changes the format: raise its version.
#include <tuple>

#include "simulation/scene.h"

namespace morula::scene_format {

inline auto fields(Vector& a) {
  auto& [x, y, z] = a;
  return std::tie(x, y, z);
}
inline auto fields(Face& a) {
  auto& [i, j, k] = a;
  return std::tie(i, j, k);
}
inline auto fields(Mesh& a) {
  auto& [vertices, faces] = a;
  return std::tie(vertices, faces);
}
inline auto fields(Gene& a) {
  auto& [name, product, inputs, repressors] = a;
  return std::tie(name, product, inputs, repressors);
}
inline auto fields(Dna& a) {
  auto& [substances, start, genes, source, warnings] = a;
  return std::tie(substances, start, genes, source, warnings);
}
inline auto fields(DivisionSize& a) {
  auto& [rule, size] = a;
  return std::tie(rule, size);
}
inline auto fields(CycleParameters& a) {
  auto& [length, perSubstance, atBirth, divisionSize] = a;
  return std::tie(length, perSubstance, atBirth, divisionSize);
}
inline auto fields(Threshold& a) {
  auto& [below, above, atMost, atLeast, until] = a;
  return std::tie(below, above, atMost, atLeast, until);
}
inline auto fields(SenseParameters& a) {
  auto& [substance, kind, is, of, number, axis, lives] = a;
  return std::tie(substance, kind, is, of, number, axis, lives);
}
inline auto fields(StopParameters& a) {
  auto& [cycles, time, cells] = a;
  return std::tie(cycles, time, cells);
}
inline auto fields(CellParameters& a) {
  auto& [radius, mass, model] = a;
  return std::tie(radius, mass, model);
}
inline auto fields(ShapeMatchingParameters& a) {
  auto& [stiffness, linear, damping] = a;
  return std::tie(stiffness, linear, damping);
}
inline auto fields(MembraneParameters& a) {
  auto& [stiffness, damping, production, springs] = a;
  return std::tie(stiffness, damping, production, springs);
}
inline auto fields(PressureParameters& a) {
  auto& [constant, outside] = a;
  return std::tie(constant, outside);
}
inline auto fields(GrowthParameters& a) {
  auto& [rate, until] = a;
  return std::tie(rate, until);
}
inline auto fields(MotilityParameters& a) {
  auto& [speed, persistence] = a;
  return std::tie(speed, persistence);
}
inline auto fields(ShellPlane& a) {
  auto& [normal, offset] = a;
  return std::tie(normal, offset);
}
inline auto fields(ConvexShell& a) {
  auto& [mesh, planes] = a;
  return std::tie(mesh, planes);
}
inline auto fields(ShellParameters& a) {
  auto& [semiAxes, mesh, holds] = a;
  return std::tie(semiAxes[0], semiAxes[1], semiAxes[2], mesh, holds);
}
inline auto fields(PhysicsParameters& a) {
  auto& [coarsen, timeStep, autoShare, integrator, substeps, precision, cell, membrane, pressure,
         shapeMatching, drag, growth, shell, motility] = a;
  return std::tie(coarsen, timeStep, autoShare, integrator, substeps, precision, cell, membrane, pressure,
                  shapeMatching, drag, growth, shell, motility);
}
inline auto fields(AdhesionPair& a) {
  auto& [first, second, strength] = a;
  return std::tie(first, second, strength);
}
inline auto fields(AdhesionParameters& a) {
  auto& [strength, pairs] = a;
  return std::tie(strength, pairs);
}
inline auto fields(ContactParameters& a) {
  auto& [law, stiffness, damping, friction, slipSpeed, radius, adhesion] = a;
  return std::tie(law, stiffness, damping, friction, slipSpeed, radius, adhesion);
}
inline auto fields(PlaneChoice& a) {
  auto& [plane, axis, substance, turnsAway] = a;
  return std::tie(plane, axis, substance, turnsAway);
}
inline auto fields(Chirality& a) {
  auto& [angle, time] = a;
  return std::tie(angle, time);
}
inline auto fields(DivisionRule& a) {
  auto& [of, plane, share, tilt, chirality] = a;
  return std::tie(of, plane, share, tilt, chirality);
}
inline auto fields(DivisionParameters& a) {
  auto& [otherwise, rules, chirality] = a;
  return std::tie(otherwise, rules, chirality);
}
inline auto fields(ConnectedPair& a) {
  auto& [first, second] = a;
  return std::tie(first, second);
}
inline auto fields(ConnectionSpring& a) {
  auto& [stiffness, rest] = a;
  return std::tie(stiffness, rest);
}
inline auto fields(ConnectionParameters& a) {
  auto& [make, onDivision, strength, releaseDistance, pairs, spring, releaseTension, releaseAge, most] = a;
  return std::tie(make, onDivision, strength, releaseDistance, pairs, spring, releaseTension, releaseAge,
                  most);
}
inline auto fields(MechanicsScene& a) {
  auto& [physics, mesh, coarser, contact, division, connections] = a;
  return std::tie(physics, mesh, coarser, contact, division, connections);
}
inline auto fields(StartCell& a) {
  auto& [at, velocity, scale, stretch, mass, substances] = a;
  return std::tie(at, velocity, scale, stretch, mass, substances);
}
inline auto fields(VariationParameters& a) {
  auto& [cycle, share, start, tilt, adhesion] = a;
  return std::tie(cycle, share, start, tilt, adhesion);
}
inline auto fields(Scene& a) {
  auto& [name, seed, dna, cycle, stop, mechanics, cells, variation, senses] = a;
  return std::tie(name, seed, dna, cycle, stop, mechanics, cells, variation, senses);
}

}  // namespace morula::scene_format
