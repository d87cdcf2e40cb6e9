// The measures of one cell. To add one: a row here; measures on demand stand last.
#include <cmath>
#include <numbers>

#include "base/angle.h"
#include "division/division_record.h"
#include "division/principal_axis.h"
#include "mesh/mesh_measures.h"
#include "observation/body_measures.h"
#include "observation/crumpling.h"
#include "observation/measures.h"

namespace morula {
namespace {

using Value = std::optional<double>;
using Cell = const CellContext&;

const BodyShape& shapeOf(Cell cell) { return cell.physical()->getShape(); }

Vector extentsOf(Cell cell) {
  const BodyShape& shape = shapeOf(cell);
  if (!shape.isBall) return principalExtents(shape.surface.vertices);
  const double extent = std::sqrt(shape.area / (12 * std::numbers::pi));  // r/√3, with A = 4πr²
  return {extent, extent, extent};
}

// clang-format off
constexpr CellMeasure ofCell[] = {
    {.name = "volume", .unit = "length³",
     .meaning = "Volume that its surface encloses, by the divergence theorem [Nilsson 2008, eq. 4.4]",
     .followsNumber = true, .get = [](Cell cell) -> Value { return shapeOf(cell).volume; }},
    {.name = "area", .unit = "length²", .meaning = "Area of its surface",
     .followsNumber = true, .get = [](Cell cell) -> Value { return shapeOf(cell).area; }},
    {.name = "pressure", .unit = "force/length²",
     .meaning = "Inner minus outer pressure [Nilsson 2008, eq. 4.3]; absent in models without contents under "
                "pressure",
     .get = [](Cell cell) -> Value { return shapeOf(cell).pressure; }},
    {.name = "x", .unit = "length", .meaning = "Mean x of its vertices, which carry the mass",
     .get = [](Cell cell) -> Value { return shapeOf(cell).centre.x; }},
    {.name = "y", .unit = "length", .meaning = "Mean y of its vertices",
     .get = [](Cell cell) -> Value { return shapeOf(cell).centre.y; }},
    {.name = "z", .unit = "length", .meaning = "Mean z of its vertices",
     .get = [](Cell cell) -> Value { return shapeOf(cell).centre.z; }},
    {.name = "sphericity", .meaning = "π^(1/3) (6V)^(2/3) / A: 1 for a sphere [Wadell 1935]",
     .get = [](Cell cell) -> Value {
       const BodyShape& shape = shapeOf(cell);
       return shape.isBall ? 1 : sphericity(shape.volume, shape.area);
     }},
    {.name = "elongation",
     .meaning = "Largest over second largest extent: root mean square distances of its vertices from their mean "
                "along the principal axes; 1 for a ball and a disc",
     .get = [](Cell cell) -> Value { return cell.elongation(); }},
    {.name = "neighbours", .meaning = "Number of cells that it touches; 0 where cells cannot touch",
     .needs = Needs::contact,
     .isWhole = true,
     .followsNumber = true, .get = [](Cell cell) -> Value { return double(cell.neighbours().size()); }},
    {.name = "volume_over_rest",
     .meaning = "Volume over the volume at rest, if nothing pressed on the cell: with contents under pressure its "
                "share of the egg's, otherwise that of its mesh with its rest lengths",
     .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value { return cell.physical()->getVolume() / cell.physical()->getRestVolume(); }},
    {.name = "volume_over_mesh", .meaning = "Volume over the volume of its mesh with its rest lengths",
     .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value { return cell.physical()->getVolume() / cell.physical()->getMeshVolume(); }},
    {.name = "inverted", .meaning = "Share of its surface whose outer side is turned to the mean of its vertices",
     .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value { return measureInvertedShare(shapeOf(cell)); }},
    {.name = "folded",
     .meaning = "Share of the edges of its surface at which it folds over: the normals of both faces are more than 90° "
                "apart (dihedral angle), and not so in its mesh at rest; 0 for a ball",
     .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value { return cell.foldedShare(); }},
    {.name = "compressed",
     .meaning = "Share of the edges of its membrane under compression: below 0.98 of their rest length; 0 for a ball",
     .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value { return cell.compressedShare(); }},
    {.name = "self_overlap",
     .meaning = "Share of its volume in which it lies in itself: its surface winds around it more than once, or inside "
                "out; by 24 × 24 scan lines along each axis, to about 0.001; 0 for a ball",
     .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value { return measureSelfOverlap(shapeOf(cell)); }},
    {.name = "extent_1", .unit = "length",
     .meaning = "Its largest extent: root mean square distance of its vertices from their mean along the first principal "
                "axis; radius/√3 for a ball",
     .taken = Taken::onDemand,
     .followsNumber = true, .get = [](Cell cell) -> Value { return extentsOf(cell).x; }},
    {.name = "extent_2", .unit = "length", .meaning = "Its second extent, along the second principal axis",
     .taken = Taken::onDemand,
     .followsNumber = true, .get = [](Cell cell) -> Value { return extentsOf(cell).y; }},
    {.name = "extent_3", .unit = "length", .meaning = "Its smallest extent, along the third principal axis",
     .taken = Taken::onDemand,
     .followsNumber = true, .get = [](Cell cell) -> Value { return extentsOf(cell).z; }},
    {.name = "shell_share",
     .meaning = "Share of its surface that lies on the shell: a vertex there stands for a third of the area of its "
                "faces; 0 for a ball",
     .needs = Needs::shell, .taken = Taken::onDemand,
     .followsNumber = true, .get = [](Cell cell) -> Value { return cell.shellShare(); }},
    {.name = "surface_distance", .unit = "length",
     .meaning = "Distance of its centre from the organism's outer surface, as a ball with half the radius of a mean "
                "cell feels it from outside, to 2h of the grid of lumen; a lumen is not outside, the gap to a shell "
                "is",
     .taken = Taken::onDemand,
     .followsNumber = true, .get = [](Cell cell) { return cell.surfaceDistance(); }},
    {.name = "shell_r",
     .meaning = "Place of its centre between the shell's middle, 0, and the shell, 1; in a sphere the share of the "
                "radius",
     .needs = Needs::shell, .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value { return cell.placeInShell()->out; }},
    {.name = "shell_x", .meaning = "x of its centre over the shell's extent in that direction: −1 to 1",
     .needs = Needs::shell, .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value { return cell.placeInShell()->along.x; }},
    {.name = "shell_y", .meaning = "y of its centre over the shell's extent in that direction: −1 to 1",
     .needs = Needs::shell, .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value { return cell.placeInShell()->along.y; }},
    {.name = "shell_z", .meaning = "z of its centre over the shell's extent in that direction: −1 to 1",
     .needs = Needs::shell, .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value { return cell.placeInShell()->along.z; }},
    {.name = "age", .unit = "time", .meaning = "Time since its birth",
     .needs = Needs::nothing, .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value { return cell.age(); }},
    {.name = "generation", .meaning = "Number of divisions between the egg and the cell", .needs = Needs::nothing,
     .taken = Taken::onDemand, .isWhole = true,
     .followsNumber = true, .get = [](Cell cell) -> Value { return double(cell.path.depth()); }},
    {.name = "axis_turn", .unit = "degree",
     .meaning = "Angle between the axes of the division that made it and of the division before, as lines, 0 to 90; "
                "absent where no two divisions made it",
     .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value {
       const DivisionRecord *own = cell.motherDivision(), *before = cell.grandmotherDivision();
       return own && before ? Value(angleOfLines(own->axis, before->axis)) : Value();
     }},
    {.name = "axis_to_x", .unit = "degree",
     .meaning = "Angle between the axis of the division that made it and the body's x axis, as lines, 0 to 90",
     .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value {
       const DivisionRecord* own = cell.motherDivision();
       return own ? Value(angleOfLines(own->axis, {1, 0, 0})) : Value();
     }},
    {.name = "birth_share",
     .meaning = "Share of its mother's volume that it was given; absent where no division made it",
     .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value {
       const DivisionRecord* own = cell.motherDivision();
       if (!own) return {};
       return cell.path.letter(cell.path.depth() - 1) ? 1 - own->share : own->share;
     }},
    {.name = "birth_ambiguity",
     .meaning = "Ratio of its mother's two largest extents when she was cut: near 1 her longest extent was "
                "ambiguous; absent for balls",
     .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value {
       const DivisionRecord* own = cell.motherDivision();
       return own ? own->extentRatio : Value();
     }},
    {.name = "displacement", .unit = "length",
     .meaning = "Distance of its centre from the centre's place at its birth, in a straight line; absent where no "
                "division made it",
     .taken = Taken::onDemand,
     .get = [](Cell cell) -> Value {
       const DivisionRecord* own = cell.motherDivision();
       if (!own) return {};
       return norm(shapeOf(cell).centre - (cell.path.letter(cell.path.depth() - 1) ? own->centreB : own->centreA));
     }},
};
// clang-format on

}  // namespace

template <>
std::span<const CellMeasure> measures<CellContext>() {
  return ofCell;
}

}  // namespace morula
