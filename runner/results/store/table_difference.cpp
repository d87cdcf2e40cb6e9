#include "store/table_difference.h"

#include <charconv>
#include <cstring>

#include "base/hash.h"
#include "store/run_tables.h"

namespace morula {
namespace {

struct TypedColumn {
  std::string name, type;  // TEXT, INTEGER, REAL or BLOB: the tables are STRICT
};

/// How rows of a table are found and ordered, and what of them is compared.
struct Form {
  std::string table;
  std::vector<TypedColumn> key, values;
  std::string where = "run_id = ?";
};

/// A key that holds across two files: numbers of rows are given anew where other rows stand between.
const char* naturalKey(const std::string& table) { return table == "check_result" ? "kind check" : nullptr; }

/// Of the row `run`: what the computation decides. The rest says where and when it was made.
bool isDecided(const std::string& column) {
  return partOf(column) == RunPart::result || partOf(column) == RunPart::scene;
}

Form formOf(Database& db, const std::string& table) {
  Form form{table, {}, {}};
  const char* natural = naturalKey(table);
  const auto isIn = [](const std::string& list, const std::string& word) {
    return (' ' + list + ' ').find(' ' + word + ' ') != std::string::npos;
  };
  Statement s(db, "SELECT name, type, pk FROM pragma_table_info(?) ORDER BY cid");
  for (s.start(table); s.next();) {
    const TypedColumn column{s.text(0), s.text(1)};
    if (column.name == "run_id") continue;
    const bool isKey = natural ? isIn(natural, column.name) : s.integer(2) > 0;
    if (isKey) form.key.push_back(column);
    else if (s.integer(2) > 0) continue;  // the number that stands in for a key
    else if (table != "run" || isDecided(column.name)) form.values.push_back(column);
  }
  if (table == "check_result") form.where += " AND kind NOT IN ('golden', 'bullet')";
  return form;
}

struct Value {
  enum class Kind { null, integer, real, bytes, blob } kind = Kind::null;
  std::int64_t integer = 0;
  double real = 0;
  std::string bytes;
};

bool same(const Value& a, const Value& b) {
  return a.kind == b.kind && a.integer == b.integer && a.bytes == b.bytes &&
         std::memcmp(&a.real, &b.real, sizeof a.real) == 0;
}

/// In SQLite's order.
int compare(const Value& a, const Value& b) {
  const auto order = [](const auto& x, const auto& y) { return x < y ? -1 : y < x ? 1 : 0; };
  if (a.kind != b.kind) return order(a.kind, b.kind);
  if (a.kind == Value::Kind::real) return order(a.real, b.real);
  return a.kind >= Value::Kind::bytes ? order(a.bytes, b.bytes) : order(a.integer, b.integer);
}

std::string valueText(const Value& v) {
  if (v.kind == Value::Kind::null) return "nothing";
  if (v.kind == Value::Kind::bytes) return "'" + v.bytes + "'";
  if (v.kind == Value::Kind::blob)
    return std::to_string(v.bytes.size()) + " bytes with the hash " + Hasher().add(v.bytes).digest().text();
  if (v.kind == Value::Kind::integer) return std::to_string(v.integer);
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, v.real).ptr};
}

/// The rows of one run in one table, in the order of its key.
class Rows {
 public:
  Rows(Database& db, const Form& form, const std::string& id) : form_(form), statement_(db, query(form)) {
    statement_.start(id);
    advance();
  }

  bool ended() const { return ended_; }
  void advance() {
    ended_ = !statement_.next();
    row_.clear();
    if (ended_) return;
    ++count_;
    int place = 0;
    for (const auto* columns : {&form_.key, &form_.values})
      for (const TypedColumn& c : *columns) row_.push_back(read(place++, c.type));
  }
  std::uint64_t count() const { return count_; }
  const std::vector<Value>& values() const { return row_; }

 private:
  static std::string query(const Form& form) {
    std::string columns, keys;
    for (const auto* list : {&form.key, &form.values})
      for (const TypedColumn& c : *list) columns += (columns.empty() ? "" : ", ") + sqlName(c.name);
    for (const TypedColumn& c : form.key) keys += (keys.empty() ? " ORDER BY " : ", ") + sqlName(c.name);
    return "SELECT " + columns + " FROM " + sqlName(form.table) + " WHERE " + form.where + keys;
  }

  Value read(int place, const std::string& type) const {
    Value v;
    if (statement_.isNull(place)) return v;
    if (type == "REAL") v.kind = Value::Kind::real, v.real = statement_.real(place);
    else if (type == "INTEGER") v.kind = Value::Kind::integer, v.integer = statement_.integer(place);
    else v.kind = type == "BLOB" ? Value::Kind::blob : Value::Kind::bytes, v.bytes = statement_.text(place);
    return v;
  }

  const Form& form_;
  Statement statement_;
  bool ended_ = false;
  std::uint64_t count_ = 0;
  std::vector<Value> row_;  // the key's values first
};

std::string rowText(const Form& form, const std::vector<Value>& row) {
  std::string words;
  for (std::size_t i = 0; i < form.key.size(); ++i)
    words += (i ? ", " : "") + form.key[i].name + ' ' +
             (row[i].kind == Value::Kind::bytes && !row[i].bytes.empty() ? row[i].bytes : valueText(row[i]));
  return words;
}

TableDifference compareTable(const Form& form, Database& stored, const std::string& id, Database& again,
                             const std::string& idAgain) {
  Rows a(stored, form, id), b(again, form, idAgain);
  TableDifference found{.table = form.table, .first = {}};
  const auto note = [&](const std::vector<Value>& row, const std::string& column, const std::string& was,
                        const std::string& is) {
    ++found.differing;
    if (!found.first) found.first = ValueDifference{form.table, rowText(form, row), column, was, is};
  };
  while (!a.ended() || !b.ended()) {
    int order = a.ended() ? 1 : b.ended() ? -1 : 0;
    for (std::size_t i = 0; i < form.key.size() && order == 0; ++i) order = compare(a.values()[i], b.values()[i]);
    if (order < 0) note(a.values(), "", "a row", "no such row"), a.advance();
    else if (order > 0) note(b.values(), "", "no such row", "a row"), b.advance();
    else {
      for (std::size_t i = form.key.size(); i < a.values().size(); ++i) {
        if (same(a.values()[i], b.values()[i])) continue;
        note(a.values(), form.values[i - form.key.size()].name, valueText(a.values()[i]), valueText(b.values()[i]));
        break;
      }
      a.advance(), b.advance();
    }
  }
  found.rows = a.count(), found.recomputedRows = b.count();
  return found;
}

}  // namespace

std::vector<TableDifference> compareTables(Database& stored, const std::string& id, Database& again,
                                           const std::string& idAgain) {
  std::vector<TableDifference> tables;
  for (const SqlTable* t : runTables())
    if (t->info.name == std::string_view("run") || isResult(t->info.part))
      tables.push_back(compareTable(formOf(again, t->info.name), stored, id, again, idAgain));
  return tables;
}

}  // namespace morula
