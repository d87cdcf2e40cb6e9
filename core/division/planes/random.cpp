// A uniformly distributed random direction: the thesis' reference for other planes [Nilsson 2008, §4.4.2].
#include "base/random.h"

#include "division/planes/directions.h"

namespace morula {
namespace {

/// Gives each cell one direction, whatever the order in which cells divide.
struct RandomDirection final : DivisionPolicy {
  explicit RandomDirection(std::uint64_t s) : seed(s) {}
  Cut findCut(const CellContext& cell) const override {
    return throughCentre(cell, randomDirection({seed, cell.path, 0, Purpose::divisionPlane}));
  }
  std::uint64_t seed;
};

}  // namespace

const DivisionPlaneKind randomPlane{
    .plane = DivisionPlane::random,
    .name = "random",
    .meaning = "a random direction",
    .usesSeed = true,
    .make = makeFromChoice<RandomDirection>,
};

}  // namespace morula
