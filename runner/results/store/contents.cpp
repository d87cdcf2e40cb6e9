#include "store/contents.h"

#include <algorithm>
#include <map>

#include "database/record_table.h"
#include "database/store_error.h"

namespace morula {
namespace {

/// [byte] Pages of each table and of its indices; empty where this SQLite does not count them.
std::map<std::string, std::uint64_t> pagesOf(Database& db) {
  std::map<std::string, std::uint64_t> bytes;
  try {
    Statement s(db,
                "SELECT tbl_name, sum(pgsize) FROM dbstat JOIN sqlite_schema USING (name) WHERE aggregate = 1 "
                "GROUP BY tbl_name");
    while (s.next()) bytes[s.text(0)] = s.natural(1);
  } catch (const StoreError&) { bytes.clear(); }
  return bytes;
}

/// [byte] The values of all rows, each as SQLite would write it as text or bytes.
std::uint64_t lengthOf(Database& db, const std::string& table, const std::vector<std::string>& columns) {
  std::string sum;
  for (const std::string& c : columns)
    sum += (sum.empty() ? "" : " + ") + ("ifnull(length(CAST(" + sqlName(c) + " AS BLOB)), 0)");
  return static_cast<std::uint64_t>(db.integer("SELECT ifnull(sum(" + sum + "), 0) FROM " + sqlName(table)));
}

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

std::vector<TableContents> contentsOf(Database& db, const std::string& id, const std::vector<const SqlTable*>& known) {
  std::vector<std::string> tables;
  Statement names(db, "SELECT name FROM sqlite_schema WHERE type = 'table' AND name NOT LIKE 'sqlite%' ORDER BY rowid");
  while (names.next()) tables.push_back(names.text(0));
  const auto pages = pagesOf(db);

  std::vector<TableContents> list;
  for (const std::string& table : tables) {
    TableContents& t = list.emplace_back();
    const std::vector<std::string> columns = columnNames(db, table);
    t.table = table;
    for (const SqlTable* k : known)
      if (k->info.name == table) t.why = k->info.why;
    const auto all = static_cast<std::uint64_t>(db.integer("SELECT count(*) FROM " + sqlName(table)));
    t.rows = all;
    const auto measured = pages.find(table);
    t.estimated = measured == pages.end();
    t.bytes = t.estimated ? lengthOf(db, table, columns) : measured->second;
    const bool ofRuns = table == "document" || std::ranges::find(columns, "run_id") != columns.end();
    if (id.empty() || !ofRuns) continue;
    Statement count(db, table == "document" ? "SELECT count(DISTINCT hash) FROM run_document WHERE run_id = ?"
                                            : "SELECT count(*) FROM " + sqlName(table) + " WHERE run_id = ?");
    count.start(id).next();
    t.rows = count.natural(0);
    if (t.rows == all) continue;
    t.bytes = static_cast<std::uint64_t>(static_cast<double>(t.bytes) * static_cast<double>(t.rows) /
                                         static_cast<double>(all));
    t.estimated = true;
  }
  return list;
}

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
