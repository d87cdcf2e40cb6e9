#include "cli/cell_life.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "system/usage_error.h"

namespace morula::cli {
namespace {

const LineageEntry* entryOf(const RunResults& tree, const CellPath& path) {
  const auto at = std::ranges::find(tree.lineage, path, &LineageEntry::path);
  return at == tree.lineage.end() ? nullptr : &*at;
}

NameOf nameIn(const std::map<CellPath, std::string>& names) {
  return [&names](const CellPath& path) -> std::optional<std::string> {
    const auto named = names.find(path);
    return named == names.end() ? std::nullopt : std::optional(named->second);
  };
}

CellPath pathOf(const CellNames& names, const std::string& text) {
  try {
    return cellCalled(names, text, "--cell");
  } catch (const InputError& error) {  // the command line is wrong, not a file
    throw UsageError(error.what());
  }
}

/// That there never was such a cell, and where its line of descent ends.
[[noreturn]] void refuseUnborn(const RunResults& tree, double end, const NameOf& nameOf, const CellPath& path) {
  CellPath last = path;
  while (!entryOf(tree, last) && !last.isEgg()) last = last.mother();
  const LineageEntry* ancestor = entryOf(tree, last);
  MORULA_CHECK(ancestor && last != path, "a tree of cells holds the egg");
  throw UsageError("--cell: " + cellWords(nameOf, path) + " was never born: " + cellWords(nameOf, last) +
                   (ancestor->fate == Fate::died ? fmt::format(" died at {:.6g}", ancestor->ended)
                                                 : fmt::format(" lives at the run's end, {:.6g}", end)) +
                   "; needs a cell that 'morula lineage' lists without --cell");
}

Json relative(const LineageEntry* cell, const NameOf& nameOf) {
  if (!cell) return {};
  return {{"path", cell->path.text()}, {"name", orNull(nameOf(cell->path))}};
}

}  // namespace

CellLife lifeOf(const RunResults& tree, double end, const CellNames& names, const std::string& text) {
  const CellPath path = pathOf(names, text);
  const LineageEntry* cell = entryOf(tree, path);
  if (!cell) refuseUnborn(tree, end, names.function(), path);
  const LineageEntry *mother = nullptr, *sister = nullptr, *a = nullptr, *b = nullptr;
  if (!path.isEgg()) {
    mother = entryOf(tree, path.mother());
    sister = entryOf(tree, path.mother().daughter(!path.letter(path.depth() - 1)));
  }
  if (cell->fate == Fate::divided) {  // a path at its greatest depth has no daughters, and never divides
    a = entryOf(tree, path.daughter(false));
    b = entryOf(tree, path.daughter(true));
  }
  return {cell, mother, sister, a, b, tree.stateTexts.at(cell->state), tree.names, end};
}

std::string lifeAsText(const CellLife& life, const Units& units) {
  const NameOf nameOf = nameIn(life.names);
  const LineageEntry& cell = *life.cell;
  std::string text;
  const auto line = [&](const char* what, const std::string& value) {
    text += fmt::format("{:<10} {}\n", what, value);
  };
  const auto words = [&](const LineageEntry* relative) { return cellWords(nameOf, relative->path); };
  line("path", cell.path.isEgg() ? "egg" : cell.path.text());
  if (const auto name = nameOf(cell.path)) line("name", *name);
  line("born", shownTime(units, cell.born, 6));
  if (cell.fate == Fate::alive) line("ended", "not before the run's end, " + shownTime(units, life.end, 6));
  else line("ended", shownTime(units, cell.ended, 6));
  line("fate", name(cell.fate));
  if (!life.state.empty()) line("state", life.state);
  if (life.mother) line("mother", words(life.mother));
  if (life.daughterA && life.daughterB) line("daughters", words(life.daughterA) + ", " + words(life.daughterB));
  if (life.sister) line("sister", words(life.sister));
  return text;
}

Json cellAsJson(const LineageEntry& cell, const std::map<CellPath, std::string>& names, const std::string& state,
                double end) {
  return {{"path", cell.path.text()},
          {"name", orNull(nameIn(names)(cell.path))},
          {"parent", cell.path.isEgg() ? Json() : Json(cell.path.mother().text())},
          {"born", cell.born},
          {"ended", cell.fate == Fate::alive ? end : cell.ended},
          {"fate", name(cell.fate)},
          {"state", state}};
}

Json lifeAsJson(const CellLife& life) {
  const NameOf nameOf = nameIn(life.names);
  Json json = cellAsJson(*life.cell, life.names, life.state, life.end);
  json["mother"] = relative(life.mother, nameOf);
  json["sister"] = relative(life.sister, nameOf);
  json["daughters"] = Json::array();
  for (const LineageEntry* daughter : {life.daughterA, life.daughterB})
    if (daughter) json["daughters"].push_back(relative(daughter, nameOf));
  return json;
}

}  // namespace morula::cli
