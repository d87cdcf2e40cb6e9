#include "contacts/acting_pairs.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "contacts/contacts.h"
#include "contacts/slices.h"

namespace morula {
namespace {

constexpr double roundingRoom = 1e-5;
// Of the smallest influence radius R. A choice costs about as much as half an evaluation of all pairs and lasts M/ċ of
// them if each changes gaps by ċ; a margin M keeps so many more pairs. Both together cost least at M² = 0.8 R ċ, measured;
// where M is beyond the largest one, as among newborn cells that fly apart, more than is gained.
constexpr double cheapestMargin = 0.8, leastMargin = 0.01, mostMargin = 0.2;
constexpr double farthestAhead = 100;  // [evaluation]

double delayOf(const Contacts& c) { return c.parameters.damping / c.parameters.stiffness; }

/// The lists of one block.
void findActing(const Contacts& c, const Bodies& bodies, int block, double reach, BlockLists& lists) {
  const std::size_t needed = std::size_t(lists.used) + ListsToThin::readable;
  if (lists.neighbours.size() < needed) lists.neighbours.resize(needed + needed / 4);
  std::fill_n(lists.neighbours.begin() + lists.used, ListsToThin::readable,
              static_cast<VertexNumber>(c.rows.size() - 1));
  lists.acting.begin.assign(lists.begin.size(), 0);
  lists.acting.length.assign(lists.length.size(), 0);
  lists.acting.neighbours.resize(lists.neighbours.size());
  const double delay = delayOf(c), ahead = c.acting.horizon + delay;
  const ListsToThin thin{.begin = lists.begin.data(),
                         .length = lists.length.data(),
                         .neighbours = lists.neighbours.data(),
                         .vertices = bodies.verticesPerLane(block),
                         .liveLanes = bodies.liveLanes(block),
                         .firstVertex = bodies.blocks[block].firstLine * blockLanes,
                         .reachSquared = reach * reach,
                         .horizon = c.acting.horizon,
                         .margin = c.acting.margin + roundingRoom * c.acting.largestRadius,
                         .perSpeed = delay * c.acting.margin / c.acting.largestRadius + roundingRoom * ahead,
                         .ahead = ahead};
  c.kernels->findActing(thin, c.rows.data(), lists.acting.begin.data(), lists.acting.length.data(),
                        lists.acting.neighbours.data());
}

}  // namespace

bool choosesPairs(const Contacts& c) { return !c.scratch.empty() && !c.parameters.adhesion; }

void countChange(Contacts& c, const SnapshotChange& s, int block, double sinceLast) {
  ActingPairs::Change& all = c.acting.change[block];
  const double twice = 2 * std::sqrt(normalScaleSquared), spedUp = std::sqrt(s.spedUp);
  all.gaps += twice * (std::sqrt(s.strayed) + delayOf(c) * spedUp) + c.acting.largestRadius * std::sqrt(s.turned);
  all.drift += twice * sinceLast * all.speeds;
  all.speeds += spedUp;
  all.time += sinceLast;
}

bool choiceHolds(const ActingPairs& acting) {
  // Not `>=`: where numbers are none, pairs are chosen anew.
  return std::ranges::all_of(acting.change, [&](const ActingPairs::Change& since) {
    return since.gaps + since.drift < acting.margin && since.time <= acting.horizon;
  });
}

void choosePairs(Contacts& c, const Bodies& bodies, int threads) {
  ActingPairs& acting = c.acting;
  const auto radiusOf = [&](int slot) { return c.radius[slot]; };
  const double radius = radiusOf(*std::ranges::min_element(bodies.slots, {}, radiusOf));
  acting.largestRadius = radiusOf(*std::ranges::max_element(bodies.slots, {}, radiusOf));
  // The first choice shall not last: how fast gaps change is not known yet.
  double perEvaluation = 0, time = 0;
  if (acting.age > 0) {
    const auto age = static_cast<double>(acting.age);
    perEvaluation = std::ranges::max_element(acting.change, {}, &ActingPairs::Change::gaps)->gaps / age;
    time = acting.change.front().time / age;
  }
  acting.margin = std::max(leastMargin * radius, std::sqrt(cheapestMargin * radius * perEvaluation));
  acting.horizon = std::min(acting.margin / perEvaluation, farthestAhead) * time;
  std::fill(acting.change.begin(), acting.change.end(), ActingPairs::Change());
  acting.age = 0;
  if (!(acting.margin < mostMargin * radius)) {
    acting.margin = acting.horizon = INFINITY;
    return cutIntoSlices(c.list, foundLists, bodies, threads);
  }
  const double reach = (1 + acting.margin / radius) * (1 + roundingRoom);
  parallelFor(bodies.blockCount(), threads,
              [&](int block) { findActing(c, bodies, block, reach, c.list.perBlock[block]); });
  cutIntoSlices(c.list, actingLists, bodies, threads);
}

}  // namespace morula
