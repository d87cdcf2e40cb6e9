#include "contacts/acting_pairs.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>

#include "base/parallel.h"
#include "contacts/contacts.h"
#include "contacts/slices.h"

namespace morula {
namespace {

// [1] The margin over the smallest influence radius R. If gaps change by ċ in each evaluation, a vertex's choice with
// the margin M lasts M/ċ evaluations. The cost of pairs kept for the margin grows with M. Both costs together are least
// at M = 1.4 √(R ċ), measured. Cells that settle go farther in each evaluation, and a choice of theirs costs more.
struct Margins {
  double scale, most;
};
constexpr Margins inTime{1.4, 0.07}, settling{2, 0.3};
constexpr double minMargin = 0.01;
// [evaluation] A choice that lasts less than shortestLife costs more than it saves: after two such choices all pairs
// are taken.
constexpr std::int64_t farthestAhead = 100, withoutChoice = 30, shortestLife = 3;
// Share of all vertices: if more vertices need a new choice at once, all get one.
constexpr double maxRenewed = 0.1;
// After this many new lists per row of a block, all pairs are chosen and cut anew, so that slices stay full.
constexpr std::int64_t maxReplaced = 2;

double delayOf(const Contacts& c) { return c.damping / c.parameters.stiffness; }

/// Finds the acting pairs of one block's `chosen` rows. `radius`: the smallest influence radius [length].
void findActing(const Contacts& c, const Bodies& bodies, int block, double radius, BlockLists& lists) {
  const std::size_t needed = std::size_t(lists.used) + ListsToThin::readable;
  if (lists.neighbours.size() < needed) lists.neighbours.resize(needed + needed / 4);
  std::fill_n(lists.neighbours.begin() + lists.used, ListsToThin::readable, VertexNumber(c.rows.size() - 1));
  lists.acting.neighbours.resize(lists.neighbours.size());
  const double delay = delayOf(c), ahead = c.acting.horizon + delay;
  const ListsToThin thin{.begin = lists.begin.data(),
                         .length = lists.length.data(),
                         .neighbours = lists.neighbours.data(),
                         .rows = lists.chosen.data(),
                         .count = static_cast<std::int32_t>(lists.chosen.size()),
                         .firstVertex = bodies.blocks[block].firstLine * blockLanes,
                         .reach = (1 + relativeRoom) * (1 + c.acting.margin / radius),
                         .horizon = c.acting.horizon,
                         .ahead = ahead,
                         .room = c.acting.margin + relativeRoom * c.acting.largestRadius,
                         .roomPerSpeed = relativeRoom * ahead + delay * c.acting.margin / c.acting.largestRadius};
  c.kernels->findActing(thin, c.rows.data(), lists.acting.begin.data(), lists.acting.length.data(),
                        lists.acting.neighbours.data());
}

/// Chooses pairs for all of one block's rows that have neighbours, cell by cell.
void chooseBlock(Contacts& c, const Bodies& bodies, int block, double radius) {
  BlockLists& lists = c.list.perBlock[block];
  const auto rows = static_cast<std::int32_t>(lists.length.size());
  lists.chosen.clear();
  for (int lane = 0; lane < bodies.liveLanes(block); ++lane)
    for (std::int32_t row = lane; row < rows; row += blockLanes)
      if (lists.length[row] > 0) lists.chosen.push_back(row);
  lists.acting.begin.assign(rows, 0);
  lists.acting.length.assign(rows, 0);
  lists.chosenAgain = 0;
  findActing(c, bodies, block, radius, lists);
  cutIntoSlices(lists, lists.acting, bodies.blocks[block].firstLine * blockLanes, bodies.lineCount() * blockLanes);
}

/// Chooses pairs for one block's marked rows, and clears the marks.
void renewBlock(Contacts& c, const Bodies& bodies, int block, double radius) {
  BlockLists& lists = c.list.perBlock[block];
  const VertexNumber first = bodies.blocks[block].firstLine * blockLanes;
  std::uint8_t* marked = &c.acting.marked[first];
  const auto rows = static_cast<std::int32_t>(lists.length.size());
  lists.chosen.clear();
  for (std::int32_t line = 0; line < rows; line += blockLanes) {
    std::uint64_t any;
    std::memcpy(&any, marked + line, sizeof any);  // marks of all eight lanes
    if (any == 0) continue;
    for (std::int32_t row = line; row < line + blockLanes; ++row)
      if (marked[row]) lists.chosen.push_back(row), marked[row] = 0;
  }
  if (lists.chosen.empty()) return;
  lists.chosenAgain += static_cast<std::int64_t>(lists.chosen.size());
  if (lists.chosenAgain > maxReplaced * rows) return chooseBlock(c, bodies, block, radius);
  findActing(c, bodies, block, radius, lists);
  replaceInSlices(lists, lists.acting, lists.chosen, first, bodies.lineCount() * blockLanes);
}

/// Marks the vertices of this block whose choice has ended, and those of other cells that may act on them now. Other
/// lists may still name them, which adds nothing.
void markEnded(Contacts& c, const Bodies& bodies, int block, double radius) {
  ActingPairs& acting = c.acting;
  ActingPairs::OfBlock& own = acting.blocks[block];
  BlockLists& lists = c.list.perBlock[block];
  const VertexNumber first = bodies.blocks[block].firstLine * blockLanes;
  lists.chosen.clear();
  if (own.endedCount == 0) return;
  own.endings += own.endedCount;
  for (std::int32_t i = 0; i < own.endedCount; ++i) {
    const std::int32_t row = own.ended[i];
    acting.change[first + row] = 0;
    acting.speeds[first + row] = 0;
    if (lists.length[row] > 0) lists.chosen.push_back(row);
  }
  findActing(c, bodies, block, radius, lists);
  const auto mark = [&](VertexNumber g) {
    std::atomic_ref(acting.marked[g]).store(1, std::memory_order_relaxed);  // several threads may write the mark
  };
  for (std::int32_t row : lists.chosen) {
    mark(first + row);
    const VertexNumber* list = lists.acting.neighbours.data() + lists.acting.begin[row];
    for (std::int32_t k = 0; k < lists.acting.length[row]; ++k) mark(list[k]);
  }
}

/// Returns the smallest influence radius [length].
double smallestRadius(const Contacts& c, const Bodies& bodies) {
  double radius = INFINITY;
  for (int slot : bodies.slots) radius = std::min(radius, c.radius[slot]);
  return radius;
}

/// Counts the lists that findActing has just gone through in every block.
void countThinned(Contacts& c) {
  for (const BlockLists& lists : c.list.perBlock) c.listsThinned += lists.chosen.size();
}

bool isOver(const ActingPairs& acting) { return !(acting.blocks[0].time <= acting.horizon); }

/// Returns how many vertices' margins the last snapshot found used up.
std::int64_t countEnded(const ActingPairs& acting) {
  std::int64_t ended = 0;
  for (const ActingPairs::OfBlock& block : acting.blocks) ended += block.endedCount;
  return ended;
}

/// Sums up by how much gaps of a block's vertices have changed.
void sumChanges(ActingPairs& acting, const Bodies& bodies, int block) {
  ActingPairs::OfBlock& own = acting.blocks[block];
  own.changed = own.endings > 0 ? static_cast<double>(own.endings) * acting.margin : 0;
  const std::size_t first = std::size_t(bodies.blocks[block].firstLine) * blockLanes;
  for (int v = 0; v < bodies.verticesPerLane(block); ++v)
    for (int lane = 0; lane < bodies.liveLanes(block); ++lane)
      own.changed += acting.change[first + std::size_t(v) * blockLanes + lane];
}

}  // namespace

bool choosesPairs(const Contacts& c) { return !c.scratch.empty() && !c.parameters.adhesion; }

ChangeCount countChanges(Contacts& c, const Bodies& bodies, int block, double sinceLast) {
  ActingPairs& acting = c.acting;
  ActingPairs::OfBlock& own = acting.blocks[block];
  own.time += sinceLast;
  const double twice = 2 * std::sqrt(normalScaleSquared);
  const std::size_t first = std::size_t(bodies.blocks[block].firstLine) * blockLanes;
  return {.change = &acting.change[first],
          .speeds = &acting.speeds[first],
          .margin = acting.margin,
          .sinceLast = sinceLast,
          .perStraying = twice,
          .perTurning = acting.largestRadius,
          .perSpeed = twice * delayOf(c),
          .perDrift = twice * sinceLast,
          .ended = own.ended.data(),
          .endedCount = 0};
}

void choosePairs(Contacts& c, const Bodies& bodies, int threads) {
  ActingPairs& acting = c.acting;
  const double radius = smallestRadius(c, bodies), evaluations = static_cast<double>(acting.age);
  acting.largestRadius = 0;
  for (int slot : bodies.slots) acting.largestRadius = std::max(acting.largestRadius, c.radius[slot]);
  const bool tooShort = acting.horizon > 0 && acting.age < shortestLife && (isOver(acting) || countEnded(acting) > 0);
  acting.endedSoon = tooShort ? acting.endedSoon + 1 : 0;
  // The first choice is meant to be short: how fast gaps change is not known yet.
  double perEvaluation = 0, timeStep = 0;
  if (acting.age > 0) {
    parallelFor(bodies.blockCount(), threads, [&](int block) { sumChanges(acting, bodies, block); });
    for (const ActingPairs::OfBlock& block : acting.blocks) perEvaluation += block.changed;
    perEvaluation /= evaluations * static_cast<double>(bodies.livingVertices);
    timeStep = acting.blocks[0].time / evaluations;
  }
  const double lasts = perEvaluation > 0 ? std::sqrt(radius / perEvaluation) : double(farthestAhead);
  const Margins margins = bodies.parameters.integrator == Integrator::quasiStatic ? settling : inTime;
  acting.margin = std::clamp(margins.scale * lasts * perEvaluation, minMargin * radius, margins.most * radius);
  acting.horizon = std::min(lasts, double(farthestAhead)) * timeStep;
  std::ranges::fill(acting.change, 0.0f);
  std::ranges::fill(acting.speeds, 0.0f);
  for (ActingPairs::OfBlock& block : acting.blocks) block.time = 0, block.endings = 0;
  acting.age = 0;
  if (acting.endedSoon > 1) {
    acting.margin = INFINITY;
    acting.horizon = double(withoutChoice) * timeStep;
    return cutIntoSlices(c.list, bodies, threads);
  }
  parallelFor(bodies.blockCount(), threads, [&](int block) { chooseBlock(c, bodies, block, radius); });
  countThinned(c);
}

void renewPairs(Contacts& c, const Bodies& bodies, int threads) {
  const auto ended = static_cast<double>(countEnded(c.acting));
  if (isOver(c.acting) || ended > maxRenewed * bodies.livingVertices) return choosePairs(c, bodies, threads);
  if (ended == 0) return;
  const double radius = smallestRadius(c, bodies);
  parallelFor(bodies.blockCount(), threads, [&](int block) { markEnded(c, bodies, block, radius); });
  countThinned(c);
  parallelFor(bodies.blockCount(), threads, [&](int block) { renewBlock(c, bodies, block, radius); });
  countThinned(c);
}

}  // namespace morula
