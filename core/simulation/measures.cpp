// The tables of measures. To add one: a row here.
#include "simulation/measures.h"

#include <algorithm>

#include "base/error.h"
#include "division/principal_axis.h"
#include "mesh/measures.h"
#include "simulation/body_measures.h"

namespace morula {

namespace {

const Bodies& bodiesOf(const Observation& now) { return *now.world.bodies; }
const BodyShape& shapeOf(const CellContext& cell) { return cell.physical()->getShape(); }

/// Over all cells with a body.
template <class Get>
double sumOf(const Observation& now, const Get& get) {
  double sum = 0;
  for (int slot : bodiesOf(now).slots) sum += get(bodiesOf(now), slot);
  return sum;
}
double volumeOf(const Bodies& b, int slot) { return b.volume[slot]; }
double pressureOf(const Bodies& b, int slot) { return b.pressure[slot]; }

using Value = std::optional<double>;
using Now = const Observation&;
using Cell = const CellContext&;

// clang-format off
constexpr WorldMeasure ofWorld[] = {
    {.name = "cells", .meaning = "Cells that live", .needs = Needs::nothing, .isWhole = true,
     .get = [](Now now) -> Value { return double(now.world.cells.path.size()); }},
    {.name = "volume", .unit = "length³",
     .meaning = "Of all cells, as the last evaluation of the forces found it [Nilsson 2008, eq. 4.4]",
     .get = [](Now now) -> Value { return sumOf(now, volumeOf); }},
    {.name = "kinetic_energy", .unit = "force·length",
     .meaning = "½ Σ m v² over the vertices of all cells",
     .get = [](Now now) -> Value { return sumOf(now, measureKineticEnergy); }},
    {.name = "mean_pressure", .unit = "force/length²",
     .meaning = "Inner minus outer pressure [Nilsson 2008, eq. 4.3], in the mean over the cells; absent without cells",
     .get = [](Now now) -> Value {
       const int count = bodiesOf(now).count;
       return count > 0 ? Value(sumOf(now, pressureOf) / count) : Value();
     }},
    {.name = "shell_fill", .meaning = "Volume of all cells over the shell's", .needs = Needs::shell,
     .get = [](Now now) -> Value { return sumOf(now, volumeOf) / measureShellVolume(bodiesOf(now)); }},
    {.name = "outermost", .unit = "shell radii",
     .meaning = "How far out the farthest vertex, or ball, reaches: 1 on the shell; absent without cells",
     .needs = Needs::shell,
     .get = [](Now now) -> Value {
       Value most;
       for (int slot : bodiesOf(now).slots) most = std::max(most.value_or(0), measureOutermost(bodiesOf(now), slot));
       return most;
     }},
    {.name = "extent", .unit = "length",
     .meaning = "The farthest that a vertex, or a ball's surface, is from the origin",
     .taken = Taken::onDemand,
     .get = [](Now now) -> Value { return measureExtent(bodiesOf(now)); }},
    {.name = "energy", .unit = "force·length",
     .meaning = "Of motion ½mv², membranes ½k_s(l−l₀)² and contents k_p (r−1−ln r), r = P₀V/k_p: 0 at rest; not what "
                "contacts and connections hold",
     .taken = Taken::onDemand,
     .get = [](Now now) -> Value { return measureEnergy(bodiesOf(now)); }},
    {.name = "momentum_x", .unit = "mass·length/time",
     .meaning = "Σ m v over the vertices of all cells, along x",
     .taken = Taken::onDemand,
     .get = [](Now now) -> Value { return measureMomentum(bodiesOf(now)).x; }},
    {.name = "momentum_y", .unit = "mass·length/time", .meaning = "The same along y", .taken = Taken::onDemand,
     .get = [](Now now) -> Value { return measureMomentum(bodiesOf(now)).y; }},
    {.name = "momentum_z", .unit = "mass·length/time", .meaning = "The same along z", .taken = Taken::onDemand,
     .get = [](Now now) -> Value { return measureMomentum(bodiesOf(now)).z; }},
    {.name = "mean_overlap",
     .meaning = "Share of a cell's volume that lies in another cell too, in the mean over the cells, by 256 × 256 scan "
                "lines",
     .taken = Taken::onDemand,
     .get = [](Now now) -> Value { return measureMeanOverlap(bodiesOf(now)); }},
};

constexpr CellMeasure ofCell[] = {
    {.name = "volume", .unit = "length³",
     .meaning = "What its surface encloses, by the divergence theorem [Nilsson 2008, eq. 4.4]",
     .get = [](Cell cell) -> Value { return shapeOf(cell).volume; }},
    {.name = "area", .unit = "length²", .meaning = "Of its surface",
     .get = [](Cell cell) -> Value { return shapeOf(cell).area; }},
    {.name = "pressure", .unit = "force/length²",
     .meaning = "Inner minus outer [Nilsson 2008, eq. 4.3]; absent in models without contents under pressure",
     .get = [](Cell cell) -> Value { return shapeOf(cell).pressure; }},
    {.name = "x", .unit = "length", .meaning = "Of the mean of its vertices, which carry the mass",
     .get = [](Cell cell) -> Value { return shapeOf(cell).centre.x; }},
    {.name = "y", .unit = "length", .meaning = "The same along y",
     .get = [](Cell cell) -> Value { return shapeOf(cell).centre.y; }},
    {.name = "z", .unit = "length", .meaning = "The same along z",
     .get = [](Cell cell) -> Value { return shapeOf(cell).centre.z; }},
    {.name = "sphericity", .meaning = "π^(1/3) (6V)^(2/3) / A: 1 for a sphere [Wadell 1935]",
     .get = [](Cell cell) -> Value {
       const BodyShape& shape = shapeOf(cell);
       return shape.isBall ? 1 : sphericity(shape.volume, shape.area);
     }},
    {.name = "elongation",
     .meaning = "Largest over second largest extent, root mean square distances of its vertices from their mean along "
                "the principal axes: 1 for a ball and a disc",
     .get = [](Cell cell) -> Value {
       const BodyShape& shape = shapeOf(cell);
       return shape.isBall ? 1 : extentRatio(shape.surface.vertices);
     }},
    {.name = "neighbours", .meaning = "Cells that it touches; 0 where cells cannot touch", .needs = Needs::contact,
     .isWhole = true,
     .get = [](Cell cell) -> Value { return double(cell.neighbours().size()); }},
    {.name = "volume_over_rest",
     .meaning = "Volume over what it would be if nothing pressed on the cell: with contents under pressure its share of "
                "the egg's, otherwise that of its mesh with its rest lengths",
     .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value { return cell.physical()->getVolume() / cell.physical()->getRestVolume(); }},
    {.name = "volume_over_mesh", .meaning = "Volume over that of its mesh with its rest lengths",
     .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value { return cell.physical()->getVolume() / cell.physical()->getMeshVolume(); }},
    {.name = "inverted", .meaning = "Share of its surface whose outer side is turned to the mean of its vertices",
     .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value { return measureInvertedShare(shapeOf(cell)); }},
};

constexpr PairMeasure ofPair[] = {
    {.name = "area", .unit = "length²",
     .meaning = "Of the contact: the mean of what the vertices of either cell stand for that touch the other one; of two "
                "balls the disc in which their surfaces meet",
     .needs = Needs::contact,
     .get = [](const Touch& touch) -> Value { return touch.area; }},
};
// clang-format on

/// True if a world has what a measure needs.
bool has(const World& world, Needs needs) {
  switch (needs) {
    case Needs::nothing:
      return true;
    case Needs::shell:
      return world.bodies && world.bodies->parameters.shell;
    case Needs::bodies:
    case Needs::contact:  // without contact no cells touch: 0, not unknown
      return world.bodies.has_value();
  }
  MORULA_CHECK(false, "a need that is not known");
}

template <class Of>
void take(const World& world, const Of& of, Measured<Of>& into) {
  const auto rows = sampledMeasures<Of>();
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (has(world, rows[i].needs)) into.values[i] = rows[i].get(of);
}

}  // namespace

const char* name(Needs needs) {
  constexpr const char* names[] = {"nothing", "bodies", "contact", "a shell"};
  return names[static_cast<int>(needs)];
}

template <>
std::span<const WorldMeasure> measures<Observation>() {
  return ofWorld;
}
template <>
std::span<const CellMeasure> measures<CellContext>() {
  return ofCell;
}
template <>
std::span<const PairMeasure> measures<Touch>() {
  return ofPair;
}

template <class Of>
std::span<const Measure<Of>> sampledMeasures() {
  const auto all = measures<Of>();
  const auto end = std::ranges::find(all, Taken::onDemand, &Measure<Of>::taken);
  return all.first(end - all.begin());
}

template <class Of>
const Measure<Of>& measure(std::string_view name) {
  const auto all = measures<Of>();
  const auto at = std::ranges::find(all, name, &Measure<Of>::name);
  MORULA_CHECK(at != all.end(), "a measure that no row names");
  return *at;
}

template <class Of>
std::size_t Measured<Of>::indexOf(std::string_view name) {
  const auto rows = sampledMeasures<Of>();
  const auto at = std::ranges::find(rows, name, &Measure<Of>::name);
  MORULA_CHECK(at != rows.end(), "a measure that samples do not hold");
  return at - rows.begin();
}

template <class Of>
double Measured<Of>::at(std::string_view name) const {
  const std::optional<double>& value = values[indexOf(name)];
  MORULA_CHECK(value.has_value(), "a value that was not measured");
  return *value;
}

#define MORULA_MEASURES_OF(Of)                             \
  template std::span<const Measure<Of>> sampledMeasures(); \
  template const Measure<Of>& measure(std::string_view);   \
  template class Measured<Of>;
MORULA_MEASURES_OF(Observation)
MORULA_MEASURES_OF(CellContext)
MORULA_MEASURES_OF(Touch)
#undef MORULA_MEASURES_OF

WorldMeasures measureWorld(const Observation& now) {
  WorldMeasures m;
  m.time = now.time;
  m.step = now.world.clock.step;
  take(now.world, now, m);
  return m;
}

std::vector<CellMeasures> measureCells(const Observation& now) {
  std::vector<CellMeasures> all;
  if (!now.world.bodies) return all;
  for (int i = 0; i < now.world.bodies->count; ++i) {
    const ObservedCell cell(now, i);
    CellMeasures& m = all.emplace_back();
    m.path = cell.path;
    m.state = cell.state;
    take<CellContext>(now.world, cell, m);
  }
  return all;
}

std::vector<ContactMeasures> measureContacts(const Observation& now) {
  std::vector<ContactMeasures> all;
  for (const auto& [a, b, area] : now.contacts()) {
    ContactMeasures& m = all.emplace_back();
    const Touch touch{now.cell(a), now.cell(b), area};
    m.a = touch.a.path;
    m.b = touch.b.path;
    take(now.world, touch, m);
  }
  return all;
}

Mesh cellMesh(const World& world, const CellPath& path) {
  if (!world.bodies) return {};
  const int number = cellNumber(world.cells, path);
  return number < 0 ? Mesh{} : takeSurface(*world.bodies, world.bodies->slots[number]);
}

std::vector<Point> cellVertices(const World& world, const CellPath& path) {
  return cellMesh(world, path).vertices;
}

}  // namespace morula
