#pragma once
// The organism's shape at many times, small enough to be put into a page: positions as 16-bit numbers over each cell's
// box; and the forces on the cells of a frame, by kind.
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/vertex_forces.h"
#include "loop/observer.h"
#include "mesh/mesh.h"
#include "simulation/measures.h"
#include "simulation/world.h"

namespace morula {

/// Measures the forces in a running world on a twin that it brings to the same state, so that the run is not touched.
class ForceMeter {
 public:
  /// `twin`: made of the same scene. There are no kinds where it has no bodies, or where its integrator solves for
  /// forces and knows none between two steps.
  explicit ForceMeter(World twin);

  /// The kinds of forces that the scene can have; all others are zero on every cell.
  const std::vector<ForceKind>& kinds() const { return kinds_; }
  /// [cell] Forces in a state of the scene; empty where they cannot be evaluated, or there are no kinds.
  std::vector<ForcesByKind> at(const World& world);

 private:
  World twin_;
  std::vector<ForceKind> kinds_;
};

/// The sum over a cell's vertices. [force]
Vector netForce(const ForcesByKind& cell, ForceKind kind);

/// Returns the kinds whose net force on a cell may differ from zero: a closed cell's springs and contents have none.
std::vector<ForceKind> kindsWithNetForce(const std::vector<ForceKind>& kinds);

/// Writes float32 x, y, z of the net force [force] for each cell and each of these kinds; NaN if `forces` is empty.
void putNetForces(std::string& bytes, const std::vector<ForcesByKind>& forces, std::size_t cells,
                  const std::vector<ForceKind>& kinds);

/// Writes for each cell and each of the kinds: float32 step [force]; then, again for each, where its step is not 0,
/// int8 x, y, z for each vertex: the force is step · number, and off by half a step at most. A step is the largest
/// component over 127. If forces are rounding alone, less than 1e-9 of the greatest on the cell, the step is 0.
void putVertexForces(std::string& bytes, const std::vector<ForcesByKind>& forces, const std::vector<ForceKind>& kinds);

/// The living cells at one time. `bytes`, little-endian, in this order:
///   each cell:       uint32 number in the lineage, uint32 mesh, uint32 state; float32 low[3], step[3] [length];
///                    float32 for each of Frames::measures (NaN: not measured)
///   each contact:    uint32 a, b: cells of this frame; float32 area [length²]
///   each connection: uint32 a, b: cells of this frame
///   each cell:       its net forces [putNetForces]
///   each cell:       uint16 x, y, z of each vertex: low + step · number
///   and as many zeros as make the length a multiple of 4. A position is off by half a step at most: the longest side of the
///   cell's box over 131070.
/// In the last frame of cells with vertices there follow, from `vertexForces` on, the forces on these [putVertexForces].
struct Frame {
  double time = 0;  // [time]
  std::uint64_t step = 0;
  std::uint32_t cells = 0, contacts = 0, connections = 0;
  std::size_t vertexForces = 0;  // where in bytes; 0: there are none
  std::string bytes;
};

struct Frames {
  std::vector<Frame> frames;              // by time
  std::vector<std::vector<Face>> meshes;  // that cells have, by their numbers
  std::vector<std::string> measures;      // of cells, sampled
  std::vector<StateId> states;            // by their numbers in frames
  std::vector<ForceKind> forces;          // that cells can have; empty: forces are not known
  std::vector<WorldMeasures> worlds;      // at the times of all frames that were taken
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
  /// All of them, when there will be no more.
  Frames& frames();

 private:
  /// [time] When frame `k` is due.
  double dueTime(std::size_t k) const;
  std::uint32_t meshNumber(const std::vector<Face>& faces);
  std::uint32_t stateNumber(StateId state);

  double end_;
  std::size_t most_, next_ = 0;
  Frames frames_;
  std::map<StateId, std::uint32_t> stateNumbers_;
  std::optional<ForceMeter> meter_;
  std::vector<ForcesByKind> lastForces_;  // in the last frame; empty: not known, or not of vertices
};

/// Keeps as many frames as take at most so many bytes, evenly over time; of two or more the first and the last are
/// among them. None stays if the last one alone takes more.
void thinFrames(Frames& frames, std::size_t maxBytes);

std::size_t bytesOf(const Frames& frames);

}  // namespace morula
