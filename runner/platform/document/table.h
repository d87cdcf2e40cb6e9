#pragma once
// A table in any form: columns of text, HTML, Markdown, CSV [RFC 4180] or JSON.
#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "document/words.h"
#include "system/json.h"

namespace morula {

/// A cell of a table: its exact value for programs, and its words for people.
struct Cell {
  Json value;
  Words words;

  Cell(Words shown = {}) : value(shown.text()), words(std::move(shown)) {}
  Cell(std::string text) : Cell(Words(std::move(text))) {}
  Cell(const char* text) : Cell(Words(text)) {}
  Cell(std::integral auto number) : value(number), words(std::to_string(number)) {}
  Cell(Json exact, Words shown) : value(std::move(exact)), words(std::move(shown)) {}
};

/// Returns a cell with `digits` significant digits for people; an absent value is null and shows as nothing.
Cell number(const std::optional<double>& value, int digits = 4);
/// Returns a cell that only programs see.
inline Cell exact(Json value) { return {std::move(value), {}}; }

struct Column {
  Words title;            // for people; empty: a column without a heading
  std::string json, csv;  // its names for programs; "": left out for them
  bool isShown = true;    // whether people see the column

  Column(Words heading) : title(std::move(heading)) {}
  Column(std::string heading) : title(std::move(heading)) {}
  Column(const char* heading) : title(heading) {}
  Column(std::string jsonName, std::string csvName, Words heading)
      : title(std::move(heading)), json(std::move(jsonName)), csv(std::move(csvName)), isShown(!title.empty()) {}
};

struct Table {
  std::string caption;          // a plain text for people who do not see the words above the table
  std::vector<Column> columns;  // empty: each row is a name and values
  std::vector<std::vector<Cell>> rows = {};
};

/// A column of a table whose rows are all of one type, declared in one line for people and programs.
template <class Row>
struct FieldOf {
  Column column;
  std::function<Cell(const Row&)> of;
};

template <class Row>
Table tableOf(const std::string& caption, const std::vector<FieldOf<Row>>& fields, const std::vector<Row>& rows) {
  Table table{caption, {}};
  for (const FieldOf<Row>& field : fields) table.columns.push_back(field.column);
  for (const Row& row : rows) {
    table.rows.emplace_back();
    for (const FieldOf<Row>& field : fields) table.rows.back().push_back(field.of(row));
  }
  return table;
}

/// Joins tables into one. The first column names the table of a row; the others are joined by their CSV names, those in
/// `first` first.
Table stacked(const std::vector<std::pair<std::string, Table>>& tables, const std::vector<std::string>& first);

/// Writes a table as text: columns two blanks apart, indented, numbers right-aligned; an absent value is "-".
std::string textOf(const Table& table);
std::string markdownOf(const Table& table);
/// Writes a table as CSV in UTF-8, with a line of names. Numbers read back the same; null is empty.
std::string csvOf(const Table& table, const std::string& lineEnd = "\r\n");
/// Returns a list with an object for each row.
Json jsonOf(const Table& table);

}  // namespace morula
