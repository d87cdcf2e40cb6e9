#pragma once
// How many cells will live when, as the genes alone foretell it: without bodies thousands of cells take a
// moment. While cells know nothing of their bodies, it holds for a run with physics too.
#include <cstdint>
#include <vector>

#include "simulation/scene.h"

namespace morula {

/// A time during which nobody is born and nobody dies.
struct Era {
  double from = 0, to = 0;  // [time]
  std::uint64_t cells = 1;  // alive
  int generation = 0;       // divisions before the youngest of them: they are the lightest
};

struct Life {
  std::vector<Era> eras;         // without gaps; the last may have no length
  std::uint64_t cellsAsked = 0;  // over all cell cycles: what they cost goes with it
  std::uint64_t moments = 0;     // at which cell cycles ran
  std::uint64_t divisions = 0;
  std::uint64_t states = 0;  // different sets of substances
  bool whole = true;   // false: there are more cells than was worth following, and this is the beginning
  double seconds = 0;  // [s] of CPU time that the cell cycles took

  std::uint64_t mostCells() const;
};

/// Follows the genes to the scene's stop, or until cells have been asked `most` times.
Life foretellLife(const Scene& scene, std::uint64_t most = 1'000'000);

}  // namespace morula
