#include "contacts/acting_pairs.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "contacts/contacts.h"
#include "contacts/slices.h"

namespace morula {
namespace {

// Of the smallest influence radius R. A choice costs about as much as half an evaluation of all pairs and lasts N of them if
// a cell's margin is N ċ, when gaps change by ċ in each; margins keep more pairs, by their mean. Both together cost least
// at N² = R/ċ with the mean ċ, measured; half of the mean is for cells that become faster. Where margins are beyond the
// largest one in the mean, as among newborn cells that fly apart, they cost more than is gained.
constexpr double spare = 0.5, leastMargin = 0.01, mostMargin = 0.2;
// [evaluation] A choice that lasts less than the shortest costs more than it saves: after two of them all pairs are taken.
constexpr std::int64_t farthestAhead = 100, withoutChoice = 30, shortestLife = 3;

double delayOf(const Contacts& c) { return c.parameters.damping / c.parameters.stiffness; }

/// The lists of one block. `radius`: the smallest influence radius [length].
void findActing(const Contacts& c, const Bodies& bodies, int block, double radius, BlockLists& lists) {
  const std::size_t needed = std::size_t(lists.used) + ListsToThin::readable;
  if (lists.neighbours.size() < needed) lists.neighbours.resize(needed + needed / 4);
  std::fill_n(lists.neighbours.begin() + lists.used, ListsToThin::readable, VertexNumber(c.rows.size() - 1));
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
                         .halfMargins = c.acting.halfMargins.data(),
                         .perRadius = 1 / radius,
                         .horizon = c.acting.horizon,
                         .delayPerRadius = delay / c.acting.largestRadius,
                         .ahead = ahead,
                         .room = relativeRoom * c.acting.largestRadius,
                         .roomPerSpeed = relativeRoom * ahead};
  c.kernels->findActing(thin, c.rows.data(), lists.acting.begin.data(), lists.acting.length.data(),
                        lists.acting.neighbours.data());
}

}  // namespace

bool choosesPairs(const Contacts& c) { return !c.scratch.empty() && !c.parameters.adhesion; }

void countChange(Contacts& c, const SnapshotChange& s, int block, double sinceLast) {
  const double twice = 2 * std::sqrt(normalScaleSquared);
  for (int lane = 0; lane < blockLanes; ++lane) {
    ActingPairs::Change& all = c.acting.change[std::size_t(block) * blockLanes + lane];
    const double strayed = std::sqrt(s.strayed[lane]), turned = std::sqrt(s.turned[lane]),
                 spedUp = std::sqrt(s.spedUp[lane]);
    all.gaps += twice * (strayed + delayOf(c) * spedUp) + c.acting.largestRadius * turned;
    all.drift += twice * sinceLast * all.speeds;
    all.speeds += spedUp;
    all.time += sinceLast;
  }
}

bool choiceHolds(const ActingPairs& acting, std::span<const int> slots) {
  // Not `>=`: where numbers are none, pairs are chosen anew.
  return std::ranges::all_of(slots, [&](int slot) {
    const ActingPairs::Change& since = acting.change[slot];
    return since.gaps + since.drift < acting.margin[slot] && since.time <= acting.horizon;
  });
}

void choosePairs(Contacts& c, const Bodies& bodies, int threads) {
  ActingPairs& acting = c.acting;
  const auto radiusOf = [&](int slot) { return c.radius[slot]; };
  const double radius = radiusOf(*std::ranges::min_element(bodies.slots, {}, radiusOf));
  acting.largestRadius = radiusOf(*std::ranges::max_element(bodies.slots, {}, radiusOf));
  const bool tooShort = acting.horizon > 0 && acting.age < shortestLife && !choiceHolds(acting, bodies.slots);
  acting.endedSoon = tooShort ? acting.endedSoon + 1 : 0;
  // The first choice shall not last: how fast gaps change is not known yet.
  const auto age = static_cast<double>(std::max<std::int64_t>(acting.age, 1));
  const auto perEvaluation = [&](int slot) { return acting.age > 0 ? acting.change[slot].gaps / age : 0; };
  double mean = 0;
  for (int slot : bodies.slots) mean += perEvaluation(slot) / bodies.count;
  const double lasts = mean > 0 ? std::sqrt(radius / mean) : double(farthestAhead);
  for (int slot : bodies.slots)
    acting.margin[slot] = std::max(leastMargin * radius, lasts * (perEvaluation(slot) + spare * mean));
  const double timeStep = acting.age > 0 ? acting.change[bodies.slots[0]].time / age : 0;
  acting.horizon = std::min(lasts, double(farthestAhead)) * timeStep;
  std::fill(acting.change.begin(), acting.change.end(), ActingPairs::Change());
  acting.age = 0;
  if (acting.endedSoon > 1 || !((1 + spare) * mean * lasts < mostMargin * radius)) {
    std::fill(acting.margin.begin(), acting.margin.end(), INFINITY);
    acting.horizon = double(withoutChoice) * timeStep;
    return cutIntoSlices(c.list, foundLists, bodies, threads);
  }
  parallelFor(bodies.blockCount(), threads, [&](int block) {
    const int first = bodies.blocks[block].firstLine;
    for (int line = first; line < first + bodies.verticesPerLane(block); ++line)
      for (int lane = 0; lane < blockLanes; ++lane)
        acting.halfMargins[std::size_t(line) * blockLanes + lane] =
            static_cast<float>(0.5 * acting.margin[std::size_t(block) * blockLanes + lane]);
  });
  parallelFor(bodies.blockCount(), threads,
              [&](int block) { findActing(c, bodies, block, radius, c.list.perBlock[block]); });
  cutIntoSlices(c.list, actingLists, bodies, threads);
}

}  // namespace morula
