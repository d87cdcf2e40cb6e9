#include "export/csv.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "analysis/measure_words.h"
#include "base/number_text.h"
#include "files/text.h"
#include "observation/measures.h"
#include "study_store/study_tables.h"
#include "values/measure_list.h"

namespace morula {
namespace {

constexpr std::pair<const char*, const char*> ofScopes[] = {
    {"measures_world", "world"}, {"measures_cell", "cell"}, {"measures_pair", "pair"}};

std::string fieldOf(const TableValue& value) {
  if (const auto* number = std::get_if<std::int64_t>(&value)) return std::to_string(*number);
  if (const auto* text = std::get_if<std::string>(&value)) return csvField(*text);
  const auto* real = std::get_if<double>(&value);
  return real && !std::isnan(*real) ? exactText(*real) : "";
}

/// Returns the name of the column of cells' names beside a column of paths; "" beside another one.
std::string namesBeside(const std::string& column) {
  if (column == "path") return "name";
  for (const char* paths : {"parent", "a", "b", "other"})
    if (column == paths) return column + "_name";
  return {};
}

/// The names of the cells of all runs, by run and path.
using Names = std::map<std::pair<std::string, std::string>, std::string>;

std::size_t placeOf(const std::vector<std::string>& columns, const std::string& column) {
  return static_cast<std::size_t>(std::ranges::find(columns, column) - columns.begin());
}

Names namesOfCells(Store& store, const std::string& id) {
  Names names;
  const auto columns = store.columns("cell");
  const std::size_t run = placeOf(columns, "run_id"), path = placeOf(columns, "path"), name = placeOf(columns, "name");
  store.eachRow("cell", id, [&](const TableRow& row) {
    if (const auto* text = std::get_if<std::string>(&row[name]))
      names[{std::get<std::string>(row[run]), std::get<std::string>(row[path])}] = *text;
  });
  return names;
}

/// Adds a cell's path, as csvPath gives it, and its name. Where the path is missing both are.
void addCell(TableRow& row, const TableValue& run, const TableValue& path, const Names& names) {
  const auto* text = std::get_if<std::string>(&path);
  row.push_back(text ? TableValue(csvPath(*text)) : TableValue());
  const auto* id = std::get_if<std::string>(&run);
  const auto named = text && id ? names.find({*id, *text}) : names.end();
  row.push_back(named == names.end() ? TableValue() : TableValue(named->second));
}

/// Returns a column as `tables` describe it. What is NULL there is empty here.
CsvColumn described(const std::string& name, const SqlTable* table) {
  if (!namesBeside(name).empty())
    return {name, "lineage path: egg, or A and B for each division" +
                      std::string(name == "parent" ? "; empty of the egg" : "")};
  CsvColumn column{name, name == "run_id" ? "id of the run, as in runs" : ""};
  if (!table) return column;
  for (const auto* list : {&table->context, &table->own})
    for (const SqlColumn& c : *list)
      if (c.name == name) column.unit = c.unit, column.meaning = c.meaning.empty() ? column.meaning : c.meaning;
  for (std::size_t at; (at = column.meaning.find("NULL")) != std::string::npos;) column.meaning.replace(at, 4, "empty");
  if (name == "seed") column.meaning = "";  // its number is restored
  return column;
}

CsvColumn nameColumn(const std::string& paths) {
  return {namesBeside(paths), "the cell's name, as the scenario's `names` give it; empty without one"};
}

/// Returns a table's rows. Paths are written as csvPath gives them, with names beside them. Seeds from 2⁶³ on, which
/// SQLite's signed integers hold as negative numbers, are restored.
CsvTable plainTable(Store& store, const SqlTable& table, const std::string& id, const std::vector<std::string>& columns,
                    const Names& names) {
  const auto isNamed = [&](const std::string& column) {
    const std::string beside = namesBeside(column);
    return !beside.empty() && placeOf(columns, beside) == columns.size();
  };
  std::vector<CsvColumn> header;
  for (const std::string& column : columns) {
    header.push_back(described(column, &table));
    if (isNamed(column)) header.push_back(nameColumn(column));
  }
  const bool isResult = std::string_view(table.info.name) == "result";  // each row has a measure of its own
  if (isResult) header.push_back({"unit", "of the value, the scene's; empty of a pure number"});
  CsvTable csv(std::move(header));
  const std::size_t run = placeOf(columns, "run_id"), measure = placeOf(columns, "measure");
  store.eachRow(table.info.name, id, [&](const TableRow& row) {
    TableRow whole;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto* number = std::get_if<std::int64_t>(&row[i]);
      if (!namesBeside(columns[i]).empty()) {
        addCell(whole, run < row.size() ? row[run] : TableValue(), row[i], names);
        if (!isNamed(columns[i])) whole.pop_back();
      } else if (number && *number < 0 && columns[i] == "seed") {
        whole.push_back(std::to_string(static_cast<std::uint64_t>(*number)));
      } else {
        whole.push_back(row[i]);
      }
    }
    if (isResult) {
      const std::string unit = unitOfMeasure(std::get<std::string>(row[measure]));
      whole.push_back(unit.empty() ? TableValue() : TableValue(unit));
    }
    csv.add(whole);
  });
  return csv;
}

template <class Of>
void describe(const std::string& name, CsvColumn& column) {
  for (const auto& m : measures<Of>())
    if (name == m.name) column.meaning = m.meaning, column.unit = m.unit;
}

/// Returns the column of a measure as it was asked for: "volume of cell AB" has the unit of volumes.
CsvColumn measureColumn(const std::string& asked) {
  CsvColumn column{asked, ""};
  const std::string name = asked.substr(0, asked.find(" of "));
  describe<Observation>(name, column), describe<CellContext>(name, column), describe<Touch>(name, column);
  return column;
}

/// Returns the table `measure` with a row for each time and cell or pair, and a column for each measure.
std::optional<CsvTable> wideMeasures(Store& store, const std::string& scope, const std::string& id,
                                     const Names& cells) {
  const auto text = [](const TableValue& v) { return std::get<std::string>(v); };
  enum Column { run, time, scopeOf, name, a, b, value };  // columns of the table `measure`
  std::set<std::string> names;
  store.eachRow("measure", id, [&](const TableRow& r) {
    if (text(r[scopeOf]) == scope) names.insert(text(r[name]));
  });
  if (names.empty()) return {};
  std::vector<CsvColumn> columns{described("run_id", nullptr), {"time", "as in samples", "time"}};
  std::vector<std::string> paths;
  if (scope == "cell") paths = {"path"};
  if (scope == "pair") paths = {"a", "b"};
  for (const std::string& path : paths)
    columns.push_back(described(path, nullptr)), columns.push_back(nameColumn(path));
  for (const std::string& n : names) columns.push_back(measureColumn(n));
  CsvTable csv(std::move(columns));

  std::pair<std::string, double> now;  // run and time of the rows being gathered
  std::map<std::pair<std::string, std::string>, std::map<std::string, double>> rows;
  const auto write = [&] {
    for (const auto& [pair, values] : rows) {
      TableRow row{now.first, now.second};
      if (!paths.empty()) addCell(row, now.first, pair.first, cells);
      if (paths.size() > 1) addCell(row, now.first, pair.second, cells);
      for (const std::string& n : names) {
        const auto found = values.find(n);
        row.push_back(found == values.end() ? TableValue() : found->second);
      }
      csv.add(row);
    }
    rows.clear();
  };
  store.eachRow("measure", id, [&](const TableRow& r) {  // rows come by run, time, scope and name
    if (text(r[scopeOf]) != scope || !std::holds_alternative<double>(r[value])) return;
    const std::pair when(text(r[run]), std::get<double>(r[time]));
    if (when != now) write();
    now = when;
    rows[{text(r[a]), text(r[b])}][text(r[name])] = std::get<double>(r[value]);
  });
  write();
  return csv;
}

}  // namespace

