// The list of cells that a scenario begins with.
#include <algorithm>

#include "values/value_types.h"

namespace morula::scenario {
namespace {

constexpr const char* startForm = "maps, as [{at: [0, 0, 0]}, {at: [2.5, 0, 0], velocity: [-1, 0, 0]}]";
const std::vector<std::string> keys{"at", "velocity", "scale", "turn", "stretch", "mass", "substances"};

constexpr Range degrees{.low = -360, .high = 360};

/// Reads one cell of the list; `path` is "cells[2]".
class CellReader {
 public:
  CellReader(const Node& node, std::string path, Reading& reading)
      : node_(node), path_(std::move(path)), reading_(reading) {}

  StartCell read() {
    StartCell cell;
    refuseUnknown(node_, path_, keys, reading_.problems);
    triple("at", {}, "three numbers [length], as [0, 0, 0]", cell.at);
    triple("velocity", {}, "three numbers [length/time], as [0, 0, 0]", cell.velocity);
    triple("turn", degrees, "three numbers from -360 to 360 [degree], as [0, 0, 30]", cell.turn);
    triple("stretch", positive, "three numbers > 0, as [1, 1, 0.5]", cell.stretch);
    // A cell's scale and mass are not limited to ordinary numbers.
    constexpr Range anyPositive{.low = 0, .openLow = true};
    cell.scale = readMember(node_, "scale", anyPositive, "", path_, reading_.problems).value_or(cell.scale);
    cell.mass = readMember(node_, "mass", anyPositive, "mass", path_, reading_.problems);
    if (const auto* member = node_.find("substances")) cell.substances = readSubstances(member->value);
    return cell;
  }

 private:
  void triple(const char* key, const Range& range, const char* allowed, Vector& value) {
    const auto* member = node_.find(key);
    if (!member) return;
    const auto read = readTriple(member->value, range, path_ + "." + key, allowed, reading_.problems);
    if (read) value = *read;
  }

  std::vector<std::string> readSubstances(const Node& list) {
    const std::string path = path_ + ".substances", allowed = "a list of substances, as [a0, a1]";
    std::vector<std::string> names;
    if (list.kind != Node::Kind::sequence) refuse(list, path, allowed, reading_.problems);
    for (const auto& item : list.items) {
      const auto name = readText(item, path, "a substance's name", reading_.problems);
      if (!name) continue;
      if (std::find(names.begin(), names.end(), *name) != names.end())
        reading_.problems.add(item.place, path, "'" + *name + "' is given twice", "keep one");
      names.push_back(*name);
      reading_.substances.push_back({*name, item.place, path + "." + *name});
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  const Node& node_;
  std::string path_;
  Reading& reading_;
};

Json listOf(const Vector& v) { return Json{v.x, v.y, v.z}; }

Json writeCell(const StartCell& cell) {
  Json map{{"at", listOf(cell.at)},
           {"velocity", listOf(cell.velocity)},
           {"scale", cell.scale},
           {"stretch", listOf(cell.stretch)}};
  if (cell.turn != Vector{}) map["turn"] = listOf(cell.turn);
  if (cell.mass) map["mass"] = *cell.mass;
  if (cell.substances) map["substances"] = *cell.substances;
  return map;
}

Json cellSchema() {
  const auto triple = [](const Range& range) { return listSchema(numberSchema(range), 3); };
  return mapSchema({{"at", triple({})},
                    {"velocity", triple({})},
                    {"scale", numberSchema(positive)},
                    {"turn", triple(degrees)},
                    {"stretch", triple(positive)},
                    {"mass", numberSchema(positive)},
                    {"substances", {{"type", "array"}, {"items", {{"type", "string"}}}, {"uniqueItems", true}}}},
                   {});
}

}  // namespace

Parameter startCells() {
  Parameter p;
  p.path = "cells";
  p.allowed = std::string("a list of ") + startForm + ", or {file: cells.csv}";
  p.meaning =
      "Cells that live at time 0. Keys of each cell: at, its centre; velocity; scale of its size at rest, with its "
      "contents and mass; turn of its mesh in degrees, [0, 0, 30] by 30 about z; stretch of its shape along x, y "
      "and z, not of its rest lengths; mass; substances instead of START. Or {file: cells.csv}: a table with a row for "
      "each cell, and columns x, y, z, radius (or volume or scale), vx, vy, vz, mass, name and substances";
  p.absent = "one egg at the origin";
  const Json list{{"type", "array"}, {"items", cellSchema()}, {"minItems", 1}};
  p.schema = {{"oneOf", Json::array({list, onlySchema("file", {{"type", "string"}, {"minLength", 1}})})}};
  p.read = [allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    if (node.kind == Node::Kind::map && node.find("file")) {
      const auto* file = readOnly(node, "cells", {"file"}, allowed, reading.problems);
      if (!file) return;
      if (const auto name = readWords(file->value, "cells.file", "the name of a table", reading.problems))
        reading.cellsFile = {*name, file->value.place};
      return;
    }
    if (!expectEntries(node, "cells", allowed, reading.problems)) return;
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const Node& item = node.items[i];
      const std::string path = "cells[" + std::to_string(i) + "]";
      reading.startCells.push_back(item.place);
      if (item.kind == Node::Kind::map) s.scene.cells.push_back(CellReader(item, path, reading).read());
      else if (item.kind != Node::Kind::broken)
        reading.problems.add(item.place, path, "is " + describe(item), "needs a map, as {at: [0, 0, 0]}");
    }
  };
  p.write = [](const Scenario& s) {
    if (s.scene.cells.empty() || s.eggIsStretched) return Json();
    Json list = Json::array();
    for (const auto& cell : s.scene.cells) list.push_back(writeCell(cell));
    return list;
  };
  return p;
}

}  // namespace morula::scenario
