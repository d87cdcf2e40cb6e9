#include "organism/shell_wall.h"

#include <algorithm>

namespace morula {

ShellWall::ShellWall(const OrganismPicture& picture, const EyeAxes& axes, const Framing& framing)
    : picture_(picture), axes_(axes), middle_(axes.of(-framing.centre)) {
  if (picture.shell) within_ = std::min({picture.shell->x, picture.shell->y, picture.shell->z});
  else if (!picture.shellPlanes.empty())
    within_ = std::ranges::min(picture.shellPlanes, {}, &ShellPlane::offset).offset;
}

double ShellWall::reach(const Point& p) const {
  if (const auto& a = picture_.shell) return norm(Vector{p.x / a->x, p.y / a->y, p.z / a->z});
  return measureReach(picture_.shellPlanes, p);
}

bool ShellWall::holds(const CellShape& cell) const {
  return within_ > 0 && !cell.isWall && !cell.vertices.empty() && reach(middleOf(cell)) <= 1 &&
         std::ranges::all_of(cell.vertices, [&](const Point& vertex) { return reach(vertex) <= freeReach; });
}

Vector ShellWall::inside(const Vector& point) const {
  const Vector p = point - middle_;
  if (dot(p, p) <= within_ * within_) return point;
  const double here = reach(axes_.x * p.x + axes_.y * p.y + axes_.z * p.z);
  return here <= heldReach ? point : middle_ + p * (heldReach / here);
}

}  // namespace morula
