#pragma once
// A cell and its surroundings at one instant, as its biology, its division and the measures see them. The
// world stands still meanwhile, so the order in which cells are asked cannot matter.
#include <optional>
#include <span>
#include <string>

#include "base/cell_path.h"
#include "base/vec3.h"
#include "biology/state.h"

namespace morula {

class CellContext;
class PhysicalUnit;
struct DivisionRecord;

/// A cell that touches another one.
struct Neighbour {
  const CellContext* cell;
  double area;  // [length²] of the contact, as ContactArea
};

/// Another living cell.
struct OtherCell {
  const CellContext* cell;
  double distance;  // [length] of the two centres: the means of their vertices
};

/// The place of a cell's centre in the shell.
struct ShellPlace {
  Vector along;    // [1] position along x, y and z over the shell's reach that way: −1 to 1
  double out = 0;  // [1] 0 in the shell's middle, 1 on the shell
};

class CellContext {
 public:
  virtual ~CellContext() = default;

  // Properties known of every cell, at no cost
  CellPath path;
  StateId state = 0;
  double time = 0;       // [time] now
  double lastCycle = 0;  // [time] when its last cell cycle was due; before its first cycle, when its mother's was due
  double born = 0;       // [time] of the step in which it was born, which may be a little after `time`
  double pace = 1;       // [1] its cycle lengths over those of its state
  double age() const { return time > born ? time - born : 0; }

  // Computed on first request, and kept. The defaults here describe a cell of which nothing more is known.
  /// Returns the cell's substances, sorted by name, separated by single spaces.
  virtual std::string substances() const { return {}; }
  /// Returns the cell's body; null in a lineage-only scene.
  virtual const PhysicalUnit* physical() const { return nullptr; }
  /// Returns the cells that this cell touches, by path; none in a scene without contact.
  virtual std::span<const Neighbour> neighbours() const { return {}; }
  /// Returns the other daughter of the cell's mother while she lives; else null.
  virtual const CellContext* sister() const { return nullptr; }
  /// Returns how the cell's mother was cut; null for a cell that no division made, and in a lineage-only scene.
  virtual const DivisionRecord* motherDivision() const { return nullptr; }
  /// Returns the division by which the cell's mother was made; null without one.
  virtual const DivisionRecord* grandmotherDivision() const { return nullptr; }
  /// Returns the cells that this cell is connected to, by path; none in a scene without connections.
  virtual std::span<const CellContext* const> connected() const { return {}; }
  /// Returns all other living cells, by path; none in a lineage-only scene.
  virtual std::span<const OtherCell> otherCells() const { return {}; }
  /// Returns the share [1] of the cell's surface that lies on the shell: a vertex there stands for a third of the area
  /// of its faces. 0 without a shell, and for a ball, which touches the shell in a point.
  virtual double shellShare() const { return 0; }
  /// Returns the distance [length] from the cell's centre to the organism's outer surface, as a ball with half the
  /// radius of a mean cell feels it [mesh/cavities.h]; absent in a lineage-only scene.
  virtual std::optional<double> surfaceDistance() const { return {}; }
  /// Returns the place of the cell's centre; absent without a shell.
  virtual std::optional<ShellPlace> placeInShell() const { return {}; }
  /// Returns the cell's largest over its second largest extent [1], as the measure elongation; 1 for a ball.
  virtual double elongation() const { return 1; }
  /// Returns the share [1] of the edges of the cell's surface at which it turns by more than 90°, as the measure
  /// folded; 0 for a ball.
  virtual double foldedShare() const { return 0; }
  /// Returns the share [1] of the edges of the cell's membrane that are compressed, as the measure compressed; 0 for a
  /// ball.
  virtual double compressedShare() const { return 0; }
  /// Returns the cell's volume at rest over the egg's [1], as divisions and growth have made it.
  virtual double size() const { return 1; }
  /// Returns the cell's size [1] at birth, or at the start. Known only where cells divide by what they have gained
  /// (DivisionSize::Rule::adder); 0 elsewhere.
  virtual double sizeAtBirth() const { return 0; }

  // Further properties for division planes
  /// Returns the semi-axes [length] along x, y and z of a shell centred at the origin; absent without such a shell.
  virtual std::optional<Vector> shell() const { return {}; }
  /// Returns the outward unit normal of the shell's face nearest to the cell's centre, for a shell that is a mesh and
  /// has no semi-axes; absent without such a shell.
  virtual std::optional<Vector> nearestShellNormal() const { return {}; }
  /// Returns the centre [length] of the volume of all cells; in a lineage-only scene the origin.
  virtual Point organismCentre() const { return {}; }
  /// Returns the polarity left by the nearest ancestor that left one to her daughters [Cut::polarity]; null if none.
  virtual const Vector* inheritedPolarity() const { return nullptr; }
};

}  // namespace morula
