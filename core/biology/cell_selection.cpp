
#include "biology/cell_selection.h"

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "biology/substance_pattern.h"

namespace morula {
namespace {

constexpr std::string_view generationWord = "generation ", clonesWord = "clones", cellWord = "cell ",
                           cloneWord = "clone ", pathWord = "path ", substanceWord = "substance ", eggWord = "egg";

bool isPath(std::string_view text) {
  return !text.empty() && text.size() <= CellPath::maxDepth &&
         std::ranges::all_of(text, [](char c) { return c == 'A' || c == 'B'; });
}

/// Reads a generation's number. Throws InputError.
int readGeneration(const std::string& text) {
  const std::string_view digits = std::string_view(text).substr(generationWord.size());
  int number = -1;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (read.ptr != digits.data() + digits.size() || number < 0 || number > CellPath::maxDepth ||
      (digits.size() > 1 && digits[0] == '0'))
    throw InputError("'" + text + "' is no generation; needs a whole number from 0 to " +
                     std::to_string(CellPath::maxDepth) + " behind it");
  return number;
}

/// Reads what stands behind "path". Throws InputError.
AskedCells readPath(std::string_view text, bool isExplicit) {
  const bool isClone = text.ends_with('*');
  if (isClone) text.remove_suffix(1);
  if (text != eggWord && !isPath(text))
    throw InputError("'" + std::string(text) + "' is no path; needs letters A and B, as path AAB, or path egg");
  const auto kind = isClone ? CellSelection::Kind::clone : CellSelection::Kind::cell;
  return {{.kind = kind, .path = text == eggWord ? CellPath() : CellPath::parse(text)}, "", isExplicit};
}

[[noreturn]] void refuse(const std::string& text) {
  const std::vector<std::string> words(selectionWords.begin(), selectionWords.end());
  const auto space = text.find(' ');
  const std::string near = space == text.npos ? "" : closest(text.substr(0, space), words);
  throw InputError(
      "'" + text + "' selects no cells; " +
      (near.empty() ? std::string("needs ") + selectionAllowed : "did you mean " + near + text.substr(space) + "?"));
}

}  // namespace

std::string AskedCells::text() const {
  const auto pathText = [&](const char* end) {
    const bool needsWord = isExplicit || path.isEgg();
    return std::string(needsWord ? pathWord : std::string_view()) +
           (path.isEgg() ? std::string(eggWord) : path.text()) + end;
  };
  switch (kind) {
    case Kind::cell: return isNamed() ? std::string(cellWord) + name : pathText("");
    case Kind::clone: return isNamed() ? std::string(cloneWord) + name : pathText("*");
    case Kind::generation: return std::string(generationWord) + std::to_string(generation);
    case Kind::clones: return std::string(clonesWord);
    case Kind::substance: break;
  }
  return std::string(isExplicit ? substanceWord : std::string_view()) + substance;
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

bool AskedCells::has(const CellPath& cell, std::string_view substances) const {
  MORULA_CHECK(!isNamed(), "cells are looked for by their paths");
  return CellSelection::has(cell, substances);
}

AskedCells parseSelection(const std::string& text) {
  using enum CellSelection::Kind;
  const auto behind = [&](std::string_view word) { return text.substr(word.size()); };
  if (text.starts_with(generationWord)) return {{.kind = generation, .generation = readGeneration(text)}};
  if (text == clonesWord) return {{.kind = clones}};
  for (const auto& [word, kind] : {std::pair{cellWord, cell}, std::pair{cloneWord, clone}})
    if (text.starts_with(word) && text.size() > word.size()) return {{.kind = kind}, behind(word)};
  if (text.starts_with(pathWord)) return readPath(behind(pathWord), true);
  const std::string_view plain = text.ends_with('*') ? std::string_view(text).substr(0, text.size() - 1) : text;
  if (isPath(plain)) return readPath(text, false);
  const bool isExplicit = text.starts_with(substanceWord);
  const std::string word = isExplicit ? behind(substanceWord) : text;
  if (word.empty() || word.find(' ') != word.npos || word.find('*') < word.size() - 1) refuse(text);
  return {{.kind = substance, .substance = word}, "", isExplicit};
}

}  // namespace morula
