#pragma once
// The organism's shape at many times, small enough for a page: positions as whole steps over each cell's box, and the forces
// on cells by kind.
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/vertex_forces.h"
#include "loop/observer.h"
#include "mesh/mesh.h"
#include "observation/measures.h"
#include "report_data/frame_mesh.h"
#include "simulation/simulation.h"

namespace morula {

/// Measures the forces in a running world on a twin set to the same state, so that the run is not touched.
class ForceMeter {
 public:
  /// `twin`: a world made of the same scene. There are no kinds of forces if it has no bodies, or if its integrator
  /// solves for forces and knows none between two steps.
  explicit ForceMeter(World twin);

  /// Returns the kinds of forces that the scene can have; all others are zero on every cell.
  const std::vector<ForceKind>& kinds() const { return kinds_; }
  /// Returns the forces in a state of the scene, by cell; empty if they cannot be evaluated, or there are no kinds.
  std::vector<ForcesByKind> at(const World& world);

 private:
  World twin_;
  std::vector<ForceKind> kinds_;
};

/// Returns the sum of a force over a cell's vertices [force].
Vector netForce(const ForcesByKind& cell, ForceKind kind);

/// Returns the kinds whose net force on a cell may differ from zero: springs and contents of a closed cell have none.
std::vector<ForceKind> kindsWithNetForce(const std::vector<ForceKind>& kinds);

/// Writes the net force on each cell for each of the kinds: float32 x, y, z [force]; NaN if `forces` is empty.
void putNetForces(std::string& bytes, const std::vector<ForcesByKind>& forces, std::size_t cells,
                  const std::vector<ForceKind>& kinds);

/// Writes for each cell and kind a float32 step [force]. Then it writes, for each cell and kind whose step is not 0,
/// int8 x, y, z for each vertex: the force is step · number, with an error of at most half a step. A step is the
/// largest component over 127. For forces below 1e-9 of the greatest on the cell, which are rounding, it is 0.
void putVertexForces(std::string& bytes, const std::vector<ForcesByKind>& forces, const std::vector<ForceKind>& kinds);

/// The living cells at one time. `bytes`, little-endian, in this order:
///   each cell:       uint32 number in the lineage, uint32 mesh, uint32 state; float32 low[3], step [length];
///                    float32 for each of Frames::measures (NaN: not measured)
///   each contact:    uint32 a, b: cells of this frame; float32 area [length²]
///   each connection: uint32 a, b: cells of this frame
///   each cell:       its net forces [putNetForces]
///   each cell:       uint16 x, y, z of each vertex: low + step · number. None of a sphere, which has its middle in
///                    `low` and its radius in `step`
///   zeros until the length is a multiple of 4.
/// The error of a position is at most half a step, which is at most the longest side of the cell's box over 2048. A step
/// is a power of two, so that it seldom changes from one frame to the next. Measures, areas and net forces are rounded
/// to 16 binary digits, a relative error of 2^-16.
/// The last frame of cells with all their vertices ends, from `vertexForces` on, with the forces on them
/// [putVertexForces].
struct Frame {
  double time = 0;  // [time]
  std::uint64_t step = 0;
  std::uint32_t cells = 0, contacts = 0, connections = 0;
  std::size_t vertexForces = 0;  // place of the forces in `bytes`; 0: none
  std::string bytes;
};

struct Frames {
  std::vector<Frame> frames;              // by time
  std::vector<FrameMesh> meshes;          // by number of the mesh
  std::size_t coarser = 0;                // number of taken frames whose cells have coarser meshes than in the run
  std::vector<std::string> measures;      // sampled measures of cells
  std::vector<StateId> states;            // states, by their numbers in frames
  std::vector<ForceKind> forces;          // kinds of forces on cells; empty: forces are not known
  std::vector<WorldMeasures> worlds;      // measures at the times of all frames that were taken
};

/// The observer that takes `most` frames of a run, evenly from time 0 to `end` [time].
class FrameTaker : public Observer {
 public:
  /// Without `forces` the frames hold no forces.
  FrameTaker(double end, std::size_t most, std::optional<ForceMeter> forces = {});
  void see(const World& world) override;
  std::uint64_t stepsUntilDue(const World& world) const override;
  /// One more frame, whatever the time.
  void take(const World& world);
  /// Returns all frames; call it after the last step.
  Frames& frames();

 private:
  /// [time] When frame `k` is due.
  double dueTime(std::size_t k) const;
  std::uint32_t meshNumber(FrameMesh mesh);
  std::uint32_t stateNumber(StateId state);

  double end_;
  std::size_t most_, next_ = 0;
  Frames frames_;
  std::map<StateId, std::uint32_t> stateNumbers_;
  std::optional<ForceMeter> meter_;
  std::vector<ForcesByKind> lastForces_;  // forces in the last frame; empty: unknown, or not on its vertices
};

/// Leaves out the forces on vertices, which are larger than ten frames; cells keep their net forces.
void dropVertexForces(Frames& frames);

/// Packs the bytes of all frames with zlib, to about half; reports/explorer/src/packed.ts unpacks them. In this
/// order: the 4-byte numbers of all frames, each table column by column, first the lowest bytes of all numbers, then the
/// next ones; the places of all vertices, likewise, each as its difference from the vertex's place in the frame before
/// or, of a new cell, from the vertex before (-1, 1, -2, … as 1, 2, 3, …); the forces on vertices.
std::string packedFrames(const Frames& frames);

/// Packs bytes with zlib, as small as it can.
std::string deflated(const std::string& bytes);

/// Keeps as many frames as fit into `maxBytes` when packed, evenly spread in time; of two or more the first and the last
/// stay. None stays if the last frame alone is larger.
void thinFrames(Frames& frames, std::size_t maxBytes);

}  // namespace morula
