#pragma once
// The rotation nearest to a matrix: the R that maximises tr(Rᵀ M), which for det M > 0 is the rotation in the polar
// decomposition M = R S. For a unit quaternion q the trace is qᵀ N q, so q is the largest eigenvector of a symmetric 4
// × 4 matrix N [Horn 1987]. R is a proper rotation for mirrored and flat matrices, too.
//
// Jacobi's method diagonalises N by rotations in one plane after the other, in a fixed order: square roots, no
// branches. After the rounds taken here, only rounding is left off the diagonal.
#include "physics/lane_matrix.h"

namespace morula::MORULA_ISA {

constexpr int jacobiRounds = single ? 5 : 6;

/// A symmetric matrix (both halves are kept), and the eigenvectors found so far, one in each column.
struct Diagonalisation {
  Lanes n[4][4], vectors[4][4];
};

/// The Jacobi rotation in the plane of axes p and q that makes n[p][q] zero. [Golub, Van Loan, §8.5]
template <int p, int q>
MORULA_INLINE void rotateJacobi(Diagonalisation& d) {
  const Lanes off = d.n[p][q], apart = d.n[q][q] - d.n[p][p];
  const Lanes size = max(apart, -apart), twice = 2.0 * select(apart < Lanes(0.0), -off, off);
  const Lanes tangent = twice / (size + sqrt(apart * apart + 4.0 * off * off) + tiny);
  const Lanes cosine = 1.0 / sqrt(1.0 + tangent * tangent), sine = tangent * cosine;
  d.n[p][p] = d.n[p][p] - tangent * off;
  d.n[q][q] = d.n[q][q] + tangent * off;
  d.n[p][q] = d.n[q][p] = Lanes(0.0);
  for (int r = 0; r < 4; ++r) {
    if (r != p && r != q) {
      const Lanes a = d.n[r][p], b = d.n[r][q];
      d.n[r][p] = d.n[p][r] = cosine * a - sine * b;
      d.n[r][q] = d.n[q][r] = sine * a + cosine * b;
    }
    const Lanes a = d.vectors[r][p], b = d.vectors[r][q];
    d.vectors[r][p] = cosine * a - sine * b;
    d.vectors[r][q] = sine * a + cosine * b;
  }
}

/// Returns the rotation nearest to `m`, in any scale in which the squares of its numbers neither overflow nor vanish.
MORULA_INLINE Matrix nearestRotation(const Matrix& m) {
  const Lanes a = m.z.y - m.y.z, b = m.x.z - m.z.x, c = m.y.x - m.x.y;
  const Lanes d = m.x.y + m.y.x, e = m.x.z + m.z.x, f = m.y.z + m.z.y, none = 0.0, one = 1.0;
  Diagonalisation t{
      {{m.x.x + m.y.y + m.z.z, a, b, c},
       {a, m.x.x - m.y.y - m.z.z, d, e},
       {b, d, m.y.y - m.x.x - m.z.z, f},
       {c, e, f, m.z.z - m.x.x - m.y.y}},
      {{one, none, none, none}, {none, one, none, none}, {none, none, one, none}, {none, none, none, one}}};
  for (int round = 0; round < jacobiRounds; ++round) {
    rotateJacobi<0, 1>(t);
    rotateJacobi<2, 3>(t);
    rotateJacobi<0, 2>(t);
    rotateJacobi<1, 3>(t);
    rotateJacobi<0, 3>(t);
    rotateJacobi<1, 2>(t);
  }
  Lanes largest = t.n[0][0], w = t.vectors[0][0], x = t.vectors[1][0], y = t.vectors[2][0], z = t.vectors[3][0];
  for (int k = 1; k < 4; ++k) {
    const Mask better = t.n[k][k] > largest;
    largest = select(better, t.n[k][k], largest);
    w = select(better, t.vectors[0][k], w), x = select(better, t.vectors[1][k], x);
    y = select(better, t.vectors[2][k], y), z = select(better, t.vectors[3][k], z);
  }
  return {{1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)},
          {2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)},
          {2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)}};
}

}  // namespace morula::MORULA_ISA
