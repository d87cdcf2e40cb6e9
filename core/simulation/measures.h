#pragma once
// What can be read off a World. Measured on demand only; nothing here is computed unless somebody asks.
#include <cstdint>
#include <optional>
#include <vector>

#include "base/cell_path.h"
#include "base/vec3.h"
#include "biology/state.h"
#include "connections/connections.h"
#include "mesh/mesh.h"

namespace morula {

struct Bodies;
struct World;

/// One living cell's geometry. Lineage-only worlds have none.
struct CellMeasures {
  CellPath path;
  StateId state = 0;
  double volume = 0;      // [length³] by the divergence theorem [Nilsson 2008, eq. 4.4]
  double area = 0;        // [length²]
  double pressure = 0;    // [force/length²] inner minus outer [Nilsson 2008, eq. 4.3]; a sphere has none
  Point centroid;         // [length] of the vertices, which carry the mass
  double sphericity = 0;  // π^(1/3) (6V)^(2/3) / A, 1 for a sphere
  int neighbours = 0;     // cells it touches
};

struct ContactMeasures {
  CellPath a, b;    // a < b
  double area = 0;  // [length²]
};

/// What the scene does not have, or no living cell has, is not measured and absent.
struct WorldMeasures {
  double time = 0;
  std::uint64_t step = 0;
  std::uint64_t cells = 0;              // alive
  std::optional<double> volume;         // [length³] all cells; with bodies
  std::optional<double> kineticEnergy;  // [force·length]; with bodies
  std::optional<double> meanPressure;   // [force/length²]; with bodies, of the living cells
  std::optional<double> shellFill;      // volume / the shell's volume; with a shell
  std::optional<double> outermost;  // largest distance of a vertex, in shell radii (1: on the shell); with a
                                    // shell, of the living cells
};

/// ½ Σ m v² over a cell's vertices. [force·length]
double measureKineticEnergy(const Bodies& bodies, int slot);
/// [shell radii] How far out a cell reaches: 1 on the shell, which there must be. A sphere's is that of the ball itself: the
/// mesh that it is drawn with holds its volume, so that its vertices stand farther out.
double measureOutermost(const Bodies& bodies, int slot);
WorldMeasures measureWorld(const World& world);
/// By lineage path; empty in a lineage-only world.
std::vector<CellMeasures> measureCells(const World& world);
/// By (a, b); empty without contact.
std::vector<ContactMeasures> measureContacts(const World& world);
/// Mean over the cells of the share of a cell's volume that lies in another cell too, by scan lines through a
/// grid of `columns` × `columns` columns; O(cells · faces). [1]
double measureMeanOverlap(const World& world, int columns = 256);

/// The surface of one living cell: vertex positions, in the order of its mesh, and faces. Empty if no such
/// cell lives, or without bodies.
Mesh cellMesh(const World& world, const CellPath& path);
/// Its vertices alone.
std::vector<Point> cellVertices(const World& world, const CellPath& path);

}  // namespace morula
