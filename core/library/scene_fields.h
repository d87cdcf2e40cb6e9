#pragma once
// The members of a scene, struct by struct: the one list that writing and reading share (scene_format.cpp). A missing
// member does not compile. A change of this list changes the format: raise its version.
#include <tuple>

#include "simulation/scene.h"

namespace morula::scene_format {

#define MORULA_FIELDS(Struct, ...) \
  inline auto fields(Struct& a) {  \
    auto& [__VA_ARGS__] = a;       \
    return std::tie(__VA_ARGS__);  \
  }

MORULA_FIELDS(Vector, x, y, z)
MORULA_FIELDS(Face, i, j, k)
MORULA_FIELDS(Mesh, vertices, faces)
MORULA_FIELDS(Gene, name, product, inputs, repressors)
MORULA_FIELDS(Dna, substances, start, genes, source, warnings)
MORULA_FIELDS(DivisionSize, rule, size)
MORULA_FIELDS(CycleParameters, length, perSubstance, atBirth, divisionSize)
MORULA_FIELDS(Threshold, below, above, atMost, atLeast, until)
MORULA_FIELDS(SenseParameters, substance, kind, is, of, number, axis, lives)
MORULA_FIELDS(StopParameters, cycles, time, cells)
MORULA_FIELDS(CellParameters, radius, mass, model)
MORULA_FIELDS(ShapeMatchingParameters, stiffness, linear, damping)
MORULA_FIELDS(MembraneParameters, stiffness, damping, production, springs)
MORULA_FIELDS(PressureParameters, constant, outside)
MORULA_FIELDS(GrowthParameters, rate, until)
MORULA_FIELDS(MotilityParameters, speed, persistence)
MORULA_FIELDS(SettleParameters, tolerance, evaluations, together, sample)
MORULA_FIELDS(ShellPlane, normal, offset)
MORULA_FIELDS(ConvexShell, mesh, planes)
inline auto fields(ShellParameters& a) {
  auto& [semiAxes, mesh, holds] = a;
  return std::tie(semiAxes[0], semiAxes[1], semiAxes[2], mesh, holds);
}
MORULA_FIELDS(PhysicsParameters, coarsen, timeStep, autoShare, integrator, substeps, precision, cell, membrane,
              pressure, shapeMatching, drag, growth, shell, motility, settle)
MORULA_FIELDS(AdhesionPair, first, second, strength)
MORULA_FIELDS(AdhesionParameters, strength, pairs)
MORULA_FIELDS(ContactParameters, law, stiffness, damping, friction, slipSpeed, radius, adhesion)
MORULA_FIELDS(PlaneChoice, plane, axis, substance, turnsAway)
MORULA_FIELDS(Chirality, angle, time)
MORULA_FIELDS(DivisionRule, of, plane, share, tilt, chirality)
MORULA_FIELDS(DivisionParameters, otherwise, rules, chirality)
MORULA_FIELDS(ConnectedPair, first, second)
MORULA_FIELDS(ConnectionSpring, stiffness, rest)
MORULA_FIELDS(ConnectionParameters, make, onDivision, strength, releaseDistance, pairs, spring, releaseTension,
              releaseAge, most)
MORULA_FIELDS(MechanicsScene, physics, mesh, coarser, contact, division, connections)
MORULA_FIELDS(StartCell, at, velocity, scale, turn, stretch, mass, substances)
MORULA_FIELDS(VariationParameters, cycle, share, start, tilt, adhesion)
MORULA_FIELDS(Scene, name, seed, dna, cycle, stop, mechanics, cells, variation, senses)

#undef MORULA_FIELDS

}  // namespace morula::scene_format
