#pragma once
// The organism's shape at many times, small enough to be put into a page: positions as 16-bit numbers over each cell's box.
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "mesh/mesh.h"
#include "simulation/measures.h"
#include "simulation/world.h"

namespace morula {

/// The living cells at one time. `bytes`, little-endian, in this order:
///   each cell:       uint32 number in the lineage, uint32 mesh, uint32 state; float32 low[3], step[3] [length];
///                    float32 for each of Frames::measures (NaN: not measured)
///   each contact:    uint32 a, b: cells of this frame; float32 area [length²]
///   each connection: uint32 a, b: cells of this frame
///   each cell:       uint16 x, y, z of each vertex: low + step · number
/// and as many zeros as make the length a multiple of 4. A position is off by half a step at most: the longest side of the
/// cell's box over 131070.
struct Frame {
  double time = 0;  // [time]
  std::uint64_t step = 0;
  std::uint32_t cells = 0, contacts = 0, connections = 0;
  std::string bytes;
};

struct Frames {
  std::vector<Frame> frames;              // by time
  std::vector<std::vector<Face>> meshes;  // that cells have, by their numbers
  std::vector<std::string> measures;      // of cells, sampled
  std::vector<StateId> states;            // by their numbers in frames
  std::vector<WorldMeasures> worlds;      // at the times of all frames that were taken
};

/// Watches a run and takes `most` frames, evenly from time 0 to `end` [time].
class FrameTaker {
 public:
  FrameTaker(double end, std::size_t most);
  /// The world at the start and after every step.
  void observe(const World& world);
  /// One more frame, whatever the time.
  void take(const World& world);
  Frames& frames() { return frames_; }

 private:
  std::uint32_t meshNumber(const std::vector<Face>& faces);
  std::uint32_t stateNumber(StateId state);

  double end_;
  std::size_t most_, next_ = 0;
  Frames frames_;
  std::map<StateId, std::uint32_t> stateNumbers_;
};

/// Keeps as many frames as take at most so many bytes, evenly over time; of two or more the first and the last are among them. None
/// stays if the last one alone takes more.
void thinFrames(Frames& frames, std::size_t mostBytes);

std::size_t bytesOf(const Frames& frames);

}  // namespace morula
