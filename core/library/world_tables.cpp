#include "library/world_tables.h"

#include <algorithm>
#include <limits>

#include "library/table.h"
#include "observation/run_rows.h"

namespace morula {
namespace {

using NameOf = std::function<std::optional<std::string>(const CellPath&)>;

/// Makes the table of the rows that each(add) adds, one by one, with the values of the context.
template <Record Row, class... Context>
DataTable tableFrom(const char* context, const auto& rows, const Context&... values) {
  DataTable table = tableWithout<Row>("", context, values...);
  for (const Row& row : rows) addRow(table, context, row, values...);
  return table;
}

/// Makes a table whose first column numbers the rows from 0.
template <Record Row>
DataTable numbered(const std::vector<Row>* rows) {
  DataTable table = tableWithout<Row>("", "number", std::int64_t{0});
  std::int64_t number = 0;
  if (rows)
    for (const Row& row : *rows) addRow(table, "number", row, number++);
  return table;
}

DataTable lineageOf(const World& world, const NameOf& nameOf) {
  std::vector<CellRow> rows;
  for (const LineageEntry& e : world.lineage.entries)
    rows.push_back({e, world.biology->describe(e.state), nameOf ? nameOf(e.path) : std::nullopt});
  return tableFrom<CellRow>("", rows);
}

DataTable cellsOf(const Observation& now) {
  std::vector<CellSampleRow> rows;
  for (CellMeasures& cell : measureCells(now)) {
    std::string state = now.world.biology->describe(cell.state);
    rows.push_back({std::move(cell), std::move(state)});
  }
  return tableFrom<CellSampleRow>("time", rows, now.time);
}

struct TableMaker {
  const char* name;
  DataTable (*make)(const Observation& now, const NameOf& nameOf);
};
constexpr TableMaker tables[] = {
    {"cell", [](const Observation& now, const NameOf& nameOf) { return lineageOf(now.world, nameOf); }},
    {"sample", [](const Observation& now,
                  const NameOf&) { return tableFrom<WorldMeasures>("", std::vector{measureWorld(now)}); }},
    {"cell_sample", [](const Observation& now, const NameOf&) { return cellsOf(now); }},
    {"contact", [](const Observation& now,
                   const NameOf&) { return tableFrom<ContactMeasures>("time", measureContacts(now), now.time); }},
    {"connection",
     [](const Observation& now, const NameOf&) {
       return numbered<ConnectionRecord>(now.world.connections ? &now.world.connections->history : nullptr);
     }},
    {"division",
     [](const Observation& now, const NameOf&) { return tableFrom<DivisionRecord>("", now.world.divisions); }},
    {"time_step",
     [](const Observation& now, const NameOf&) { return tableFrom<TimeStepChange>("", now.world.timeSteps); }},
    {"settling",
     [](const Observation& now, const NameOf&) {
       return tableFrom<SettlingRecord>("", now.world.settlings ? *now.world.settlings : std::vector<SettlingRecord>());
     }},
    {"experiment",
     [](const Observation& now, const NameOf&) {
       return numbered<ExperimentRecord>(now.world.experiments ? &*now.world.experiments : nullptr);
     }},
};

}  // namespace

DataTable worldTable(const Observation& now, std::string_view name, const NameOf& nameOf) {
  std::string known;
  for (const TableMaker& row : tables) {
    if (name == row.name) {
      DataTable table = row.make(now, nameOf);
      table.name = row.name;
      return table;
    }
    known += (known.empty() ? "" : ", ") + std::string(row.name);
  }
  throw InputError("there is no table '" + std::string(name) + "'; needs one of " + known);
}

std::vector<double> worldColumn(const Observation& now, std::span<const CellMeasures> cells, std::string_view name) {
  const auto& paths = now.world.cells.path;
  std::vector<double> values(paths.size(), std::numeric_limits<double>::quiet_NaN());
  const auto sampled = sampledMeasures<CellContext>();
  const auto row = std::find_if(sampled.begin(), sampled.end(), [&](const CellMeasure& m) { return m.name == name; });
  if (row != sampled.end()) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      values[i] = cells[i].values[std::size_t(row - sampled.begin())].value_or(values[i]);
    return values;
  }
  for (const TakenMeasure& taken : takeMeasures(now, std::vector{std::string(name)}))
    if (const int cell = cellNumber(now.world.cells, taken.a); cell >= 0) values[std::size_t(cell)] = taken.value;
  return values;
}

}  // namespace morula