std::string csvPath(const std::string& path) { return path.empty() ? "egg" : path; }

CsvTable::CsvTable(std::vector<CsvColumn> columns) : columns_(std::move(columns)) {
  TableRow names;
  for (const CsvColumn& column : columns_) names.push_back(column.name);
  add(names);
}

void CsvTable::add(const TableRow& row) {
  for (const TableValue& value : row) text_ += (&value == &row.front() ? "" : ",") + fieldOf(value);
  text_ += "\r\n";
}

Json CsvTable::columns(const Units& units) const {
  Json all = Json::object();
  for (const auto& [name, meaning, unit] : columns_) {
    std::string words = name;
    std::ranges::replace(words, '_', ' ');
    Json& column = all[name] = {{"meaning", meaning.empty() ? words : meaning}};
    column.update(unitJson(units, unit));
  }
  return all;
}

std::vector<std::string> csvTableNames() {
  std::vector<std::string> names;
  for (const SqlTable* t : allTables())
    if (*t->info.csv) names.push_back(t->info.csv);
  for (const auto& [file, scope] : ofScopes) names.push_back(file);
  return names;
}

std::vector<NamedTable> csvTables(Store& store, const std::string& id, const std::string& only) {
  std::vector<NamedTable> tables;
  const auto isWanted = [&](const std::string& name) { return only.empty() || only == name; };
  const Names names = namesOfCells(store, id);
  for (const SqlTable* t : allTables()) {
    if (!*t->info.csv || !isWanted(t->info.csv)) continue;
    const auto columns = store.columns(t->info.name);  // an existing table is written even without rows, for scripts
    if (!columns.empty()) tables.push_back({t->info.csv, plainTable(store, *t, id, columns, names)});
  }
  for (const auto& [file, scope] : ofScopes)
    if (isWanted(file))
      if (auto table = wideMeasures(store, scope, id, names)) tables.push_back({file, std::move(*table)});
  return tables;
}

}  // namespace morula
