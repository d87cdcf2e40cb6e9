#pragma once
// Functions that read and change databases that the program has written.
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

}  // namespace morula::test
