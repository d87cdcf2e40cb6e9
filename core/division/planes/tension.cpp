// Spindles turn along the strongest pull on the cell [Fink et al. 2011]. Connections pull at the cell's centre, each
// towards the other cell's. Two pulls to opposite sides stretch a cell though they add up to none, so the axis is not
// their sum but the first eigenvector of Σ u uᵀ over the unit vectors u along which they pull, all with one weight.
#include "division/planes/directions.h"
#include "division/principal_axis.h"

namespace morula {
namespace {

struct AlongTension final : DivisionPolicy {
  Cut findCut(const CellContext& cell) const override {
    const Point centre = cell.physical()->getShape().centre;
    std::vector<Point> pulls;  // each with its opposite, so that their mean is 0 and their covariance 2 Σ u uᵀ
    for (const CellContext* other : cell.connected()) {
      const Vector way = other->physical()->getShape().centre - centre;
      if (!(norm(way) > 0)) continue;  // concentric: no direction
      pulls.push_back(way / norm(way));
      pulls.push_back(-pulls.back());
    }
    return throughCentre(cell, pulls.empty() ? longestExtent(cell) : principalAxis(pulls));
  }
};

}  // namespace

const DivisionPlaneKind tensionPlane{
    .plane = DivisionPlane::tension,
    .name = "tension",
    .meaning = "the direction in which their connections pull most (without any as longest)",
    .needsConnections = true,
    .make = makeFromChoice<AlongTension>,
};

}  // namespace morula
