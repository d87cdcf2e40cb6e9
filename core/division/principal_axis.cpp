#include "division/principal_axis.h"

#include <Eigen/Eigenvalues>

#include "mesh/mesh_measures.h"

namespace morula {
namespace {

/// Uses the iterative solver: tridiagonalisation and QR use + − × ÷ and square roots only. (computeDirect uses acos.)
Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solveCovariance(std::span<const Point> points, int options) {
  const Point c = measureCentroid(points);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Point& p : points) {
    const Eigen::Vector3d d(p.x - c.x, p.y - c.y, p.z - c.z);
    covariance += d * d.transpose();
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance, options);
}

}  // namespace

double extentRatio(std::span<const Point> points) {
  const Eigen::Vector3d values = solveCovariance(points, Eigen::EigenvaluesOnly).eigenvalues();  // rising
  return values[1] > 0 ? std::sqrt(values[2] / values[1]) : INFINITY;
}

Vector towardsOwnSide(const Vector& line) { return dot(line, ownSide) < 0 ? -line : line; }

Vector principalAxis(std::span<const Point> points) {
  const auto solver = solveCovariance(points, Eigen::ComputeEigenvectors);
  const Eigen::Vector3d& values = solver.eigenvalues();  // rising
  const Eigen::Matrix3d& vectors = solver.eigenvectors();

  Eigen::Vector3d axis = vectors.col(2);
  int equal = 1;
  while (equal < 3 && values[2] - values[2 - equal] <= 1e-6 * values[2]) ++equal;
  if (equal > 1) {
    const auto space = vectors.rightCols(equal);
    axis = space * space.transpose() * Eigen::Vector3d::UnitX();
    if (axis.squaredNorm() < 0.25) axis = space * space.transpose() * Eigen::Vector3d::UnitY();
    axis /= std::sqrt(axis.squaredNorm());
  } else if (axis[0] + 0.55 * axis[1] + 0.2 * axis[2] < 0) {
    axis = -axis;
  }
  return {axis[0], axis[1], axis[2]};
}

Vector principalExtents(std::span<const Point> points) {
  const Eigen::Vector3d values = solveCovariance(points, Eigen::EigenvaluesOnly).eigenvalues();  // rising
  const auto extent = [&](double value) {  // rounding may leave a flat cloud's smallest below 0
    return value > 0 ? std::sqrt(value / static_cast<double>(points.size())) : 0;
  };
  return {extent(values[2]), extent(values[1]), extent(values[0])};
}

}  // namespace morula
