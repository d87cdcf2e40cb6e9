#include "database/record_table.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "files/text.h"

namespace morula {

std::vector<std::string> columnNames(Database& db, const std::string& table) {
  std::vector<std::string> names;
  Statement s(db, "SELECT name FROM pragma_table_info(?)");
  for (s.start(table); s.next();) names.push_back(s.text(0));
  return names;
}

SqlColumn columnFor(const FieldInfo& field, const std::string& type, bool mayBeNull) {
  const std::string name = sqlName(field.name);
  SqlColumn column{field.name, type + (mayBeNull ? "" : " NOT NULL"), field.meaning, field.unit};
  // A chain of comparisons, since for an IN of several values SQLite makes a table anew for each row, which takes as
  // long as storing the row.
  std::string checks;
  const std::string names = field.oneOf;  // a name may be empty, as the first in " divided died"
  for (std::size_t begin = 0, end = 0; !names.empty() && end != names.npos; begin = end + 1) {
    end = names.find(' ', begin);
    const std::string word = names.substr(begin, end == names.npos ? end : end - begin);
    checks += (checks.empty() ? "" : " OR ") + name + " = '" + word + "'";
  }
  if (!checks.empty()) column.type += " CHECK (" + checks + ")";
  if (*field.refersTo) column.type += std::string(" REFERENCES ") + field.refersTo + " ON DELETE CASCADE";
  return column;
}

std::vector<SqlColumn> contextColumns(const TableInfo& info) {
  static const FieldInfo known[] = {{.name = "run_id", .refersTo = "run"},
                                    {.name = "time", .meaning = "as in sample", .unit = "time"},
                                    {.name = "step"},
                                    {.name = "number", .meaning = "in their order"},
                                    {.name = "task_id"}};
  std::vector<SqlColumn> columns;
  for (const std::string& name : wordsOf(info.context)) {
    const auto* field = std::find_if(std::begin(known), std::end(known), [&](auto& f) { return f.name == name; });
    MORULA_CHECK(field != std::end(known), name);
    const bool isText = name.ends_with("_id");
    columns.push_back(columnFor(*field, isText ? "TEXT" : name == "time" ? "REAL" : "INTEGER", false));
  }
  return columns;
}

// Key columns come first: SQLite 3.40's integrity check misreads other tables WITHOUT ROWID.
std::string SqlTable::create(bool withComments) const {
  std::string sql = "CREATE TABLE " + sqlName(info.name) + " (";
  for (const auto* columns : {&context, &own})
    for (const SqlColumn& c : *columns) {
      sql += "\n  " + sqlName(c.name) + " " + c.type + ",";
      if (!withComments || c.isMeasure) continue;  // MEASURES.md describes measures
      if (!c.meaning.empty() || !c.unit.empty()) sql += "  --";
      if (!c.meaning.empty()) sql += " " + c.meaning;
      if (!c.unit.empty()) sql += " [" + c.unit + "]";
    }
  return sql + "\n  PRIMARY KEY (" + info.key + ")\n) STRICT" + (info.hasRowNumbers ? "" : ", WITHOUT ROWID");
}

std::string SqlTable::names() const {
  std::string names;
  for (const auto* columns : {&context, &own})
    for (const SqlColumn& c : *columns) names += (names.empty() ? "" : ", ") + sqlName(c.name);
  return names;
}

std::string SqlTable::insert() const {
  std::string places;
  for (std::size_t i = 0; i < context.size() + own.size(); ++i) places += i ? ", ?" : "?";
  return "INSERT INTO " + sqlName(info.name) + " (" + names() + ") VALUES (" + places + ")";
}

std::string SqlTable::select(Database& db, const std::string& where, const std::string& order) const {
  const auto there = columnNames(db, info.name);
  const std::set<std::string> known(there.begin(), there.end());
  std::string names, conditions = where;
  for (const SqlColumn& c : own)
    names += (names.empty() ? "" : ", ") + std::string(c.isMeasure && !known.contains(c.name) ? "NULL AS " : "") +
             sqlName(c.name);
  for (const std::string& key : wordsOf(info.context))
    if (key != "number") conditions += (conditions.empty() ? "" : " AND ") + key + " = ?";
  return "SELECT " + names + " FROM " + sqlName(info.name) + (conditions.empty() ? "" : " WHERE " + conditions) +
         " ORDER BY " +
         (!order.empty() ? order
          : *info.order  ? info.order
                         : info.key);
}

}  // namespace morula
