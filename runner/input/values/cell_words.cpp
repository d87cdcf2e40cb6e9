#include "values/cell_words.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "biology/substance_pattern.h"

namespace morula {
namespace {

using Kind = CellSelection::Kind;

std::optional<CellPath> pathNamed(const CellNames& names, const std::string& name) {
  const auto found = names.find(name);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

bool isSubstance(const Dna& dna, const std::string& pattern) {
  return std::ranges::any_of(dna.substances, [&](const std::string& s) { return fits(pattern, s); });
}

[[noreturn]] void refuseWord(const std::string& word, const CellNames& names, const Dna& dna) {
  std::vector<std::string> known = dna.substances;
  for (const auto& [path, name] : names.given) known.push_back(name);
  const std::string near = closest(word, known);
  throw InputError("'" + word + "' is neither a cell's name nor a substance; " +
                   (near.empty() ? std::string("needs ") + cellsAllowed : "did you mean " + near + "?"));
}

/// A cell or a clone by her name; a path where the text says so.
CellSelection byName(Kind kind, const std::string& name, const CellNames& names) {
  if (const auto path = pathNamed(names, name)) return {.kind = kind, .path = *path};
  if (name == "egg") return {.kind = kind};
  std::vector<std::string> known;
  for (const auto& [path, given] : names.given) known.push_back(given);
  const std::string near = closest(name, known);
  throw InputError("no cell is called '" + name + "'; " +
                   (near.empty() ? "the scenario's section names gives names to cells, and path AAB needs none"
                                 : "did you mean " + near + "?"));
}

CellSelection byPath(std::string text) {
  const bool clone = text.ends_with('*');
  if (clone) text.pop_back();
  if (text == "egg") text.clear();
  if (text.size() > CellPath::maxDepth || text.find_first_not_of("AB") != text.npos)
    throw InputError("'" + text + "' is no path; needs letters A and B, as path AAB, or path egg");
  return {.kind = clone ? Kind::clone : Kind::cell, .path = CellPath::parse(text)};
}

CellSelection bySubstance(const std::string& text, const Dna& dna) {
  if (!isSubstance(dna, text)) {
    const std::string near = closest(text, dna.substances);
    throw InputError("the DNA has no substance '" + text + "'; " +
                     (near.empty() ? "name one that it produces" : "did you mean " + near + "?"));
  }
  return {.kind = Kind::substance, .substance = text};
}

}  // namespace

CellSelection selectionOf(const std::string& text, const CellNames& names, const Dna& dna) {
  const auto space = text.find(' ');
  const std::string first = text.substr(0, space), rest = space == text.npos ? "" : text.substr(space + 1);
  if (!rest.empty()) {
    if (first == "cell") return byName(Kind::cell, rest, names);
    if (first == "clone") return byName(Kind::clone, rest, names);
    if (first == "path") return byPath(rest);
    if (first == "substance") return bySubstance(rest, dna);
    if (first == "generation") return parseSelection(text);
    const std::string near =
        closest(first, std::vector<std::string>{"cell", "clone", "path", "substance", "generation"});
    throw InputError("'" + text + "' selects no cells; " +
                     (near.empty() ? std::string("needs ") + cellsAllowed : "did you mean " + near + " " + rest + "?"));
  }
  const auto named = pathNamed(names, text);
  const bool substance = isSubstance(dna, text);
  if (named && substance)
    throw InputError("'" + text + "' is the name of a cell (path " + (named->isEgg() ? "egg" : named->text()) +
                     ") and a substance; write 'cell " + text + "', 'clone " + text + "' or 'substance " + text + "'");
  if (named) return {.kind = Kind::cell, .path = *named};
  if (substance) return {.kind = Kind::substance, .substance = text};
  refuseWord(text, names, dna);
}

std::string measureByPaths(const std::string& measure, const CellNames& names, const Dna& dna) {
  constexpr std::string_view before = " of ";
  const auto at = measure.find(before);
  if (at == measure.npos) return measure;
  const std::string head = measure.substr(0, at + before.size()), text = measure.substr(at + before.size());
  const std::string first = text.substr(0, text.find(' '));
  const std::array words{"cell", "clone", "path", "substance"};
  if (first == text) {  // a word alone
    const auto named = pathNamed(names, text);
    const bool isPath = text.find_first_not_of("AB") == text.npos;
    if (!named || (isPath && named->text() == text)) return measure;
    if (isPath || isSubstance(dna, text))
      throw InputError("'" + text + "' is the name of a cell (path " + (named->isEgg() ? "egg" : named->text()) +
                       ") and " + (isPath ? "a path" : "a substance") + "; write 'cell " + text + "' or '" +
                       (isPath ? "path " : "substance ") + text + "'");
    return head + named->text();
  }
  if (std::ranges::find(words, first) == words.end()) return measure;
  const CellSelection selection = selectionOf(text, names, dna);
  if (selection.path.isEgg() && selection.kind == Kind::cell)
    throw InputError("'" + text + "' is the egg, whose path has no letters; leave 'of " + text +
                     "' out while she is the only cell");
  return head + (selection.path.isEgg() && selection.kind == Kind::clone ? "*" : selection.text());
}

std::string selectionText(const CellSelection& selection) {
  const std::string path = selection.path.isEgg() ? "egg" : selection.path.text();
  switch (selection.kind) {
    case Kind::cell: return "path " + path;
    case Kind::clone: return "path " + path + "*";
    case Kind::substance: return "substance " + selection.substance;
    default: return selection.text();
  }
}

}  // namespace morula
