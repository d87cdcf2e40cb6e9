#pragma once
// The lineage tree: every cell that ever was, by path. Cells that divide or die leave the physics and stay in the
// lineage [Nilsson 2008, §4.4.2].
#include <cstdint>
#include <span>
#include <vector>

#include "base/cell_path.h"
#include "biology/state.h"

namespace morula {

enum class Fate : std::uint8_t { alive, divided, died };

/// One cell's life. Times in the scene's units.
struct LineageEntry {
  CellPath path;
  double born = 0;
  double ended = 0;            // meaningful unless alive
  std::uint64_t bornStep = 0;  // the physical step (or cycle, without physics) at which it was born
  std::uint64_t endedStep = 0;
  Fate fate = Fate::alive;
  StateId state = 0;  // the last substances of the cell
};

/// Entries in order of birth: a mother before her daughters, A before B, cells born at one time by their paths.
struct Lineage {
  std::vector<LineageEntry> entries;
};

const char* name(Fate fate);

/// Returns the indices of the entries, sorted by path: the egg first, every subtree in one piece. O(n log n), so
/// compute the order once and pass it on.
std::vector<std::uint32_t> orderByPath(const Lineage& lineage);
/// Returns the entry of a cell, or null. `order` comes from orderByPath. A cell's daughters are find(…,
/// path.daughter(false)) and (true).
const LineageEntry* find(const Lineage& lineage, std::span<const std::uint32_t> order, const CellPath& path);
/// Returns the indices of the cells that did not divide (alive or died), sorted by path.
std::vector<std::uint32_t> leaves(const Lineage& lineage);

}  // namespace morula
