#pragma once
// Measures the cost of each mechanism on this machine for a scene, by the same steps with and without the mechanism.
#include "simulation/simulation.h"

namespace morula {

/// The times of mechanisms for one vertex and step [s], of one thread. A mechanism that the scene lacks costs 0.
struct StepRates {
  double springs = 0, damping = 0, bending = 0, pressure = 0, shapeMatching = 0, drag = 0;
  double integration = 0, shell = 0, connections = 0;
  double snapshots = 0;
  double pair = 0, viscosityOfPair = 0;  // for one evaluation of a pair of vertex and neighbour
  double search = 0;                     // for one vertex and search
};

/// Returns the lanes that kernels of this width go through when `cells` live, over the used ones, since unused lanes
/// cost as much.
double laneShare(Isa isa, std::uint64_t cells, Precision precision = Precision::binary64);

/// Measures rates for cells that fill all lanes; those of connections are per vertex of the present cells. The world is
/// restored. If no vertices of the scene touch, rates of contact are those of a few small packed cells.
StepRates measureRates(World& world);

/// The times [s] of the state's hash and of a whole sample, for one vertex.
struct ObservationRates {
  double hash = 0, sample = 0;
};
ObservationRates measureObservation(const World& world);

}  // namespace morula
