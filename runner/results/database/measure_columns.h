#pragma once
// The columns of sample, cell_sample, contact and bullet_sample that hold measures: one for each row of the
// tables in simulation/measures.h, under its name.
#include <string>
#include <vector>

#include "database/database.h"
#include "simulation/measures.h"

namespace morula {

/// A measure's column.
struct MeasureColumn {
  std::size_t place;  // in Measured::values
  const char* name;
  bool isWhole;  // INTEGER, else REAL
};

template <class Of>
std::vector<MeasureColumn> columnsOf() {
  std::vector<MeasureColumn> columns;
  for (const Measure<Of>& m : sampledMeasures<Of>()) columns.push_back({columns.size(), m.name, m.isWhole});
  return columns;
}
/// Of a cell in Bullet: what is seen of its body alone.
std::vector<MeasureColumn> bulletColumns();

/// "INSERT INTO table (keys, columns) VALUES (?, …)"; keys separated by commas.
std::string insertInto(const std::string& table, const std::string& keys,
                       const std::vector<MeasureColumn>& columns = {});

/// The values of these columns, to be bound one after the other.
BoundNumbers valuesOf(const std::vector<std::optional<double>>& values,
                      const std::vector<MeasureColumn>& columns);
template <class Of>
BoundNumbers valuesOf(const Measured<Of>& m, const std::vector<MeasureColumn>& columns) {
  return valuesOf(m.values, columns);
}

/// Names to select, from column number `from` of the rows on; NULL for those that an older file does not
/// have.
std::string selected(Database& db, const std::string& table, const std::vector<MeasureColumn>& columns);
/// Reads them back, the first from column number `from`.
void readValues(const Statement& row, int from, const std::vector<MeasureColumn>& columns,
                std::vector<std::optional<double>>& values);

/// True if a file has a column for each measure.
bool hasMeasureColumns(Database& db);
/// Adds those that it does not have.
void addMeasureColumns(Database& db);

}  // namespace morula
