#pragma once
// The kernels of contact, one table per instruction set and precision. Kernels that search are in search_kernels.h.
#include "base/isa.h"
#include "base/precision.h"
#include "contacts/parameters.h"
#include "contacts/snapshot.h"
#include "physics/block.h"

namespace morula {

/// Neighbours of up to eight vertices with lists of like length: entry k of lane l is the block's indices[(start + k)·8
/// + l]. Each list runs in rising order of vertex numbers, so sums have one order.
struct NeighbourSlice {
  VertexNumber vertex[blockLanes];  // lanes without a vertex have the far row
  std::int64_t start;
  std::int32_t length;
};

/// Kernels prefetch rows this many lines of indices ahead. As many lines of the far row stand behind the last line.
constexpr int linesPrefetched = 8;

/// One block's part of the list, and the other inputs of its kernel.
struct BlockSlices {
  const NeighbourSlice* slices;
  std::int64_t count;
  const double *vertexMass, *sag;  // [lane]
  std::int64_t nextLine;           // first line of the next block (BlockPlace::firstLine), to prefetch it
  std::int64_t linesPerSlice;      // lines of the next block to prefetch with each slice
  const NeighbourSlice* nextSlices;
  const std::int32_t* nextIndices;  // of the next block, to prefetch them
  // For the pair law. Every law uses firstVertex, position and velocity to prefetch the next block.
  TemplateView mesh;
  int liveLanes;
  VertexNumber firstVertex;               // first vertex of the block
  RealPointer position, velocity;         // [vertexCount][3][blockLanes]
  RealPointer surfaceForce, surfaceTurn;  // laid out as position; scratch of the running thread
  double* deepest;                        // max B u of the block's pairs
};

struct ContactConstants {
  double stiffness, damping, viscosity;  // ContactParameters
  double slipSpeed;                      // [length/time] below which viscosity fades out linearly
  double strongestGrip;                  // [force·time/length] max force of viscosity per slip speed
  double timeStep;                       // [time] the thesis' law depends on it [Nilsson 2008, eq. 4.8]
  std::int32_t vertices;                 // number of rows, and the number of the far row behind them
  // The next three are null without adhesion (adhesion.h).
  const double *adhesion, *adhesionPerWork;  // [as indices] T [energy] of each pair, and T for W = 1
  const double* saturation;                  // [vertex][2] ½ s [1] and q [force/length]; not for spheres
};

/// The change of a block's snapshots since pairs were chosen (acting_kernel.h).
struct ChangeCount {
  float* change;                                       // [vertex · blockLanes + lane] of gaps [length]
  float* speeds;                                       // [vertex · blockLanes + lane] of velocities [length/time]
  double margin;                                       // max change of gaps [length]
  double sinceLast;                                    // [time] for which y have moved by v since the last snapshot
  double perStraying, perTurning, perSpeed, perDrift;  // 2ν [1], R [length], 2ντ [time], 2ν times sinceLast [time]
  std::int32_t* ended;                                 // rows whose change has reached the margin
  std::int32_t endedCount;
};

/// Relative room in lengths for roundings in single precision (acting_kernel.h).
constexpr double relativeRoom = 1e-5;

/// Neighbour lists of one block, and the criteria for pairs to leave out (acting_kernel.h).
struct ListsToThin {
  const std::int32_t *begin, *length;  // [row = vertex · blockLanes + lane]
  const VertexNumber* neighbours;
  static constexpr int readable = 32;  // numbers of rows behind the last neighbour
  const std::int32_t* rows;            // [count] rows to thin
  std::int32_t count;
  VertexNumber firstVertex;
  double reach;         // [1] pairs farther apart than this many R_ij, now and until the horizon, do not act
  double horizon;       // [time] T
  double ahead;         // [time] T + τ
  double room;          // [length] pairs with gaps above room + roomPerSpeed |u|, now and `ahead`, do not act
  double roomPerSpeed;  // [time] see room
};

struct ContactKernels {
  /// Writes the rows of a block's vertices from position, predicted and gradient. Returns the square of the largest
  /// distance [length²] from `reference`, [vertexCount][3][blockLanes].
  using TakeSnapshot = double (*)(const TemplateView&, const BlockView&, const double* inverseRadiusSquared,
                                  RealPointer reference, RowMemory* rows, ChangeCount&);
  TakeSnapshot takeSnapshot, takeSphereSnapshot, takeSurface, takeSurfaceAndCount;
  /// Adds contact forces on one block's vertices to `force` [all blocks]: vertex g is at (g / 8)·24 + g % 8.
  using AddForces = void (*)(const BlockSlices&, const std::int32_t* indices, const RowMemory* rows,
                             const ContactConstants&, RealPointer force);
  AddForces addPairForces, addPairForcesWithViscosity, addThesisForces;
  AddForces addSphereForces, addSphereForcesWithViscosity;
  // Kernels with adhesion, without and with viscosity.
  AddForces addStickyPairForces, addStickyPairForcesWithViscosity;
  AddForces addStickySphereForces, addStickySphereForcesWithViscosity;

  /// Sets saturation[vertex] of the block's vertices that have neighbours (adhesion.h). `areas`: a of the block's cells,
  /// [lane] [length²]. `ContactConstants::saturation` is not used.
  void (*findCrowding)(const BlockSlices&, const std::int32_t* indices, const RowMemory* rows, const ContactConstants&,
                       const double* areas, double* saturation);

  /// Sets largest[lane] to the largest S of this cell's pairs (pair law). `vertices`: the far row's number.
  void (*findSteepest)(const BlockSlices&, const std::int32_t* indices, const RowMemory* rows, std::int32_t vertices,
                       double* largest);

  /// Writes the lists of neighbours that may act for the asked rows, one after the other; `begin`, `length`: [row].
  void (*findActing)(const ListsToThin&, const RowMemory* rows, std::int32_t* begin, std::int32_t* length,
                     VertexNumber* acting);
};

const ContactKernels& contactKernels(Isa isa, Precision precision = Precision::binary64);

}  // namespace morula
