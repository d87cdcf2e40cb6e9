#include "division/superposition.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "mesh/mesh_measures.h"

namespace morula {
namespace {

/// Returns the rotation R that maximises Σ b·Ra, where m = Σ a bᵀ: the unit quaternion that is the eigenvector of the
/// largest eigenvalue of Horn's matrix. Uses the iterative solver, as principal_axis.cpp does.
Eigen::Matrix3d bestRotation(const Eigen::Matrix3d& m) {
  const double xx = m(0, 0), xy = m(0, 1), xz = m(0, 2);
  const double yx = m(1, 0), yy = m(1, 1), yz = m(1, 2);
  const double zx = m(2, 0), zy = m(2, 1), zz = m(2, 2);
  Eigen::Matrix4d n;
  n << xx + yy + zz, yz - zy, zx - xz, xy - yx,  //
      yz - zy, xx - yy - zz, xy + yx, zx + xz,   //
      zx - xz, xy + yx, -xx + yy - zz, yz + zy,  //
      xy - yx, zx + xz, yz + zy, -xx - yy + zz;
  const Eigen::Vector4d q = Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(n).eigenvectors().col(3);  // rising
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
}

Eigen::Vector3d vector(const Point& p, const Point& centre) { return {p.x - centre.x, p.y - centre.y, p.z - centre.z}; }

}  // namespace

std::optional<Superposition> superpose(std::span<const Point> points, std::span<const Point> others) {
  if (points.size() < 3) return {};
  const Point centre = measureCentroid(points), otherCentre = measureCentroid(others);
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  double size = 0, otherSize = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d a = vector(points[i], centre), b = vector(others[i], otherCentre);
    m += a * b.transpose();
    size += a.squaredNorm(), otherSize += b.squaredNorm();
  }
  if (!(size > 0 && otherSize > 0)) return {};
  const Eigen::Matrix3d rotation = bestRotation(m);
  double along = 0;  // Σ b·Ra; the best scale is this over Σ a²
  for (std::size_t i = 0; i < points.size(); ++i)
    along += vector(others[i], otherCentre).dot(rotation * vector(points[i], centre));
  const double scale = along / size;
  double left = 0, leftOfScaled = 0;
  std::vector<double> distances;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d a = rotation * vector(points[i], centre), b = vector(others[i], otherCentre);
    left += (b - a).squaredNorm(), leftOfScaled += (b - scale * a).squaredNorm();
    distances.push_back((b - a).norm());
  }
  const double count = static_cast<double>(points.size());
  return Superposition{std::sqrt(left / count), std::sqrt(leftOfScaled / otherSize), scale, std::move(distances)};
}

}  // namespace morula
