
#include "biology/cell_selection.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "biology/substance_pattern.h"

namespace morula {
namespace {

constexpr std::string_view generationWord = "generation ", clonesWord = "clones";

bool isPath(std::string_view text) {
  return !text.empty() && text.size() <= CellPath::maxDepth &&
         std::ranges::all_of(text, [](char c) { return c == 'A' || c == 'B'; });
}

}  // namespace

std::string CellSelection::text() const {
  switch (kind) {
    case Kind::cell: return path.text();
    case Kind::clone: return path.text() + "*";
    case Kind::generation: return std::string(generationWord) + std::to_string(generation);
    case Kind::clones: return std::string(clonesWord);
    case Kind::substance: break;
  }
  return substance;
}

bool CellSelection::has(const CellPath& cell, std::string_view substances) const {
  switch (kind) {
    case Kind::cell: return cell == path;
    case Kind::clone: return path.isAncestorOf(cell);
    case Kind::generation: return cell.depth() == generation;
    case Kind::clones: return cell.depth() >= cloneDepth;
    case Kind::substance: break;
  }
  return fitsAny(substance, substances);
}

CellSelection parseSelection(const std::string& text) {
  using enum CellSelection::Kind;
  if (text.starts_with(generationWord)) {
    const std::string_view digits = std::string_view(text).substr(generationWord.size());
    int number = -1;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (read.ptr != digits.data() + digits.size() || number < 0 || number > CellPath::maxDepth ||
        (digits.size() > 1 && digits[0] == '0'))
      throw InputError("'" + text + "' is no generation; needs a whole number from 0 to " +
                       std::to_string(CellPath::maxDepth) + " behind it");
    return {.kind = generation, .generation = number};
  }
  if (text == clonesWord) return {.kind = clones};
  if (isPath(text)) return {.kind = cell, .path = CellPath::parse(text)};
  if (text.ends_with('*') && isPath(std::string_view(text).substr(0, text.size() - 1)))
    return {.kind = clone, .path = CellPath::parse(std::string_view(text).substr(0, text.size() - 1))};
  if (text.empty() || text.find(' ') != text.npos || text.find('*') < text.size() - 1) {
    const auto space = text.find(' ');
    const bool isNear =
        space != text.npos && !closest(text.substr(0, space), std::vector<std::string>{"generation"}).empty();
    throw InputError(
        "'" + text + "' selects no cells; " +
        (isNear ? "did you mean generation" + text.substr(space) + "?" : std::string("needs ") + selectionAllowed));
  }
  return {.kind = substance, .substance = text};
}

}  // namespace morula
