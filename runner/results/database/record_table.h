#pragma once
// Tables of records: columns, statements and rows from a record's one list of fields [base/record.h].
#include <string>
#include <vector>

#include "database/database.h"
#include "files/text.h"

namespace morula {

/// The part of a run that a table's rows belong to.
enum class TablePart {
  record,      // the run itself, and the documents that decided it
  samples,     // recorded while it goes on
  hashes,      // of states on the way; they find the first step in which two runs differ
  end,         // known when it has ended
  checks,      // what was found in it
  against,     // how far it is from measured cells
  bullet,      // what Bullet made of its scene
  checkpoint,  // what it goes on from; gone when it has finished
  study,       // of the study that it belongs to
  seal,        // digests of the rows of the others
};

inline bool isResult(TablePart part) {
  return part == TablePart::samples || part == TablePart::hashes || part == TablePart::end || part == TablePart::checks;
}
/// Returns true for tables whose rows join the file while the run goes on.
inline bool growsDuringRun(TablePart part) { return part == TablePart::samples || part == TablePart::hashes; }

/// The description of a table, given once beside the list of fields of its rows as tableInfo<Row>.
struct TableInfo {
  const char* name;
  TablePart part;
  const char* context = "";    // columns before the row's own, bound as parameters: "run_id number"
  const char* key = "";        // "run_id, number"
  const char* order = "";      // the order in which rows are read; "": by the key
  bool hasRowNumbers = false;  // for long rows: without row numbers few fit on a page of SQLite's
  const char* csv = "";        // the name of its file in exports; "": not exported as it stands
  const char* why = "";        // the readers of the table, and when it is stored
};
template <class Row>
inline constexpr TableInfo tableInfo = {};

struct SqlColumn {
  std::string name, type, meaning, unit;  // unit: "time"; "": a pure number, or none
  bool isMeasure = false;  // a measure that joined later: an older file may lack it
};

struct SqlTable {
  TableInfo info;
  std::vector<SqlColumn> context, own;

  /// Returns the statement that makes the table, by default with a comment on each column, for `.schema`.
  std::string create(bool withComments = true) const;
  /// Returns the names of all columns, in the order of `insert`.
  std::string names() const;
  std::string insert() const;
  /// Returns the statement that reads the row's own columns; the context's values are its parameters. A measure that an
  /// older file lacks reads as NULL. `where`: a further condition. `order`: replaces TableInfo's.
  std::string select(Database& db, const std::string& where = "", const std::string& order = "") const;
};

std::vector<std::string> columnNames(Database& db, const std::string& table);

/// Returns the columns of the context. Throws BugError for an unknown name.
std::vector<SqlColumn> contextColumns(const TableInfo& info);

/// Returns a column as SQL declares it.
SqlColumn columnFor(const FieldInfo& field, const std::string& type, bool mayBeNull);

template <class E>
std::string namesToChoose() {
  std::string names;
  for (const auto& row : choices<E>) names += (&row == &choices<E>.front() ? "" : " ") + std::string(row.name);
  return names;
}

/// Adds the columns that hold a member; most members have one.
template <class Member>
void addColumns(std::vector<SqlColumn>& list, FieldInfo field, const Member& member, bool mayBeNull = false) {
  const auto add = [&](const char* type) { list.push_back(columnFor(field, type, mayBeNull)); };
  if constexpr (IsMeasures<Member>) {
    member.each([&](const auto& measure, std::size_t) {
      list.push_back({measure.name, measure.isWhole ? "INTEGER" : "REAL", measure.meaning, measure.unit, true});
    });
  } else if constexpr (requires { member.isAbsent; }) {
    addColumns(list, field, member.of, true);
  } else if constexpr (IsOptional<Member>) {
    addColumns(list, field, typename Member::value_type{}, true);
  } else if constexpr (std::same_as<Member, Vector>) {
    for (const char* axis : {"_x", "_y", "_z"}) {
      const std::string name = std::string(field.name) + axis;
      list.push_back(columnFor({name.c_str(), field.meaning, field.unit}, "REAL", mayBeNull));
    }
  } else if constexpr (HasChoices<Member>) {
    const std::string names = namesToChoose<Member>();
    field.oneOf = names.c_str();
    add("TEXT");
  } else if constexpr (IsTemplate<Member, AnyReal>) {
    mayBeNull = true;
    add("REAL");
  } else if constexpr (std::same_as<Member, bool>) {
    list.push_back(columnFor(field, "INTEGER", mayBeNull));
    list.back().type += " CHECK (" + sqlName(field.name) + " IN (0, 1))";
  } else if constexpr (std::floating_point<Member>) {
    add("REAL");
  } else if constexpr (std::integral<Member> || IsTemplate<Member, AllBits>) {
    add("INTEGER");
  } else if constexpr (IsTemplate<Member, BytesOf>) {
    add("BLOB");
  } else {
    add("TEXT");
  }
}

/// Returns the table whose rows are `Row`s.
template <Record Row>
const SqlTable& sqlTable() {
  static const SqlTable made = [] {
    SqlTable t{tableInfo<Row>, contextColumns(tableInfo<Row>), {}};
    const Row row{};
    listFields(row, [&](const FieldInfo& field, const auto& member) { addColumns(t.own, field, member); });
    return t;
  }();
  return made;
}

/// Returns the rows with these values of the context, which is a run's id for most tables.
template <Record Row, class... Context>
std::vector<Row> rowsOf(Database& db, const std::string& where, const Context&... context) {
  std::vector<Row> rows;
  Statement s(db, sqlTable<Row>().select(db, where));
  for (s.start(context...); s.next();) rows.push_back(s.row<Row>());
  return rows;
}

}  // namespace morula
