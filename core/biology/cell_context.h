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
  Vector along;    // [1] along x, y and z, over how far the shell reaches that way: −1 to 1
  double out = 0;  // [1] 0 in the shell's middle, 1 on the shell
};

class CellContext {
 public:
  virtual ~CellContext() = default;

  // Known of every cell, at no cost
  CellPath path;
  StateId state = 0;
  double time = 0;       // [time] now
  double lastCycle = 0;  // [time] when its last cell cycle was due, or its mother's at its birth
  double born = 0;       // [time] of the step in which it was born, so at times a little after `time`
  double pace = 1;       // [1] its cycle lengths over those of its state
  double age() const { return time > born ? time - born : 0; }

  // Found when it is first asked for, and kept. Here: of a cell of which nothing more is known.
  /// Its substances, sorted by name, separated by single spaces.
  virtual std::string substances() const { return {}; }
  /// Its body; null in a lineage-only scene.
  virtual const PhysicalUnit* physical() const { return nullptr; }
  /// The cells that it touches, by path; none in a scene without contact.
  virtual std::span<const Neighbour> neighbours() const { return {}; }
  /// The other daughter of its mother, while she lives; else null.
  virtual const CellContext* sister() const { return nullptr; }
  /// How its mother was cut; null for a cell that no division made, and in a lineage-only scene.
  virtual const DivisionRecord* motherDivision() const { return nullptr; }
  /// The division by which its mother was made; null without one.
  virtual const DivisionRecord* grandmotherDivision() const { return nullptr; }
  /// The cells that it is connected to, by path; none in a scene without connections.
  virtual std::span<const CellContext* const> connected() const { return {}; }
  /// All other living cells, by path; none in a lineage-only scene.
  virtual std::span<const OtherCell> otherCells() const { return {}; }
  /// [1] The share of its surface that lies on the shell: a vertex there stands for a third of the area of its
  /// faces; 0 without a shell, and of a ball, which touches it in a point.
  virtual double shellShare() const { return 0; }
  /// [length] From its centre to the organism's outer surface, as a ball with half the radius of a mean cell feels it
  /// [mesh/cavities.h]; absent in a lineage-only scene.
  virtual std::optional<double> surfaceDistance() const { return {}; }
  /// Absent without a shell.
  virtual std::optional<ShellPlace> placeInShell() const { return {}; }
  /// [1] Its largest over its second largest extent, as the measure elongation; 1 of a ball.
  virtual double elongation() const { return 1; }
  /// [1] Its volume at rest over the egg's: what divisions and growth have made of it.
  virtual double size() const { return 1; }
  /// [1] That of its birth, or of the start. Known only where cells divide by what they have gained
  /// (DivisionSize::Rule::adder); 0 elsewhere.
  virtual double sizeAtBirth() const { return 0; }

  // Further properties for division planes
  /// [length] Semi-axes along x, y and z of the shell, which has its centre at the origin; absent: no such shell.
  virtual std::optional<Vector> shell() const { return {}; }
  /// For a shell that is a mesh and has no semi-axes: the outward unit normal of its face nearest to the cell's
  /// centre; absent: no such shell.
  virtual std::optional<Vector> nearestShellNormal() const { return {}; }
  /// [length] The centre of the volume of all cells; in a lineage-only scene the origin.
  virtual Point organismCentre() const { return {}; }
  /// The polarity that the nearest of its ancestors with one left to her daughters [Cut::polarity]; null: none had any.
  virtual const Vector* inheritedPolarity() const { return nullptr; }
};

}  // namespace morula
