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

}  // namespace morula
