#include "store/recorded_tables.h"

#include <fmt/format.h>

#include <algorithm>

#include "files/text.h"
#include "store/cell_surface.h"
#include "store/result_rows.h"
#include "store/row_texts.h"

namespace morula {
namespace {

/// Returns true for tables that lines `step_hash` hold: their last link confirms all others and all hashes of cells.
bool isHeldByChain(const SqlTable& table) {
  return &table == &sqlTable<ChainLink>() || &table == &sqlTable<CellHash>();
}

/// Returns true for tables that lines `cell` and `time_step` hold.
bool hasOwnLines(const SqlTable& table) {
  return &table == &sqlTable<CellRow>() || &table == &sqlTable<TimeStepRecord>();
}

/// Returns all columns but the run's id.
std::vector<const SqlColumn*> columnsOf(const SqlTable& table) {
  std::vector<const SqlColumn*> all;
  for (const auto* columns : {&table.context, &table.own})
    for (const SqlColumn& c : *columns)
      if (c.name != "run_id") all.push_back(&c);
  return all;
}

/// Returns a text as one word: blanks, control characters and characters with a meaning in a golden's row are written
/// as %20.
std::string wordOf(const std::string& text) {
  std::string word;
  for (const char c : text)
    if (static_cast<unsigned char>(c) <= ' ' || c == '%' || c == 0x7f || c == '/')
      word += fmt::format("%{:02x}", static_cast<unsigned char>(c));
    else word += c;
  return word == "-" ? "%2d" : word;
}

std::string valueText(const SqlColumn& column, const std::optional<std::string>& text) {
  if (!text) return "-";
  if (column.type.starts_with("BLOB")) return '#' + Hasher().add(*text).digest().text();
  return wordOf(*text);
}

auto adder(RecordedTables& to) {
  return [&to]<class Row>(std::uint64_t step, const Row& row, const auto&... context) {
    to.addRow(sqlTable<Row>(), step, textsOf(row, context...));
  };
}

}  // namespace

void RecordedTables::addRow(const SqlTable& table, std::uint64_t step, const RowTexts& values) {
  if (isHeldByChain(table)) return;
  auto& [known, to] = tables_[table.info.name];
  known = &table;
  const auto columns = columnsOf(table);
  MORULA_CHECK(columns.size() == values.size(), "a row has a value for each column");

  const std::vector<std::string> keys = partsOf(table.info.key, ',');
  std::string key;
  GoldenRow row{table.info.name, step, {}};
  for (const std::string& word : keys) {
    const std::string name = wordsOf(word).front();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i]->name != name) continue;
      const std::string text = values[i].value_or("");
      key += std::to_string(text.size()) + ':' + text;
      row.name += '/' + (text.empty() ? "egg" : wordOf(text));
    }
  }
  to.columns.resize(columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i)
    to.columns[i].add(Hasher().add(key).add(values[i].has_value()).add(values[i].value_or("")).digest());

  if (++to.rows > goldenRowLimit) return to.byValue.clear();
  if (hasOwnLines(table)) return;
  const std::string inKey = ' ' + std::string(table.info.key) + ',';
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (inKey.find(' ' + columns[i]->name + ',') == inKey.npos)
      row.values.text +=
          (row.values.text.empty() ? "" : " ") + columns[i]->name + '=' + valueText(*columns[i], values[i]);
  to.byValue.push_back(std::move(row));
}

void RecordedTables::addFaces(const RunResults& results) {
  for (const MeshFaces& m : results.meshes)
    if (!faces_.contains(m.mesh)) faces_[m.mesh] = Hasher().add(m.mesh).add(m.vertices).add(faceBytes(m)).digest();
}

void RecordedTables::addRecords(const RunResults& results) {
  visitRecords(results, adder(*this));
  addFaces(results);
}

void RecordedTables::addAll(const RunResults& results, std::uint64_t step) {
  addRecords(results);
  visitEnd(results, step, adder(*this));
}

std::vector<GoldenItem> RecordedTables::items() const {
  std::vector<GoldenItem> items;
  for (const auto& [name, known] : tables_) {
    const auto columns = columnsOf(*known.first);
    for (std::size_t i = 0; i < columns.size(); ++i)
      items.push_back(GoldenColumn{name + '/' + columns[i]->name, known.second.rows, known.second.columns[i].sum});
  }
  HashSum faces;
  for (const auto& [mesh, hash] : faces_) faces.add(hash);
  if (!faces_.empty()) items.push_back(GoldenColumn{"faces/mesh", faces_.size(), faces.sum});
  for (const auto& [name, known] : tables_) {
    std::vector<GoldenRow> rows = known.second.byValue;
    std::ranges::sort(rows, [](const GoldenRow& a, const GoldenRow& b) {
      return a.step != b.step ? a.step < b.step : a.name < b.name;
    });
    for (GoldenRow& row : rows) items.push_back(std::move(row));
  }
  return items;
}

}  // namespace morula
