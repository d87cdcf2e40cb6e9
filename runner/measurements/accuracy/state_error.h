#pragma once
// The distance of one world from another of the same scene.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/cell_path.h"
#include "biology/lineage.h"
#include "division/division_record.h"
#include "mesh/mesh.h"
#include "observation/measures.h"

namespace morula {

/// A cell as other cells see it, whatever its mesh.
struct ComparedCell {
  CellPath path;
  Mesh surface;
  Point centroid;       // [length] of the enclosed volume, as a mean of vertices depends on their positions
  double volume = 0;    // [length³]
  double pressure = 0;  // [force/length²] inner minus outer; 0 for Bullet's cells, for which it is unknown
};

/// All living cells at one time, by path.
struct Shapes {
  double time = 0;
  std::vector<ComparedCell> cells;
  std::vector<ContactMeasures> contacts = {};  // by (a, b)
};

/// Returns a cell with centroid and volume computed from its surface.
ComparedCell comparedCell(const CellPath& path, Mesh surface);

/// Returns the shapes of all cells of a world, which must have bodies.
Shapes takeShapes(const World& world);

/// The errors of a state. Each but `neighbours` is the largest over the cells or pairs of cells.
struct StateError {
  double centroid = 0;     // [radii of the egg] distance of the centroids
  double volume = 0;       // [1] difference of volumes over the reference's
  double surface = 0;      // [radii of the egg] root mean square distance of the surfaces
  double pressure = 0;     // [1] difference of pressures over the reference's largest
  double contactArea = 0;  // [1] likewise for areas; a pair that touches in one world alone differs by its area
  double neighbours = 0;   // [1] share of the touching pairs that touch in one world alone
  /// Returns the largest error of centroids, volumes and surfaces, by which rows are compared.
  double largest() const;
};

/// A quantity whose error is stated at a terminal, on pages, in JSON and in goldens.
struct ErrorQuantity {
  const char *name, *unit;
  double StateError::*of;
  bool ofPairs = false;  // true: absent if no two cells touch
};

/// Returns the name of a quantity: "contact area".
std::string nameOf(const ErrorQuantity& quantity);

inline constexpr ErrorQuantity errorQuantities[] = {
    {"position", "radii of the egg", &StateError::centroid},
    {"surface", "radii of the egg", &StateError::surface},
    {"volume", "of the cell's", &StateError::volume},
    {"pressure", "of the largest", &StateError::pressure},
    {"contact_area", "of the largest", &StateError::contactArea, true},
    {"neighbours", "of all pairs that touch", &StateError::neighbours, true},
};

/// Returns true if the same cells live in both.
bool haveSameCells(const Shapes& a, const Shapes& b);

/// Compares centroids, volumes and surfaces of shapes with the same cells.
StateError compareShapes(const Shapes& shapes, const Shapes& reference, double eggRadius);

/// A division at the same time in two runs but across another plane: a round cell has no longest extent, and a small
/// difference chooses one. The later states then differ by a large share of a radius, whatever the time step.
struct DividedElsewhere {
  CellPath mother;
  double time = 0;                    // [time] of the division in the reference
  double angle = 0;                   // [degrees] between the two axes to daughter A, up to 180
  std::optional<double> extentRatio;  // [1] ratio of the reference's mother [DivisionRecord]
};

/// Returns the first division whose axes differ by more than `least` degrees.
std::optional<DividedElsewhere> findDividedElsewhere(std::span<const DivisionRecord> divisions,
                                                     std::span<const DivisionRecord> reference, double least = 1);

/// Returns the largest difference of birth times [time], over cells of both lineages.
double compareBirths(std::span<const LineageEntry> a, std::span<const LineageEntry> b);

}  // namespace morula
