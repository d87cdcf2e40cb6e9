#pragma once
// The kernels of contact, one table per instruction set and precision. Those that search: search_kernels.h.
#include "base/isa.h"
#include "base/precision.h"
#include "contacts/parameters.h"
#include "contacts/snapshot.h"
#include "physics/block.h"

namespace morula {

/// Neighbours of up to eight vertices, those with lists of like length together: entry k of lane l is the block's
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
  const double *vertexMass, *sag;  // [lane]
  std::int64_t nextLine;           // where the next block's vertices begin (BlockPlace::firstLine):
  std::int64_t linesPerSlice;      // so many of them for each slice
  // The pair law's; of every law firstVertex, position and velocity, to prefetch the next block's
  TemplateView mesh;
  int liveLanes;
  VertexNumber firstVertex;               // of the block
  RealPointer position, velocity;         // [vertexCount][3][blockLanes]
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

/// The change of a block's snapshots since pairs were chosen (acting_kernel.h).
struct ChangeCount {
  float* change;                                       // [vertex · blockLanes + lane] of gaps [length]
  float* speeds;                                       // the same: of velocities [length/time]
  double margin;                                       // of gaps [length]
  double sinceLast;                                    // [time] how long y have moved by v since the snapshot before
  double perStraying, perTurning, perSpeed, perDrift;  // 2ν [1], R [length], 2ντ [time], 2ν times sinceLast [time]
  std::int32_t* ended;                                 // rows whose change has reached the margin
  std::int32_t endedCount;
};

/// Relative room in lengths for roundings in single precision (acting_kernel.h).
constexpr double relativeRoom = 1e-5;

/// Neighbour lists of one block, and which pairs to leave out (acting_kernel.h).
struct ListsToThin {
  const std::int32_t *begin, *length;  // [row = vertex · blockLanes + lane]
  const VertexNumber* neighbours;
  static constexpr int readable = 32;  // numbers of rows behind the last neighbour
  const std::int32_t* rows;            // [count] whose lists are asked for
  std::int32_t count;
  VertexNumber firstVertex;
  double reach;         // [1] what is so many R_ij apart is too far,
  double horizon;       // [time] if it is so until then
  double ahead;         // [time] now and after this
  double room;          // [length] gaps beyond this are too wide,
  double roomPerSpeed;  // [time] and this times |u|
};

struct ContactKernels {
  /// Writes the rows of a block's vertices from position, predicted and gradient. `reference`:
  /// [vertexCount][3][blockLanes]. The square of the largest distance from there [length²].
  using TakeSnapshot = double (*)(const TemplateView&, const BlockView&, const double* inverseRadiusSquared,
                                  RealPointer reference, RowMemory* rows, ChangeCount&);
  TakeSnapshot takeSnapshot, takeSphereSnapshot, takeSurface, takeSurfaceAndCount;
  /// force += contact forces on one block's vertices. `force` [all blocks]: vertex g at (g / 8)·24 + g % 8.
  using AddForces = void (*)(const BlockSlices&, const std::int32_t* indices, const RowMemory* rows,
                             const ContactConstants&, RealPointer force);
  AddForces addPairForces, addPairForcesWithFriction, addThesisForces;
  AddForces addSphereForces, addSphereForcesWithFriction;
  // Kernels with adhesion, without and with friction.
  AddForces addStickyPairForces, addStickyPairForcesWithFriction;
  AddForces addStickySphereForces, addStickySphereForcesWithFriction;

  /// largest[lane] = S of the pair law, the largest of this cell's pairs. `vertices`: the far row's number.
  void (*findSteepest)(const BlockSlices&, const std::int32_t* indices, const RowMemory* rows, std::int32_t vertices,
                       double* largest);

  /// Writes the asked rows' lists of those neighbours that may act, one after the other; `begin`, `length`: [row].
  void (*findActing)(const ListsToThin&, const RowMemory* rows, std::int32_t* begin, std::int32_t* length,
                     VertexNumber* acting);
};

const ContactKernels& contactKernels(Isa isa, Precision precision = Precision::binary64);

}  // namespace morula
