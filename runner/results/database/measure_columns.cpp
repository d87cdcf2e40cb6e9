#include "database/measure_columns.h"

#include <algorithm>
#include <set>

namespace morula {

namespace {

struct MeasureTable {
  const char* name;
  std::vector<MeasureColumn> columns;
};

std::vector<MeasureTable> measureTables() {
  return {{"sample", columnsOf<Observation>()},
          {"cell_sample", columnsOf<CellContext>()},
          {"contact", columnsOf<Touch>()},
          {"bullet_sample", bulletColumns()}};
}

std::set<std::string> columnsIn(Database& db, const std::string& table) {
  std::set<std::string> names;
  Statement s(db, "SELECT name FROM pragma_table_info(?)");
  for (s.start(table); s.next();) names.insert(s.text(0));
  return names;
}

}  // namespace

std::vector<MeasureColumn> bulletColumns() {
  std::vector<MeasureColumn> columns = columnsOf<CellContext>();
  const auto rows = sampledMeasures<CellContext>();
  std::erase_if(columns, [&](const MeasureColumn& c) { return rows[c.place].needs != Needs::bodies; });
  return columns;
}

std::string insertInto(const std::string& table, const std::string& keys,
                       const std::vector<MeasureColumn>& columns) {
  std::string names = keys, values = "?";
  for (const char c : keys)
    if (c == ',') values += ", ?";
  for (const MeasureColumn& c : columns) names += std::string(", ") + c.name, values += ", ?";
  return "INSERT INTO " + table + " (" + names + ") VALUES (" + values + ")";
}

BoundNumbers valuesOf(const std::vector<std::optional<double>>& values,
                      const std::vector<MeasureColumn>& columns) {
  BoundNumbers bound;
  for (const MeasureColumn& c : columns) bound.numbers.push_back({values[c.place], c.isWhole});
  return bound;
}

std::string selected(Database& db, const std::string& table, const std::vector<MeasureColumn>& columns) {
  const std::set<std::string> there = columnsIn(db, table);
  std::string names;
  for (const MeasureColumn& c : columns)
    names += std::string(names.empty() ? "" : ", ") + (there.contains(c.name) ? "" : "NULL AS ") + c.name;
  return names;
}

void readValues(const Statement& row, int from, const std::vector<MeasureColumn>& columns,
                std::vector<std::optional<double>>& values) {
  for (const MeasureColumn& c : columns) {
    const int column = from++;
    if (row.isNull(column)) continue;
    values[c.place] = c.isWhole ? static_cast<double>(row.natural(column)) : row.real(column);
  }
}

bool hasMeasureColumns(Database& db) {
  for (const auto& [table, columns] : measureTables()) {
    const std::set<std::string> there = columnsIn(db, table);
    if (!std::ranges::all_of(columns, [&](const MeasureColumn& c) { return there.contains(c.name); }))
      return false;
  }
  return true;
}

void addMeasureColumns(Database& db) {
  for (const auto& [table, columns] : measureTables()) {
    const std::set<std::string> there = columnsIn(db, table);
    for (const MeasureColumn& c : columns)
      if (!there.contains(c.name))
        db.execute(std::string("ALTER TABLE ") + table + " ADD COLUMN " + c.name +
                   (c.isWhole ? " INTEGER" : " REAL"));
  }
}

}  // namespace morula
