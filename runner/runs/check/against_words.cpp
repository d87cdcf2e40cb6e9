#include <fmt/format.h>

#include <algorithm>

#include "base/number_text.h"
#include "check/against.h"
#include "check/remarks.h"
#include "files/text.h"

namespace morula {
namespace {

std::string nameIn(const Scenario& scenario, const CellPath& path) {
  return scenario.names.of(path).value_or(path.isEgg() ? "egg" : path.text());
}

std::vector<std::string> cellsOf(const AgainstStage& stage, FoundIn in, const Scenario& scenario) {
  std::vector<std::string> names;
  for (const AgainstCell& cell : stage.byCell)
    if (cell.in == in) names.push_back(nameIn(scenario, cell.path));
  return names;
}

}  // namespace

std::string stageWords(const AgainstStage& stage, const Units& units) {
  return stage.ofCells ? counted(*stage.ofCells, "cell") : "time " + shownTime(units, stage.ofTime.value_or(0));
}

Table againstTable(const std::vector<AgainstStage>& stages, const Scenario& scenario, std::size_t most) {
  const ShownUnit length = shownUnit(scenario.units, "length");
  const bool hasContacts = std::ranges::any_of(stages, [](const AgainstStage& s) { return s.contactF1.has_value(); });
  Table table{"Measured places", {"Stage", timeLabel(scenario.units), "Compared", length.after("Distance")}};
  if (hasContacts) table.columns.push_back("Contacts (F1)");
  table.columns.insert(table.columns.end(), {length.after("Farthest cells"), "Not compared"});
  for (const AgainstStage& stage : stages) {
    if (table.rows.size() == most && stages.size() > most + 1) {
      table.rows.emplace_back(table.columns.size(), Cell())[0] = counted(stages.size() - most, "further stage");
      break;
    }
    std::vector<std::string> far, left;
    for (const AgainstCell& cell : stage.byCell)
      if (cell.distance)
        far.push_back(nameIn(scenario, cell.path) + " " + numberText(*cell.distance * length.factor, 3));
    if (!stage.why.empty()) left.push_back(stage.why);
    if (const auto here = cellsOf(stage, FoundIn::run, scenario); !here.empty())
      left.push_back("not in the table: " + listed(here));
    if (const auto there = cellsOf(stage, FoundIn::table, scenario); !there.empty())
      left.push_back("not in the run: " + listed(there));
    const auto scaled = [](std::optional<double> a, double factor) { return a ? std::optional(*a * factor) : a; };
    table.rows.push_back({stageWords(stage, scenario.units), number(scaled(stage.time, scenario.units.perTime)),
                          stage.compared, number(scaled(stage.rmsd, length.factor), 3)});
    if (hasContacts) table.rows.back().push_back(number(stage.contactF1, 3));
    table.rows.back().insert(table.rows.back().end(), {listed(far, 4), join(left, "; ")});
  }
  return table;
}

std::vector<std::string> againstRemarks(const std::vector<AgainstStage>& stages, const Units& units) {
  std::vector<std::string> scaled, mirrored;
  std::string firstScale, firstShapes;
  for (const AgainstStage& stage : stages) {
    if (!stage.rmsd) continue;
    // Shapes that do not fit have no scale.
    if (stage.mirroredShapeRmsd && fitsMirrored(stage.compared, *stage.shapeRmsd, *stage.mirroredShapeRmsd)) {
      if (mirrored.empty())
        firstShapes = fmt::format("{:.2g} instead of {:.2g} of the extent", *stage.mirroredShapeRmsd, *stage.shapeRmsd);
      mirrored.push_back(stageWords(stage, units));
    } else if (isOtherScale(*stage.scale)) {
      if (scaled.empty()) firstScale = numberText(*stage.scale, 3);
      scaled.push_back(stageWords(stage, units));
    }
  }
  std::vector<std::string> sentences;
  if (!scaled.empty())
    sentences.push_back(fmt::format(
        "at {} the table's places lie {} times as far apart as the cells, and distances are compared without scaling; "
        "give the table's units, as --against-units 0.5µm,min",
        listed(scaled, 3), firstScale));
  if (!mirrored.empty())
    sentences.push_back(fmt::format(
        "at {} the mirror image of the cells fits the table's places better than the cells do ({}); check the "
        "handedness of the table's axes",
        listed(mirrored, 3), firstShapes));
  return sentences;
}

Json againstJson(const std::vector<AgainstStage>& stages, const Scenario& scenario) {
  Json list = Json::array();
  for (const AgainstStage& stage : stages) {
    Json cells = Json::array();
    for (const AgainstCell& cell : stage.byCell)
      if (cell.distance)
        cells.push_back(
            {{"cell", nameIn(scenario, cell.path)}, {"path", cell.path.text()}, {"distance", *cell.distance}});
    list.push_back({{"of_cells", orNull(stage.ofCells)},
                    {"of_time", orNull(stage.ofTime)},
                    {"time", orNull(stage.time)},
                    {"cells", stage.cells},
                    {"compared", stage.compared},
                    {"rmsd", orNull(stage.rmsd)},
                    {"shape_rmsd", orNull(stage.shapeRmsd)},
                    {"scale", orNull(stage.scale)},
                    {"mirrored_shape_rmsd", orNull(stage.mirroredShapeRmsd)},
                    {"contact_f1", orNull(stage.contactF1)},
                    {"why", stage.why},
                    {"distances", std::move(cells)},
                    {"not_in_run", cellsOf(stage, FoundIn::table, scenario)},
                    {"not_in_table", cellsOf(stage, FoundIn::run, scenario)}});
  }
  return list;
}

}  // namespace morula
