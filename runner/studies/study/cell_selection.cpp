#include "study/cell_selection.h"

#include <algorithm>

#include "base/error.h"
#include "biology/substance_pattern.h"
#include "yaml/numbers.h"

namespace morula {

namespace {

constexpr std::string_view generationWord = "generation ";

bool isPath(std::string_view text) {
  return !text.empty() && text.size() <= CellPath::maxDepth &&
         std::ranges::all_of(text, [](char c) { return c == 'A' || c == 'B'; });
}

}  // namespace

std::string CellSelection::text() const {
  switch (kind) {
    case Kind::cell:
      return path.text();
    case Kind::clone:
      return path.text() + "*";
    case Kind::generation:
      return std::string(generationWord) + std::to_string(generation);
    case Kind::substance:
      break;
  }
  return substance;
}

bool CellSelection::has(const CellPath& cell, std::string_view substances) const {
  switch (kind) {
    case Kind::cell:
      return cell == path;
    case Kind::clone:
      return path.isAncestorOf(cell);
    case Kind::generation:
      return cell.depth() == generation;
    case Kind::substance:
      break;
  }
  return fitsAny(substance, substances);
}

CellSelection parseSelection(const std::string& text) {
  using enum CellSelection::Kind;
  if (text.starts_with(generationWord)) {
    const auto number = scenario::parseNatural(text.substr(generationWord.size()));
    if (!number.wrong.empty() || number.value > CellPath::maxDepth)
      throw InputError("'" + text + "' is no generation; needs a whole number from 0 to " +
                       std::to_string(CellPath::maxDepth) + " behind it");
    return {.kind = generation, .generation = static_cast<int>(number.value)};
  }
  if (isPath(text)) return {.kind = cell, .path = CellPath::parse(text)};
  if (text.ends_with('*') && isPath(std::string_view(text).substr(0, text.size() - 1)))
    return {.kind = clone, .path = CellPath::parse(std::string_view(text).substr(0, text.size() - 1))};
  if (text.empty() || text.find(' ') != text.npos || text.find('*') < text.size() - 1)
    throw InputError("'" + text + "' selects no cells; needs " + selectionAllowed);
  return {.kind = substance, .substance = text};
}

}  // namespace morula
