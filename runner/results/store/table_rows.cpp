#include "store/table_rows.h"

#include <algorithm>

#include "database/database.h"

namespace morula {

namespace {

struct Column {
  std::string name, type;
  std::int64_t key = 0;  // its place in the table's key, from 1; 0: no part of it
};

std::vector<Column> columnsInOrder(Database& db, const std::string& table) {
  std::vector<Column> columns;
  Statement s(db, "SELECT name, type, pk FROM pragma_table_info(?) ORDER BY cid");
  for (s.start(table); s.next();)
    if (Column c{s.line(0), s.line(1), s.integer(2)}; c.type != "BLOB") columns.push_back(std::move(c));
  return columns;
}

std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + '"';
}

TableValue read(const Statement& s, int place, const std::string& type) {
  if (s.isNull(place)) return {};
  if (type == "INTEGER" || type == "INT") return s.integer(place);
  if (type == "REAL") return s.real(place);
  return s.text(place);
}

}  // namespace

std::vector<std::string> columnNames(Database& db, const std::string& table) {
  std::vector<std::string> names;
  for (Column& c : columnsInOrder(db, table)) names.push_back(std::move(c.name));
  return names;
}

void eachRow(Database& db, const std::string& table, const std::string& run,
             const std::function<void(const TableRow&)>& take) {
  const auto columns = columnsInOrder(db, table);
  if (columns.empty()) return;
  std::string names;
  for (const Column& c : columns) names += (names.empty() ? "" : ", ") + quoted(c.name);
  auto key = columns;
  std::erase_if(key, [](const Column& c) { return c.key == 0; });
  std::ranges::sort(key, {}, &Column::key);
  std::string order;
  for (const Column& c : key) order += (order.empty() ? " ORDER BY " : ", ") + quoted(c.name);
  const bool one = !run.empty() && std::ranges::find(columns, "run_id", &Column::name) != columns.end();
  Statement s(db, "SELECT " + names + " FROM " + quoted(table) + (one ? " WHERE run_id = ?" : "") + order);
  if (one) s.start(run);
  TableRow row(columns.size());
  while (s.next()) {
    for (std::size_t i = 0; i < columns.size(); ++i) row[i] = read(s, static_cast<int>(i), columns[i].type);
    take(row);
  }
}

}  // namespace morula
