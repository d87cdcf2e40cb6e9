#pragma once
// Databases that the program has written, read and changed from outside.
#include "catch.h"
#include "database/database.h"
#include "reseal.h"

namespace morula::test {

/// Statements; or one statement, and a value for each of its parameters. Rows fit their digests afterwards, so that
/// what else guards a reader is tested.
template <class... Values>
void change(const std::string& file, const std::string& sql, const Values&... values) {
  {
    Database db = opened(file);
    if constexpr (sizeof...(values) == 0) db.execute(sql);
    else Statement(db, sql).run(values...);
  }
  reseal(file);
}

/// The first column of the first row.
inline std::int64_t integerIn(const std::string& file, const std::string& sql) { return opened(file).integer(sql); }
inline double realIn(const std::string& file, const std::string& sql) {
  Database db = opened(file);
  Statement row(db, sql);
  REQUIRE(row.next());
  return row.real(0);
}

}  // namespace morula::test
