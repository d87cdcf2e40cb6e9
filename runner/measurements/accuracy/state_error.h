#pragma once
// How far one world is from another that should be the same.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/cell_path.h"
#include "biology/lineage.h"
#include "division/record.h"
#include "mesh/mesh.h"
#include "simulation/measures.h"

namespace morula {

/// A cell as others see it, whatever its mesh.
struct ComparedCell {
  CellPath path;
  Mesh surface;
  Point centroid;       // [length] of what the surface encloses: a mean of vertices depends on where they lie
  double volume = 0;    // [length³]
  double pressure = 0;  // [force/length²] inner minus outer; Bullet's cells: not known, 0
};

/// All living cells at one time, by path.
struct Shapes {
  double time = 0;
  std::vector<ComparedCell> cells;
  std::vector<ContactMeasures> contacts = {};  // by (a, b)
};

/// Centroid and volume from the surface.
ComparedCell comparedCell(const CellPath& path, Mesh surface);

/// The world has bodies.
Shapes takeShapes(const World& world);

/// Each but the neighbours the largest over the cells or pairs of cells.
struct StateError {
  double centroid = 0;     // [radii of the egg] distance of the centroids
  double volume = 0;       // [1] difference of volumes over the reference's
  double surface = 0;      // [radii of the egg] root mean square distance of the surfaces
  double pressure = 0;     // [1] over the reference's largest
  double contactArea = 0;  // [1] the same; a pair that touches in one alone differs by all of its area
  double neighbours = 0;   // [1] share of the pairs that touch in either, over all times, that do so in one alone
  /// Returns the largest error of centroids, volumes and surfaces, by which rows are compared.
  double largest() const;
};

/// The quantities whose errors are stated, everywhere: at a terminal, on pages, in JSON, in goldens.
struct ErrorQuantity {
  const char *name, *unit;
  double StateError::*of;
  bool ofPairs = false;  // there is none where no two cells touch
};

/// "contact area"
std::string nameOf(const ErrorQuantity& quantity);

inline constexpr ErrorQuantity errorQuantities[] = {
    {"position", "radii of the egg", &StateError::centroid},
    {"surface", "radii of the egg", &StateError::surface},
    {"volume", "of the cell's", &StateError::volume},
    {"pressure", "of the largest", &StateError::pressure},
    {"contact_area", "of the largest", &StateError::contactArea, true},
    {"neighbours", "of all pairs that touch", &StateError::neighbours, true},
};

/// True if the same cells live in both.
bool haveSameCells(const Shapes& a, const Shapes& b);

/// Centroids, volumes and surfaces of two with the same cells.
StateError compareShapes(const Shapes& shapes, const Shapes& reference, double eggRadius);

/// Two runs whose cells divide at the same times, but across other planes: a round cell has no longest extent, and a
/// small difference chooses one. What comes later then differs by a large share of a radius, whatever the time step.
struct DividedElsewhere {
  CellPath mother;
  double time = 0;                    // [time] of the division in the reference
  double angle = 0;                   // [degrees] between the two axes to daughter A, up to 180
  std::optional<double> extentRatio;  // [1] of the reference's mother [DivisionRecord]
};

/// The first division whose axes are more than `least` degrees apart.
std::optional<DividedElsewhere> findDividedElsewhere(std::span<const DivisionRecord> divisions,
                                                     std::span<const DivisionRecord> reference, double least = 1);

/// Largest difference of the times at which cells of both lineages were born. [time]
double compareBirths(std::span<const LineageEntry> a, std::span<const LineageEntry> b);

}  // namespace morula
