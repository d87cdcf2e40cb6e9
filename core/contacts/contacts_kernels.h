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
  // The pair law's
  TemplateView mesh;
  int liveLanes;
  VertexNumber firstVertex;               // of the block
  RealPointer position;                   // [vertexCount][3][blockLanes]
  RealPointer surfaceForce, surfaceTurn;  // the same; scratch of the running thread
  double* deepest;                        // B u, the largest of the block's pairs
};

struct ContactConstants {
  double stiffness, damping, friction;  // ContactParameters
  double slipSpeed;                     // [length/time] below which friction fades out linearly
  double strongestGrip;                 // [force·time/length] the most that friction is, per slip speed
  double timeStep;                      // [time] the thesis' law depends on it [Nilsson 2008, eq. 4.8]
  std::int32_t vertices;                // number of rows, and the number of the far row behind them
  const double* adhesion;               // [as indices] of each pair (adhesion.h); null without adhesion
};

/// Squares of the largest changes of a block's vertices.
struct SnapshotChange {
  double farthest = 0;  // from the place in `reference` [length²]
  // For the pair law, since the snapshot before: how far y is from where v would have brought it; of n; of v.
  double strayed[blockLanes] = {}, turned[blockLanes] = {}, spedUp[blockLanes] = {};  // [lane]
};

/// Of lengths, for roundings in single precision (acting_kernel.h).
constexpr double relativeRoom = 1e-5;

/// One block's neighbour lists, and which pairs to leave out (acting_kernel.h).
struct ListsToThin {
  const std::int32_t *begin, *length;  // [vertex · blockLanes + lane]
  const VertexNumber* neighbours;
  static constexpr int readable = 32;  // numbers of rows behind the last neighbour
  int vertices, liveLanes;
  VertexNumber firstVertex;
  const float* halfMargins;  // [length] of each vertex; two make M
  double perRadius;          // [1/length] 1/R of the smallest R: what is (1 + M/R) R_ij apart is too far,
  double horizon;            // [time] if it is so until then,
  double delayPerRadius;     // [time/length] τ/R of the largest R: gaps beyond M + τ |u| M/R are too wide
  double ahead;              // [time] now and after this,
  double room;               // [length] and by so much more, for roundings,
  double roomPerSpeed;       // [time] and so much more per |u|
};

struct ContactKernels {
  /// Writes the rows of a block's vertices from position, predicted and gradient. `reference`:
  /// [vertexCount][3][blockLanes]; `sinceLast`: how long y have moved by v since the snapshot before [time].
  using TakeSnapshot = SnapshotChange (*)(const TemplateView&, const BlockView&, const double* inverseRadiusSquared,
                                          RealPointer reference, RowMemory* rows, double sinceLast);
  TakeSnapshot takeSnapshot, takeSphereSnapshot, takeSurface;
  /// force += contact forces on one block's vertices. `force` [all blocks]: vertex g at (g / 8)·24 + g % 8.
  using AddForces = void (*)(const BlockSlices&, const std::int32_t* indices, const RowMemory* rows,
                             const ContactConstants&, RealPointer force);
  AddForces addPairForces, addPairForcesWithFriction, addThesisForces;
  AddForces addSphereForces, addSphereForcesWithFriction;
  // With adhesion, and without or with friction.
  AddForces addStickyPairForces, addStickyPairForcesWithFriction;
  AddForces addStickySphereForces, addStickySphereForcesWithFriction;

  /// Writes the lists of those neighbours that may act, one after the other.
  void (*findActing)(const ListsToThin&, const RowMemory* rows, std::int32_t* begin, std::int32_t* length,
                     VertexNumber* acting);
};

const ContactKernels& contactKernels(Isa isa, Precision precision = Precision::binary64);

}  // namespace morula
