#include "report/tables.h"

#include <map>

#include "base/number_text.h"
#include "system/json.h"

namespace morula {

namespace {

std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

template <class Of>
std::string headOf(std::string first) {
  for (const auto& m : sampledMeasures<Of>()) first += std::string(",") + m.name;
  return first + "\r\n";
}

std::string valuesOf(const std::vector<std::optional<double>>& values) {
  std::string text;
  for (const auto& value : values) text += value ? "," + exactText(*value) : ",";
  return text + "\r\n";
}

std::string nameOf(const RunResults& results, const CellPath& path) {
  const auto found = results.names.find(path);
  return found == results.names.end() ? "" : found->second;
}

using ByPath = std::map<CellPath, const LineageEntry*>;

void addBranch(const RunResults& results, const ByPath& cells, const CellPath& path, double end,
               std::string& text) {
  const LineageEntry& cell = *cells.at(path);
  if (cell.fate == Fate::divided && path.depth() < CellPath::maxDepth &&
      cells.contains(path.daughter(false)) && cells.contains(path.daughter(true))) {
    text += '(';
    addBranch(results, cells, path.daughter(false), end, text);
    text += ',';
    addBranch(results, cells, path.daughter(true), end, text);
    text += ')';
  }
  const std::string name = nameOf(results, path);
  text += '\'';
  for (const char c : name.empty() ? (path.isEgg() ? "egg" : path.text()) : name)
    text += c == '\'' ? std::string("''") : std::string(1, c);
  text += "':" + exactText((cell.fate == Fate::alive ? end : cell.ended) - cell.born);
}

}  // namespace

std::string cellsCsv(const RunResults& results) {
  std::string text = "path,name,born,ended,fate,state\r\n";
  for (const LineageEntry& cell : results.lineage)
    text += cell.path.text() + ',' + field(nameOf(results, cell.path)) + ',' + exactText(cell.born) + ',' +
            (cell.fate == Fate::alive ? "" : exactText(cell.ended)) + ',' + name(cell.fate) + ',' +
            field(results.stateTexts.at(cell.state)) + "\r\n";
  return text;
}

std::string samplesCsv(const RunResults& results) {
  if (results.samples.empty()) return {};
  std::string text = headOf<Observation>("time,step");
  for (const Sample& s : results.samples)
    text += exactText(s.world.time) + ',' + std::to_string(s.world.step) + valuesOf(s.world.values);
  return text;
}

std::string cellSamplesCsv(const RunResults& results) {
  std::string rows;
  for (const Sample& s : results.samples)
    for (const CellMeasures& c : s.cells)
      rows += exactText(s.world.time) + ',' + c.path.text() + valuesOf(c.values);
  return rows.empty() ? rows : headOf<CellContext>("time,path") + rows;
}

std::string newick(const RunResults& results, double end) {
  ByPath cells;
  for (const LineageEntry& cell : results.lineage) cells.emplace(cell.path, &cell);
  std::string roots;  // start cells have no common mother
  std::size_t count = 0;
  for (const auto& [path, cell] : cells) {
    if (!path.isEgg() && cells.contains(path.mother())) continue;
    if (count++) roots += ',';
    addBranch(results, cells, path, end, roots);
  }
  if (count == 0) return {};
  return (count == 1 ? roots : "(" + roots + ")") + ";\n";
}

std::string indented(const std::string& json) {
  const Json read = Json::tryParse(json);
  return read.is_null() ? json : jsonText(read, 2);
}

std::string sourceOf(const RunFacts& run) {
  for (const Document& d : run.documents)
    if (d.role == "scenario") return d.path;
  return run.run.record.scenario + ".yaml";
}

}  // namespace morula
