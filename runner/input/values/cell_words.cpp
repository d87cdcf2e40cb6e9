#include "values/cell_words.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "biology/substance_pattern.h"
#include "biology/substances.h"
#include "files/text.h"

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

void requireSubstance(const std::string& text, const Dna& dna) {
  if (isSubstance(dna, text)) return;
  const std::string near = closest(text, dna.substances);
  throw InputError("the DNA has no substance '" + text + "'; " +
                   (near.empty() ? "name one that it produces" : "did you mean " + near + "?"));
}

/// Returns the meaning of a word alone, which may be a cell's name, a path or a substance. Throws InputError for two meanings.
AskedCells meaningOf(const std::string& word, const AskedCells& asked, const CellNames& names, const Dna& dna) {
  const auto named = pathNamed(names, word);
  const bool isPath = asked.kind != Kind::substance;
  const bool isOther = named && !(isPath && asked.kind == Kind::cell && *named == asked.path);
  std::vector<std::string> meanings, remedies;
  const auto add = [&](bool can, const std::string& meaning, const std::string& remedy) {
    if (can) meanings.push_back(meaning), remedies.push_back("'" + remedy + " " + word + "'");
  };
  add(isOther, "the name of a cell (path " + (named && !named->isEgg() ? named->text() : "egg") + ")", "cell");
  add(isPath, "a path", "path");
  add(isSubstance(dna, word) && !substance::isReserved(word), "a substance", "substance");
  if (meanings.size() > 1)
    throw InputError("'" + word + "' is " + join(meanings, " and ") + "; write " + join(remedies, " or "));
  if (named) return {{.kind = Kind::cell, .path = *named}};
  if (!isPath && meanings.empty()) refuseWord(word, names, dna);
  return asked;
}

}  // namespace

AskedCells resolved(const AskedCells& asked, const CellNames& names, const Dna& dna) {
  if (asked.isNamed()) return {byName(asked.kind, asked.name, names)};
  if (asked.kind == Kind::generation || asked.kind == Kind::clones) return asked;
  AskedCells found = asked;
  if (!asked.isExplicit) found = meaningOf(asked.text(), asked, names, dna);
  else if (asked.kind == Kind::substance) requireSubstance(asked.substance, dna);
  found.isExplicit = found.kind == Kind::substance && parseSelection(found.substance).kind != Kind::substance;
  return found;
}

CellSelection selectionOf(const std::string& text, const CellNames& names, const Dna& dna) {
  const AskedCells asked = parseSelection(text);
  if (asked.kind == Kind::clones)
    throw InputError("'clones' are several selections of cells; needs " + std::string(cellsAllowed));
  return resolved(asked, names, dna);
}

AskedMeasure resolved(const AskedMeasure& measure, const CellNames& names, const Dna& dna) {
  return withSelections(measure, [&](const AskedCells& asked) { return resolved(asked, names, dna); });
}

std::string selectionText(const CellSelection& selection) { return AskedCells{selection, "", true}.text(); }

}  // namespace morula
