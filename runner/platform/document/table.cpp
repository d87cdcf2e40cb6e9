#include "document/table.h"

#include <algorithm>

#include "base/number_text.h"
#include "files/printable.h"
#include "files/text.h"

namespace morula {
namespace {

std::size_t letters(const std::string& s) {
  return static_cast<std::size_t>(
      std::ranges::count_if(s, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// Returns the texts of a row's cells in columns that people see.
std::vector<std::string> seen(const Table& table, const std::vector<Cell>& row) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < row.size(); ++i)
    if (i >= table.columns.size() || table.columns[i].isShown)
      texts.push_back(row[i].value.is_null() && row[i].words.empty() ? "-" : printableLine(row[i].words.text()));
  return texts;
}

std::vector<std::string> headOf(const Table& table) {
  std::vector<std::string> head;
  for (const Column& column : table.columns)
    if (column.isShown) head.push_back(printableLine(column.title.text()));
  return head;
}

std::string csvText(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_number_float()) return exactText(value.get<double>());
  const std::string text = value.is_string() ? value.get<std::string>() : jsonText(value);
  return text.empty() ? text : csvField(text);
}

}  // namespace

Cell number(const std::optional<double>& value, int digits) {
  return value ? Cell(*value, numberText(*value, digits)) : exact({});
}

Table stacked(const std::vector<std::pair<std::string, Table>>& tables, const std::vector<std::string>& first) {
  Table all{"", {}};
  const auto placeOf = [&](const std::string& name) {
    const auto at = std::ranges::find(all.columns, name, &Column::csv);
    const auto place = static_cast<std::size_t>(at - all.columns.begin());
    if (at == all.columns.end()) all.columns.push_back({"", name, name});
    return place;
  };
  for (const std::string& name : first) placeOf(name);
  for (const auto& [kind, table] : tables)
    for (const auto& row : table.rows) {
      std::vector<Cell> cells(all.columns.size(), exact({}));
      cells[0] = kind;
      for (std::size_t i = 0; i < row.size(); ++i) {
        if (table.columns[i].csv.empty()) continue;
        const std::size_t place = placeOf(table.columns[i].csv);
        if (place >= cells.size()) cells.resize(place + 1, exact({}));
        cells[place] = row[i];
      }
      all.rows.push_back(std::move(cells));
    }
  for (auto& row : all.rows) row.resize(all.columns.size(), exact({}));
  return all;
}

std::string textOf(const Table& table) {
  std::vector<std::vector<std::string>> lines;
  if (const auto head = headOf(table); !head.empty()) lines.push_back(head);
  std::vector<bool> isOfNumbers;
  for (const auto& row : table.rows) {
    lines.push_back(seen(table, row));
    std::size_t place = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i < table.columns.size() && !table.columns[i].isShown) continue;
      if (place == isOfNumbers.size()) isOfNumbers.push_back(true);
      if (!row[i].value.is_number() && !row[i].value.is_null()) isOfNumbers[place] = false;
      ++place;
    }
  }
  std::vector<std::size_t> widths;
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (i == widths.size()) widths.push_back(0);
      widths[i] = std::max(widths[i], letters(line[i]));
    }
  std::string text;
  for (const auto& cells : lines) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string blanks(widths[i] - letters(cells[i]), ' ');
      line += "  " + (i < isOfNumbers.size() && isOfNumbers[i] ? blanks + cells[i] : cells[i] + blanks);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string markdownOf(const Table& table) {
  const auto line = [](const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) text += (cell.empty() ? "" : " " + markdownCell(cell)) + " |";
    return text + "\n";
  };
  const auto head = headOf(table);
  std::string text = line(head) + "|";
  for (std::size_t i = 0; i < head.size(); ++i) text += "---|";
  text += "\n";
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (!table.columns[i].isShown) continue;
      std::string words = printableLine(row[i].words.text());
      const bool isBold = !words.empty() && row[i].words.pieces().front().emphasis == Emphasis::bold;
      cells.push_back(isBold ? "**" + words + "**" : words);
    }
    text += line(cells);
  }
  return text;
}

std::string csvOf(const Table& table, const std::string& lineEnd) {
  std::string text;
  const auto addLine = [&](const auto& fieldAt) {
    std::string line;
    bool first = true;
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      if (!table.columns[i].csv.empty()) line += (first ? "" : ",") + csvText(fieldAt(i)), first = false;
    text += line + lineEnd;
  };
  addLine([&](std::size_t i) { return Json(table.columns[i].csv); });
  for (const auto& row : table.rows) addLine([&](std::size_t i) { return row[i].value; });
  return text;
}

Json jsonOf(const Table& table) {
  Json list = Json::array();
  for (const auto& row : table.rows) {
    Json object = Json::object();
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      if (!table.columns[i].json.empty()) object[table.columns[i].json] = row[i].value;
    list.push_back(std::move(object));
  }
  return list;
}

}  // namespace morula
