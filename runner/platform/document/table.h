#pragma once
// A table, whatever it becomes: columns of text, HTML, Markdown, CSV [RFC 4180] or JSON.
#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "document/words.h"
#include "system/json.h"

namespace morula {

/// A cell of a table: exactly, for programs, and as people read it.
struct Cell {
  Json value;
  Words words;

  Cell(Words shown = {}) : value(shown.text()), words(std::move(shown)) {}
  Cell(std::string text) : Cell(Words(std::move(text))) {}
  Cell(const char* text) : Cell(Words(text)) {}
  Cell(std::integral auto number) : value(number), words(std::to_string(number)) {}
  Cell(Json exact, Words shown) : value(std::move(exact)), words(std::move(shown)) {}
};

/// Returns a cell with so many significant digits for people; an absent value is null, and shows as nothing.
Cell number(const std::optional<double>& value, int digits = 4);
/// Returns a cell for programs alone.
inline Cell exact(Json value) { return {std::move(value), {}}; }

struct Column {
  Words title;            // for people; empty: a column without a heading
  std::string json, csv;  // its names for programs; "": not among them
  bool isShown = true;    // to people

  Column(Words heading) : title(std::move(heading)) {}
  Column(std::string heading) : title(std::move(heading)) {}
  Column(const char* heading) : title(heading) {}
  Column(std::string jsonName, std::string csvName, Words heading)
      : title(std::move(heading)), json(std::move(jsonName)), csv(std::move(csvName)), isShown(!title.empty()) {}
};

struct Table {
  std::string caption;          // plain, for people who do not see what stands above it
  std::vector<Column> columns;  // none: rows of a name and values
  std::vector<std::vector<Cell>> rows = {};
};

/// A column of a table whose rows are all of one type: one line declares it, for people and for programs.
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

/// Tables one below the other: the first column says which, the others are joined by their CSV names, the named ones
/// first.
Table stacked(const std::vector<std::pair<std::string, Table>>& tables, const std::vector<std::string>& first);

/// Columns two blanks apart and in from the left, numbers at the right; what is not there is "-".
std::string textOf(const Table& table);
std::string markdownOf(const Table& table);
/// UTF-8, a line of names; numbers are the shortest that read back as the same, what is null is empty.
std::string csvOf(const Table& table, const std::string& lineEnd = "\r\n");
/// An object a row.
Json jsonOf(const Table& table);

}  // namespace morula
