#include "store/table_rows.h"

#include <algorithm>

#include "database/record_table.h"

namespace morula {
namespace {

struct PlainColumn {
  std::string name, type;
  std::int64_t key = 0;  // its place in the table's key, from 1; 0: no part of it
};

std::vector<PlainColumn> plainColumnsOf(Database& db, const std::string& table) {
  std::vector<PlainColumn> columns;
  Statement s(db, "SELECT name, type, pk FROM pragma_table_info(?) ORDER BY cid");
  for (s.start(table); s.next();)
    if (PlainColumn c{s.line(0), s.line(1), s.integer(2)}; c.type != "BLOB") columns.push_back(std::move(c));
  return columns;
}

TableValue read(const Statement& s, int place, const std::string& type) {
  if (s.isNull(place)) return {};
  if (type == "INTEGER" || type == "INT") return s.integer(place);
  if (type == "REAL") return s.real(place);
  return s.text(place);
}

}  // namespace

std::vector<std::string> plainColumns(Database& db, const std::string& table) {
  std::vector<std::string> names;
  for (PlainColumn& c : plainColumnsOf(db, table)) names.push_back(std::move(c.name));
  return names;
}

void eachRow(Database& db, const std::string& table, const std::string& run,
             const std::function<void(const TableRow&)>& take) {
  const auto columns = plainColumnsOf(db, table);
  if (columns.empty()) return;
  std::string names;
  for (const PlainColumn& c : columns) names += (names.empty() ? "" : ", ") + sqlName(c.name);
  auto key = columns;
  std::erase_if(key, [](const PlainColumn& c) { return c.key == 0; });
  std::ranges::sort(key, {}, &PlainColumn::key);
  std::string order;
  for (const PlainColumn& c : key) order += (order.empty() ? " ORDER BY " : ", ") + sqlName(c.name);
  const bool one = !run.empty() && std::ranges::find(columns, "run_id", &PlainColumn::name) != columns.end();
  Statement s(db, "SELECT " + names + " FROM " + sqlName(table) + (one ? " WHERE run_id = ?" : "") + order);
  if (one) s.start(run);
  TableRow row(columns.size());
  while (s.next()) {
    for (std::size_t i = 0; i < columns.size(); ++i) row[i] = read(s, static_cast<int>(i), columns[i].type);
    take(row);
  }
}

}  // namespace morula
