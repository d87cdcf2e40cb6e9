#include "division/policy.h"

#include "base/error.h"
#include "base/random.h"
#include "division/principal_axis.h"

namespace morula {

namespace {

struct FixedAxis final : DivisionPolicy {
  explicit FixedAxis(const Vector& a) : axis(a / norm(a)) {}
  Vector planeNormal(const CellPath&, const Body&) const override { return axis; }
  Vector axis;
};

/// Cells tend to divide across their longest extent [Hertwig 1884; Nilsson 2008, §1.1].
struct LongestExtent final : DivisionPolicy {
  Vector planeNormal(const CellPath&, const Body& body) const override {
    return principalAxis(body.position);
  }
};

/// One direction per cell, whatever the order in which cells divide.
struct RandomDirection final : DivisionPolicy {
  explicit RandomDirection(std::uint64_t s) : seed(s) {}
  Vector planeNormal(const CellPath& cell, const Body&) const override {
    return randomDirection({seed, cell, 0, Purpose::divisionPlane});
  }
  std::uint64_t seed;
};

}  // namespace

std::unique_ptr<DivisionPolicy> makeDivisionPolicy(const DivisionParameters& p, std::uint64_t seed) {
  switch (p.plane) {
    case DivisionPlane::axis:
      if (!(norm(p.axis) > 0))
        throw InputError("division.plane: the axis has no length; give a direction such as [1, 0, 0]");
      return std::make_unique<FixedAxis>(p.axis);
    case DivisionPlane::longest:
      return std::make_unique<LongestExtent>();
    case DivisionPlane::random:
      return std::make_unique<RandomDirection>(seed);
  }
  CHECK(false, "a plane policy without an implementation");
}

}  // namespace morula
