#pragma once
// Measures the cost of each mechanism on this machine, for one scene: the same steps with it and without it.
#include "simulation/world.h"

namespace morula {

/// [s] for one vertex and step, by the clock of one thread. What the scene lacks costs 0.
struct StepRates {
  double springs = 0, damping = 0, pressure = 0, shapeMatching = 0, drag = 0;
  double integration = 0, shell = 0, connections = 0;
  double snapshots = 0;
  double pair = 0, frictionOfPair = 0;  // for one evaluation of a vertex and a neighbour
  double search = 0;                    // for one vertex and search
};

/// Unused lanes cost as much as used ones: the vertices of the cells that kernels of this width go through
/// when `cells` live, over those of the cells.
double laneShare(Isa isa, std::uint64_t cells, Precision precision = Precision::binary64);

/// Rates for cells that fill all lanes; connections per vertex of the cells that are there. The world stays as it was.
/// Where no vertices of this scene touch, rates of contact are those of a few small packed cells.
StepRates measureRates(World& world);

/// [s] to write down the state's hash, and everything that a sample holds, for one vertex.
struct ObservationRates {
  double hash = 0, sample = 0;
};
ObservationRates measureObservation(const World& world);

}  // namespace morula
