// Measures how many cell cycles per second the compiled DNA runs without physics, over the 4094 genes of the thesis'
// tree of C. elegans. This is no test: it prints numbers and judges nothing.
#include <cstdio>
#include <vector>

#include "biology/dna.h"
#include "biology/full_tree.h"
#include "biology/logical_dna.h"
#include "system/clock.h"

using namespace morula;

namespace {

struct Cell {
  CellPath path;
  StateId state = 0;
};

/// Runs one cycle of all cells, which then divide or die. Returns the number of cycles run.
std::uint64_t runCellCycles(BiologicalUnit& unit, std::vector<Cell>& cells, std::vector<Cell>& next) {
  next.clear();
  for (const Cell& cell : cells) {
    CellContext view;
    view.path = cell.path;
    view.state = cell.state;
    view.state = unit.runCellCycle(view);
    if (unit.wantsToDie(view)) continue;
    if (unit.wantsToDivide(view))
      for (bool b : {false, true}) next.push_back({cell.path.daughter(b), unit.daughterState(view.state, b)});
    else next.push_back({cell.path, view.state});
  }
  const std::uint64_t cycles = cells.size();
  std::swap(cells, next);
  return cycles;
}

}  // namespace

int main() {
  const std::string text = makeFullTreeDna(10);
  double begin = seconds(ClockKind::wall);
  const Dna dna = parseDna(text, "full-tree.dna");
  std::printf("read %zu genes          %8.2f ms\n", dna.genes.size(), 1e3 * (seconds(ClockKind::wall) - begin));
  begin = seconds(ClockKind::wall);
  const auto unit = makeLogicalDna(dna, {});
  std::printf("compiled                 %8.2f ms\n", 1e3 * (seconds(ClockKind::wall) - begin));

  std::vector<Cell> cells, next;
  const auto report = [&](const char* what, int organisms, int cycles) {
    std::uint64_t run = 0;
    begin = seconds(ClockKind::wall);
    for (int organism = 0; organism < organisms; ++organism) {
      cells = {{CellPath{}, unit->startState()}};
      for (int cycle = 0; cycle < cycles; ++cycle) run += runCellCycles(*unit, cells, next);
    }
    const double took = seconds(ClockKind::wall) - begin;
    std::printf("%s %8.2f million cell cycles per second (%llu in %.3f s, %zu cells at the end)\n", what,
                run / took / 1e6, static_cast<unsigned long long>(run), took, cells.size());
  };
  report("egg to 1024, first time  ", 1, 12);
  report("egg to 1024, again       ", 2000, 12);
  report("1024 cells for a long time", 1, 20000);
}
