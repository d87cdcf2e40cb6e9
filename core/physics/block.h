#pragma once
// Eight cells side by side: the unit of storage, of work and of the hot path.
//
//   position[vertex][x y z][lane]     one cache line per vertex and axis, lane = cell
//
// All cells of a block have one mesh template and share its connectivity, so a kernel walks edges and rings once for
// the whole block and needs no gather, no colouring and no scatter. The width of the storage is eight on every machine;
// a narrower instruction set takes a line in several groups, and groups without a living cell are left out.
#include <cstdint>

#include "base/reals.h"

namespace morula {

constexpr int blockLanes = 8;
constexpr int vertexStride = 3 * blockLanes;  // numbers from one vertex to the next

/// One step from a vertex around its ring: the offset of a neighbour in a [vertex][xyz][lane] array, and of the edge to
/// that neighbour in [edge][lane]. Offsets instead of numbers save the kernels' innermost loops the multiplications.
struct RingStep {
  std::int32_t vertexOffset, edgeOffset;
};

/// A mesh template as the kernels walk it. Rings run counter-clockwise seen from outside and have even
/// length: an odd one repeats its last neighbour by the edge number edgeCount, whose spring is always slack.
struct TemplateView {
  int vertexCount, edgeCount;
  const std::int32_t* edges;      // [edge][2], first < second
  const double* restLengths;      // [edge] [length] of the template, at scale 1
  const double* springWeights;    // [edge] [1] of k_s and k_d; null: all 1
  const std::int32_t* ringStart;  // [vertex + 1] into ring
  const RingStep* ring;
  const double* ringShare;  // [as ring] 1 over the number of the neighbour's own neighbours; 0 for a repeated one
  // Bending only, at scale 1
  const double* bendingWeights;  // [as ring] [1] w; 0 for a repeated neighbour
  const double* inverseAreas;    // [vertex] [1/length²] 1/a
  // Shape matching only, at scale 1
  const double* restShape;    // [vertex][3] [length] from the mean of the vertices
  const double* restInverse;  // (Σ q qᵀ)⁻¹: xx xy xz yy yz zz [1/length²]
  double restVolume;          // [length³]

  /// Number of a vertex' neighbours, which are the first ones of its ring.
  int neighbours(int vertex) const {
    const int last = ringStart[vertex + 1];
    return last - ringStart[vertex] - (ring[last - 1].edgeOffset == edgeCount * blockLanes);
  }
};

/// Pointers to a block's numbers. Shapes: [v] stands for [vertexCount][3][blockLanes], [l] for [blockLanes].
struct BlockView {
  int meshLevel;  // number of these cells' mesh (Bodies::meshAt)
  int liveLanes;  // living cells in this block, in the first lanes
  // State
  RealPointer position;      // [v]
  RealPointer velocity;      // [v]; between drift and kick the velocity at half the step
  RealPointer acceleration;  // [v]; between drift and kick the force
  // Parameters of each cell
  const double* vertexMass;        // [l]
  const double* restScale;         // [l] rest length over the template's
  const double* pressureConstant;  // [l] k_p
  const double* sag;               // [l] [length] Bodies::sag
  // Output of each cell
  double* volume;    // [l]
  double* pressure;  // [l]
  // Scratch of the running thread
  RealPointer predicted;    // [v] velocity estimate at the new time, for damping
  RealPointer gradient;     // [v] 6∇V: six times the outward area vector that belongs to the vertex
  RealPointer coefficient;  // [edgeCount + 1][blockLanes] spring force over edge vector
  RealPointer curvature;    // [v] curvature vectors; bending only, else null
  // Runge–Kutta only, else null: [4][v] position and velocity at the start of the step, sums of both slopes
  RealPointer substeps;
};

struct ShellPlane;  // mesh/convex_shell.h

/// The shell as kernels distinguish it. `surface`: a sphere or ellipsoid that holds surfaces, not vertices.
enum class ShellShape { none, sphere, ellipsoid, surface, aroundSpheres, planes, planesAroundSpheres };

/// The constants of a scene, as the kernels need them.
struct KernelParameters {
  double stiffness;                                  // springs: MembraneParameters
  double damping, dampingPerRoot;                    // k_d = damping + dampingPerRoot √m (damping.h)
  double bending;                                    // κ: MembraneParameters
  double outsidePressure;                            // [force/length²]
  double drag;                                       // [1/time]
  double semiAxes[3];                                // [length] shell
  int substeps;                                      // XPBD only: per time step
  double shapeStiffness, shapeLinear, shapeDamping;  // shape matching only: ShapeMatchingParameters
  double radius;                                     // [length] spheres only: at scale 1
  const ShellPlane* planes;                          // shell of a mesh only, else null
  int planeCount;
};

}  // namespace morula
