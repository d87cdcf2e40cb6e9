#include "values/cell_names.h"

#include <algorithm>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "base/text_marks.h"
#include "base/utf8.h"

namespace morula {
namespace {

constexpr int longestName = 40;  // [character]

bool isAsciiWord(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}

/// Returns true for control characters, blanks, and characters that show as nothing or as a blank.
bool isUnseen(char32_t c) { return c <= 0x20 || (c >= 0x7F && c < 0xA0) || !nameOfInvisible(c).empty(); }

/// Adds to `found` the descendants of `cell` whose names add `rest` to hers, among those without a name of their own.
void findBelow(const CellNames& names, const CellPath& cell, std::string_view rest, std::vector<CellPath>& found) {
  if (rest.empty()) {
    found.push_back(cell);
    return;
  }
  if (cell.depth() == CellPath::maxDepth) return;
  for (std::size_t b = 0; b < names.daughters.size(); ++b) {
    const CellPath daughter = cell.daughter(b == 1);
    if (rest.starts_with(names.daughters[b]) && !names.given.contains(daughter))
      findBelow(names, daughter, rest.substr(names.daughters[b].size()), found);
  }
}

}  // namespace

const char* const nameAllowed =
    "1 to 40 characters without blanks and control characters, the first of them none of / = + - @";

bool isCellName(std::string_view text) {
  // A path begins with '/'. A spreadsheet takes a text that begins with one of the others for a formula.
  if (!text.empty() && std::string_view("/=+-@").find(text.front()) != std::string_view::npos) return false;
  int characters = 0;
  while (!text.empty()) {
    const int length = utf8Length(text);
    if (length == 0 || isUnseen(utf8Value(text, length))) return false;
    text.remove_prefix(static_cast<std::size_t>(length));
    ++characters;
  }
  return characters >= 1 && characters <= longestName;
}

std::optional<std::string> CellNames::of(const CellPath& path) const {
  CellPath cell = path;
  auto named = given.find(cell);
  while (named == given.end() && !cell.isEgg()) cell = cell.mother(), named = given.find(cell);
  if (named == given.end() || (cell != path && daughters.empty())) return {};
  std::string name = named->second;
  for (int i = cell.depth(); i < path.depth(); ++i) name += daughters[path.letter(i) ? 1 : 0];
  return name;
}

std::vector<CellPath> CellNames::find(std::string_view name) const {
  std::vector<CellPath> found;
  for (const auto& [path, ofPath] : given)
    if (name.starts_with(ofPath)) findBelow(*this, path, name.substr(ofPath.size()), found);
  std::sort(found.begin(), found.end());
  return found;
}

NameOf CellNames::function() const {
  if (empty()) return {};
  return [names = *this](const CellPath& path) { return names.of(path); };
}

CellPath cellCalled(const CellNames& names, std::string_view text, std::string_view where) {
  const auto isPath = [](std::string_view t) { return t.find_first_not_of("AB") == t.npos; };
  constexpr std::string_view cellWord = "cell ", pathWord = "path ";
  const bool isNamed = text.starts_with(cellWord), saysPath = text.starts_with(pathWord) || text.starts_with('/');
  if (isNamed) text.remove_prefix(cellWord.size());
  if (const auto found = names.find(text); !text.empty() && !found.empty() && !saysPath) return found.front();
  const std::string_view path = !saysPath ? text : text.substr(text.front() == '/' ? 1 : pathWord.size());
  if (path == "egg" || text == "/") return {};
  if (!isNamed && !path.empty() && isPath(path) && path.size() <= CellPath::maxDepth) return CellPath::parse(path);
  std::vector<std::string> known;
  for (const auto& [cell, name] : names.given) known.push_back(name);
  const std::string near = closest(text, known);
  const std::string right =
      near.empty() ? "needs egg, or a path of the letters A and B, as AAB" : "did you mean " + near + "?";
  throw InputError((where.empty() ? "" : std::string(where) + ": ") + "'" + std::string(text) + "' is no cell's " +
                   (names.empty() ? "path" : "name or path") + "; " + right);
}

std::string cellWords(const NameOf& nameOf, const CellPath& path) {
  const auto name = nameOf ? nameOf(path) : std::nullopt;
  if (!name) return cellName(path.text());
  return *name + (path.isEgg() ? " (the egg)" : " (path " + path.text() + ")");
}

std::string withNames(std::string_view message, const NameOf& nameOf) {
  constexpr std::string_view before = "cell ";
  if (!nameOf) return std::string(message);
  std::string text;
  for (std::size_t at = 0; at < message.size();) {
    const std::string_view rest = message.substr(at);
    const bool isWord = at == 0 || !isAsciiWord(message[at - 1]);
    if (isWord && rest.starts_with(before)) {
      const auto end = std::min(rest.find_first_not_of("AB", before.size()), rest.size());
      const std::string_view path = rest.substr(before.size(), end - before.size());
      const bool isWhole = end == rest.size() || !isAsciiWord(rest[end]);
      if (!path.empty() && isWhole && path.size() <= CellPath::maxDepth) {
        text += cellWords(nameOf, CellPath::parse(path));
        at += end;
        continue;
      }
    }
    text += message[at++];
  }
  return text;
}

}  // namespace morula
