#pragma once
// A world at one instant, as policies and measures see it. The world must not change while the observation exists. A
// quantity is measured on first request, and kept. Only one thread at a time may use it.
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "biology/cell_context.h"
#include "biology/physical_unit.h"
#include "contacts/contact_areas.h"
#include "mesh/cavities.h"
#include "mesh/folds.h"
#include "observation/reference.h"
#include "state/world.h"

namespace morula {

class ObservedCell;

class Observation {
 public:
  /// `time` [time]: the time of the cells, at which the present cell cycles are due. It may lie a little before the
  /// clock's time. The world must outlive the observation.
  Observation(const World& world, double time);
  explicit Observation(const World& world);
  Observation(const Observation&) = delete;
  Observation& operator=(const Observation&) = delete;
  ~Observation();

  const World& world;
  const double time;
  const Reference* reference = nullptr;  // what some measures compare the world with; null: nothing
  /// [time] Duration of each of contacts(), which no state holds; empty: not known.
  std::span<const double> contactDurations;

  /// Returns a living cell by its number. The cell and its measures are kept as long as the observation. To look at all
  /// cells in turn make an ObservedCell of each: then only one shape is in memory at a time.
  const CellContext& cell(int number) const;

  /// Returns the cells that touch, by (a, b); none without contact.
  const std::vector<ContactArea>& contacts() const;
  struct Contact {
    int cell;     // number of the other cell
    double area;  // [length²]
  };
  /// Returns the contacts of one cell, sorted by the other cell's number.
  std::span<const Contact> contactsOf(int number) const;

  /// Returns the volume [length³] of one of the scene's meshes at rest, at rest scale 1.
  double meshVolume(int meshLevel) const;
  /// Returns findFlatEdges of one of the scene's meshes.
  const EdgeFaces& flatEdges(int meshLevel) const;
  /// Returns the centre [length] of the volume of all cells. Requires bodies.
  Point organismCentre() const;
  /// Returns the division of this cell; null if no division made daughters of it.
  const DivisionRecord* divisionOf(const CellPath& mother) const;
  /// Returns the mean [length] of a cell's vertices. Requires bodies.
  const Point& centreOf(int number) const;

  /// Returns the cavities between the surfaces of all cells, for a probe with half the radius of a ball with their mean
  /// volume. Requires bodies.
  const Cavities& cavities() const;
  /// Returns the probe's radius [length].
  double probe() const;

  /// How often shapes and contacts have been measured.
  struct Counts {
    int shapes = 0, contacts = 0;
    friend bool operator==(const Counts&, const Counts&) = default;
  };
  const Counts& measured() const { return measured_; }

 private:
  friend class BodyUnit;
  mutable Counts measured_;
  mutable std::vector<std::unique_ptr<ObservedCell>> cells_;
  mutable std::optional<std::vector<ContactArea>> contacts_;
  mutable std::vector<int> firstContact_;  // [cell + 1] into contactsByCell_
  mutable std::vector<Contact> contactsByCell_;
  mutable std::vector<double> meshVolumes_;            // [meshLevel]
  mutable std::vector<EdgeFaces> flatEdges_;           // [meshLevel]
  mutable std::vector<std::uint32_t> divisionByPath_;  // indices into world.divisions
  mutable std::optional<Point> organismCentre_;
  mutable std::vector<Point> centres_;  // [cell]; empty: not measured
  mutable std::optional<Cavities> cavities_;
};

/// A body as an observation sees it.
class BodyUnit final : public PhysicalUnit {
 public:
  BodyUnit(const Observation& observation, int slot);
  double getMass() const override { return bodies_.mass(slot_); }
  double getVolume() const override { return bodies_.volume[slot_]; }
  double getPressure() const override { return bodies_.pressure[slot_]; }
  double getRestVolume() const override;
  double getMeshVolume() const override;
  const BodyShape& getShape() const override;

 private:
  const Observation& observation_;
  const Bodies& bodies_;
  int slot_;
  mutable std::optional<BodyShape> shape_;
};

/// A cell of an observation, as policies and measures see it.
class ObservedCell final : public CellContext {
 public:
  ObservedCell(const Observation& observation, int number);
  std::string substances() const override;
  const PhysicalUnit* physical() const override;
  std::span<const Neighbour> neighbours() const override;
  const CellContext* sister() const override;
  const DivisionRecord* motherDivision() const override;
  const DivisionRecord* grandmotherDivision() const override;
  std::span<const CellContext* const> connected() const override;
  std::optional<Vector> shell() const override;
  std::optional<Vector> nearestShellNormal() const override;
  Point organismCentre() const override;
  const Vector* inheritedPolarity() const override;
  std::span<const OtherCell> otherCells() const override;
  double shellShare() const override;
  std::optional<double> surfaceDistance() const override;
  std::optional<ShellPlace> placeInShell() const override;
  double elongation() const override;
  double foldedShare() const override;
  double compressedShare() const override;
  double size() const override;
  double sizeAtBirth() const override;

  /// number: the cell's number among the living. slot: where its body is, if it has one.
  int number() const { return number_; }
  int slot() const { return observation_.world.bodies->slots[number_]; }

 private:
  const Observation& observation_;
  int number_;
  mutable std::optional<BodyUnit> body_;
  mutable std::optional<std::vector<Neighbour>> neighbours_;
  mutable std::optional<std::vector<const CellContext*>> connected_;
  mutable std::optional<std::vector<OtherCell>> others_;
};

}  // namespace morula
