// Compares two stored runs, table by table.
#include <algorithm>
#include <bit>

#include "base/hash.h"
#include "base/number_text.h"
#include "store/run_tables.h"
#include "store/store.h"

namespace morula {
namespace {

/// The columns of a table by which rows are found and ordered, and those that are compared.
struct Form {
  std::string table;
  std::vector<FileColumn> key, values;
  std::string where = "run_id = ?";
};

/// Returns a key that holds across two files, in which numbers of rows may differ.
const char* naturalKey(const std::string& table) { return table == "check_result" ? "kind check" : nullptr; }

/// Returns true for columns of the row `run` that the computation decides, not its circumstances.
bool isDecided(const std::string& column) {
  return partOf(column) == RunPart::result || partOf(column) == RunPart::scene;
}

Form formOf(Database& db, const std::string& table) {
  Form form{table, {}, {}};
  const char* natural = naturalKey(table);
  const auto isIn = [](const std::string& list, const std::string& word) {
    return (' ' + list + ' ').find(' ' + word + ' ') != std::string::npos;
  };
  for (const FileColumn& column : fileColumns(db, table)) {
    if (column.name == "run_id") continue;
    const bool isKey = natural ? isIn(natural, column.name) : column.key > 0;
    if (isKey) form.key.push_back(column);
    else if (column.key > 0) continue;  // a row number in place of a key
    else if (table != "run" || isDecided(column.name)) form.values.push_back(column);
  }
  if (table == "check_result") form.where += " AND kind NOT IN ('golden', 'bullet')";
  return form;
}

bool same(const TableValue& a, const TableValue& b) {
  const auto *x = std::get_if<double>(&a), *y = std::get_if<double>(&b);
  return x && y ? std::bit_cast<std::uint64_t>(*x) == std::bit_cast<std::uint64_t>(*y) : a == b;
}

std::string valueText(const TableValue& value, const std::string& type) {
  if (const auto* text = std::get_if<std::string>(&value))
    return type != "BLOB"
               ? "'" + *text + "'"
               : std::to_string(text->size()) + " bytes with the hash " + Hasher().add(*text).digest().text();
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
  if (const auto* real = std::get_if<double>(&value)) return exactText(*real);
  return "nothing";
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
    if (ended_) return;
    ++count_;
    int place = 0;
    const auto read = [&](const std::vector<FileColumn>& columns) {
      TableRow row;
      for (const FileColumn& c : columns) row.push_back(valueAt(statement_, place++, c.type));
      return row;
    };
    key_ = read(form_.key), values_ = read(form_.values);
  }
  std::uint64_t count() const { return count_; }
  const TableRow& key() const { return key_; }
  const TableRow& values() const { return values_; }

 private:
  static std::string query(const Form& form) {
    auto columns = form.key;
    columns.insert(columns.end(), form.values.begin(), form.values.end());
    return "SELECT " + namesOf(columns) + " FROM " + sqlName(form.table) + " WHERE " + form.where +
           (form.key.empty() ? "" : " ORDER BY " + namesOf(form.key));
  }

  const Form& form_;
  Statement statement_;
  bool ended_ = false;
  std::uint64_t count_ = 0;
  TableRow key_, values_;
};

std::string keyText(const Form& form, const TableRow& key) {
  std::string words;
  for (std::size_t i = 0; i < key.size(); ++i) {
    const auto* text = std::get_if<std::string>(&key[i]);
    words += (i ? ", " : "") + form.key[i].name + ' ' +
             (text && !text->empty() ? *text : valueText(key[i], form.key[i].type));
  }
  return words;
}

TableDifference compareTable(const Form& form, Database& stored, const std::string& id, Database& again,
                             const std::string& idAgain) {
  Rows a(stored, form, id), b(again, form, idAgain);
  TableDifference found{.table = form.table, .first = {}};
  const auto note = [&](const TableRow& key, const std::string& column, const std::string& was, const std::string& is) {
    ++found.differing;
    if (!found.first) found.first = ValueDifference{form.table, keyText(form, key), column, was, is};
  };
  while (!a.ended() || !b.ended()) {
    if (b.ended() || (!a.ended() && a.key() < b.key())) {
      note(a.key(), "", "a row", "no such row");
      a.advance();
    } else if (a.ended() || b.key() < a.key()) {
      note(b.key(), "", "no such row", "a row");
      b.advance();
    } else {
      for (std::size_t i = 0; i < a.values().size(); ++i) {
        if (same(a.values()[i], b.values()[i])) continue;
        const auto& [column, type, keyPlace] = form.values[i];
        note(a.key(), column, valueText(a.values()[i], type), valueText(b.values()[i], type));
        break;
      }
      a.advance(), b.advance();
    }
  }
  found.rows = a.count(), found.recomputedRows = b.count();
  return found;
}

}  // namespace

std::vector<TableDifference> Store::compareResults(const std::string& id, Store& again, const std::string& idAgain) {
  std::vector<TableDifference> tables;
  for (const SqlTable* t : runTables()) {
    if (t->info.name != std::string_view("run") && !isResult(t->info.part)) continue;
    Form form = formOf(again.db_, t->info.name);
    const auto there = columnNames(db_, t->info.name);
    std::vector<std::string> missing;
    std::erase_if(form.values, [&](const FileColumn& c) {
      const bool isMissing = std::ranges::find(there, c.name) == there.end();
      if (isMissing) missing.push_back(c.name);
      return isMissing;
    });
    tables.push_back(compareTable(form, db_, id, again.db_, idAgain));
    tables.back().missing = std::move(missing);
  }
  return tables;
}

}  // namespace morula
