#pragma once
// The kernels of contact, one table per instruction set and precision. Those that search: search_kernels.h.
#include "base/isa.h"
#include "base/precision.h"
#include "contacts/parameters.h"
#include "contacts/snapshot.h"
#include "physics/block.h"

namespace morula {

/// Neighbours of up to eight vertices, those with lists of like length together: entry k of lane l is
/// indices[(start + k)·8 + l]. Each list runs in rising order of vertex numbers, so sums have one order.
struct NeighbourSlice {
  VertexNumber vertex[blockLanes];  // the far row where there is none
  std::int64_t start;
  std::int32_t length;
};

/// Kernels prefetch rows so many lines of indices before they use them; behind the last line stand as many of
/// the far row.
constexpr int linesPrefetched = 8;

/// One block's part of the list, and what else its kernel needs.
struct BlockSlices {
  const NeighbourSlice* slices;
  std::int64_t count;
  const double* vertexMass;  // [lane]
  std::int64_t nextLine;     // where the next block's vertices begin (BlockPlace::firstLine)
  // The energy law's
  TemplateView mesh;
  int liveLanes;
  VertexNumber firstVertex;               // of the block
  RealPointer position;                   // [vertexCount][3][blockLanes]
  RealPointer surfaceForce, surfaceTurn;  // the same; scratch of the running thread
};

struct ContactConstants {
  double stiffness, damping, friction;  // ContactParameters
  double slipSpeed;                     // [length/time] below which friction fades out linearly
  double strongestGrip;                 // [force·time/length] the most that friction is, per slip speed
  double timeStep;                      // [time] the thesis' law depends on it [Nilsson 2008, eq. 4.8]
  std::int32_t vertices;                // number of rows, and the number of the far row behind them
  const double* adhesion;               // [as indices] of each pair (adhesion.h); null without adhesion
};

struct ContactKernels {
  /// Writes the rows of a block's vertices from position, predicted and gradient. Returns the largest squared
  /// distance of a row from its place in `reference` ([vertexCount][3][blockLanes]). [length²]
  using TakeSnapshot = double (*)(const TemplateView&, const BlockView&, const double* inverseRadiusSquared,
                                  RealPointer reference, RowMemory* rows);
  TakeSnapshot takeSnapshot, takeSphereSnapshot, takeSurface;
  /// force += contact forces on one block's vertices. `force` [all blocks]: vertex g at (g / 8)·24 + g % 8.
  using AddForces = void (*)(const BlockSlices&, const std::int32_t* indices, const RowMemory* rows,
                             const ContactConstants&, RealPointer force);
  AddForces addPairForces, addPairForcesWithFriction, addThesisForces;
  AddForces addSphereForces, addSphereForcesWithFriction;
  // With adhesion, and without or with friction.
  AddForces addStickyPairForces, addStickyPairForcesWithFriction;
  AddForces addEnergyForces, addEnergyForcesWithFriction, addStickyEnergyForces, addStickyEnergyForcesWithFriction;
  AddForces addStickySphereForces, addStickySphereForcesWithFriction;
};

const ContactKernels& contactKernels(Isa isa, Precision precision = Precision::binary64);

}  // namespace morula
