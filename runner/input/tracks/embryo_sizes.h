#pragma once
// How large the shell, the egg and the founders are, and where.
#include <array>
#include <vector>

#include "tracks/embryo.h"

namespace morula::tracks {

/// Finds shell, fill, length, centre and start of an embryo whose stages are known.
void findSizes(Embryo& embryo, const EmbryoOptions& options);

/// The semi-axes of an ellipsoid about `centre`, along x, y and z, that holds cells of which `n` fill it:
///
///   aᵢ = hᵢ + (a₁ a₂ a₃ / n)^⅓,   hᵢ the farthest centre along i
///
/// where the second part is the radius of a cell's ball. It is then made larger until it holds all centres. n > 1.
std::array<double, 3> fitShell(const std::vector<Point>& centres, const Point& centre, int n);

}  // namespace morula::tracks
