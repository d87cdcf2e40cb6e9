#include "export/csv.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/number_text.h"
#include "files/text.h"
#include "study_store/study_tables.h"

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

bool holdsPaths(const std::string& column) {
  return column == "path" || column == "parent" || column == "a" || column == "b";
}

/// Returns a table's rows as CSV. Paths are written as csvPath gives them. Seeds from 2⁶³ on, which SQLite's signed
/// integers hold as negative numbers, are restored.
std::string plainTable(Store& store, const std::string& table, const std::string& id,
                       const std::vector<std::string>& columns) {
  CsvTable csv(columns);
  store.eachRow(table, id, [&](const TableRow& row) {
    TableRow whole = row;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (auto* text = std::get_if<std::string>(&whole[i]); text && holdsPaths(columns[i])) *text = csvPath(*text);
      const auto* number = std::get_if<std::int64_t>(&whole[i]);
      if (number && *number < 0 && columns[i] == "seed") whole[i] = std::to_string(static_cast<std::uint64_t>(*number));
    }
    csv.add(whole);
  });
  return csv.text();
}

/// Returns the table `measure` with a row for each time and cell or pair, and a column for each measure.
std::optional<std::string> wideMeasures(Store& store, const std::string& scope, const std::string& id) {
  const auto text = [](const TableValue& v) { return std::get<std::string>(v); };
  enum Column { run, time, scopeOf, name, a, b, value };  // columns of the table `measure`
  std::set<std::string> names;
  store.eachRow("measure", id, [&](const TableRow& r) {
    if (text(r[scopeOf]) == scope) names.insert(text(r[name]));
  });
  if (names.empty()) return {};
  std::vector<std::string> columns{"run_id", "time"};
  if (scope == "cell") columns.push_back("path");
  if (scope == "pair") columns.insert(columns.end(), {"a", "b"});
  const std::size_t keys = columns.size();
  columns.insert(columns.end(), names.begin(), names.end());
  CsvTable csv(columns);

  std::pair<std::string, double> now;  // run and time of the rows being gathered
  std::map<std::pair<std::string, std::string>, std::map<std::string, double>> rows;
  const auto write = [&] {
    for (const auto& [cells, values] : rows) {
      TableRow row{now.first, now.second};
      if (keys > 2) row.push_back(csvPath(cells.first));
      if (keys > 3) row.push_back(csvPath(cells.second));
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
  return csv.text();
}

}  // namespace

std::string csvPath(const std::string& path) { return path.empty() ? "egg" : path; }

void CsvTable::add(const TableRow& row) {
  for (const TableValue& value : row) text_ += (&value == &row.front() ? "" : ",") + fieldOf(value);
  text_ += "\r\n";
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
  for (const SqlTable* t : allTables()) {
    if (!*t->info.csv || !isWanted(t->info.csv)) continue;
    const auto columns = store.columns(
        t->info.name);  // an existing table is written even without rows, for scripts
    if (!columns.empty()) tables.push_back({t->info.csv, plainTable(store, t->info.name, id, columns)});
  }
  for (const auto& [file, scope] : ofScopes)
    if (isWanted(file))
      if (auto text = wideMeasures(store, scope, id)) tables.push_back({file, std::move(*text)});
  return tables;
}

}  // namespace morula
