#pragma once
// Functions that read and change databases that the program has written.
#include <set>
#include <string>

#include "catch.h"
#include "database/database.h"
#include "reseal.h"

namespace morula::test {

/// Runs statements, or one statement with a value for each of its parameters. Then renews the rows' digests, so that
/// tests reach the other checks of readers.
template <class... Values>
void change(const std::string& file, const std::string& sql, const Values&... values) {
  {
    Database db = opened(file);
    if constexpr (sizeof...(values) == 0) db.execute(sql);
    else Statement(db, sql).run(values...);
  }
  reseal(file);
}

/// Return the first column of the first row.
inline std::int64_t integerIn(const std::string& file, const std::string& sql) { return opened(file).integer(sql); }
inline double realIn(const std::string& file, const std::string& sql) {
  Database db = opened(file);
  Statement row(db, sql);
  REQUIRE(row.next());
  return row.real(0);
}

/// Returns the rows of all tables, or of one run, sorted, without these tables and columns.
inline std::string rowsAsText(const std::string& file, const std::set<std::string>& tablesLeftOut,
                              const std::set<std::string>& columnsLeftOut, const std::string& run = "") {
  Database db = opened(file);
  std::string text;
  Statement tables(db, "SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name");
  while (tables.next()) {
    const std::string table = tables.text(0);
    if (tablesLeftOut.contains(table)) continue;
    std::string columns;
    Statement names(db, "SELECT name FROM pragma_table_info(?)");
    for (names.start(table); names.next();)
      if (!columnsLeftOut.contains(names.text(0)))
        columns += (columns.empty() ? "" : " || '|' || ") + ("quote(\"" + names.text(0) + "\")");
    text += "== " + table + "\n";
    const std::string of = run.empty() ? "" : " WHERE run_id = '" + run + "'";
    for (Statement rows(db, "SELECT " + columns + " AS r FROM " + table + of + " ORDER BY r"); rows.next();)
      text += rows.text(0) + "\n";
  }
  return text;
}

}  // namespace morula::test
