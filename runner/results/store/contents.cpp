// The tables of a file: names, columns, sizes and values.
#include <algorithm>
#include <map>

#include "database/record_table.h"
#include "database/store_error.h"
#include "store/store.h"

namespace morula {
namespace {

/// Returns the size of the pages of each table and its indices [byte]; empty if this SQLite cannot count them.
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

/// Returns the size of all rows' values [byte], each as SQLite would write it as text or bytes.
std::uint64_t lengthOf(Database& db, const std::string& table, const std::vector<std::string>& columns) {
  std::string sum;
  for (const std::string& c : columns)
    sum += (sum.empty() ? "" : " + ") + ("ifnull(length(CAST(" + sqlName(c) + " AS BLOB)), 0)");
  return static_cast<std::uint64_t>(db.integer("SELECT ifnull(sum(" + sum + "), 0) FROM " + sqlName(table)));
}

std::vector<FileColumn> plainColumns(Database& db, const std::string& table) {
  auto columns = fileColumns(db, table);
  std::erase_if(columns, [](const FileColumn& c) { return c.type == "BLOB"; });
  return columns;
}

}  // namespace

std::vector<std::string> tableNames(Database& db) {
  std::vector<std::string> names;
  Statement s(db, "SELECT name FROM sqlite_schema WHERE type = 'table' AND name NOT LIKE 'sqlite%' ORDER BY rowid");
  while (s.next()) names.push_back(s.text(0));
  return names;
}

std::vector<FileColumn> fileColumns(Database& db, const std::string& table) {
  std::vector<FileColumn> columns;
  Statement s(db, "SELECT name, type, pk FROM pragma_table_info(?) ORDER BY cid");
  for (s.start(table); s.next();) columns.push_back({s.line(0), s.line(1), s.integer(2)});
  return columns;
}

std::string namesOf(const std::vector<FileColumn>& columns) {
  std::string names;
  for (const FileColumn& c : columns) names += (names.empty() ? "" : ", ") + sqlName(c.name);
  return names;
}

TableValue valueAt(const Statement& row, int place, const std::string& type) {
  if (row.isNull(place)) return {};
  if (type == "INTEGER" || type == "INT") return row.integer(place);
  if (type == "REAL") return row.real(place);
  return row.text(place);
}

std::vector<TableContents> Store::contents(const std::vector<const SqlTable*>& known, const std::string& id) {
  const auto pages = pagesOf(db_);

  std::vector<TableContents> list;
  for (const std::string& table : tableNames(db_)) {
    TableContents& t = list.emplace_back();
    const std::vector<std::string> columns = columnNames(db_, table);
    t.table = table;
    for (const SqlTable* k : known)
      if (k->info.name == table) t.why = k->info.why;
    const auto all = static_cast<std::uint64_t>(db_.integer("SELECT count(*) FROM " + sqlName(table)));
    t.rows = all;
    const auto measured = pages.find(table);
    t.estimated = measured == pages.end();
    t.bytes = t.estimated ? lengthOf(db_, table, columns) : measured->second;
    const bool ofRuns = table == "document" || std::ranges::find(columns, "run_id") != columns.end();
    if (id.empty() || !ofRuns) continue;
    Statement count(db_, table == "document" ? "SELECT count(DISTINCT hash) FROM run_document WHERE run_id = ?"
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

std::vector<std::string> Store::columns(const std::string& table) {
  std::vector<std::string> names;
  for (FileColumn& c : plainColumns(db_, table)) names.push_back(std::move(c.name));
  return names;
}

void Store::eachRow(const std::string& table, const std::string& id, const std::function<void(const TableRow&)>& take) {
  const auto columns = plainColumns(db_, table);
  if (columns.empty()) return;
  auto key = columns;
  std::erase_if(key, [](const FileColumn& c) { return c.key == 0; });
  std::ranges::sort(key, {}, &FileColumn::key);
  const bool one = !id.empty() && std::ranges::find(columns, "run_id", &FileColumn::name) != columns.end();
  Statement s(db_, "SELECT " + namesOf(columns) + " FROM " + sqlName(table) + (one ? " WHERE run_id = ?" : "") +
                       (key.empty() ? "" : " ORDER BY " + namesOf(key)));
  if (one) s.start(id);
  TableRow row(columns.size());
  while (s.next()) {
    for (std::size_t i = 0; i < columns.size(); ++i) row[i] = valueAt(s, static_cast<int>(i), columns[i].type);
    take(row);
  }
}

}  // namespace morula
