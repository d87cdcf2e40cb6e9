#include "export/newick.h"

#include <string_view>

#include "base/number_text.h"

namespace morula {
namespace {

bool isPlain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-';
}

/// Returns a label, in quotes if needed: a '_' without quotes would be read as a blank.
std::string label(std::string_view text) {
  bool plain = !text.empty();
  for (const char c : text) plain = plain && isPlain(c);
  if (plain) return std::string(text);
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
  return quoted + "'";
}

/// Removes the characters that have a meaning in a comment of this kind.
std::string commentValue(std::string_view text) {
  std::string value(text);
  for (char& c : value)
    if (std::string_view("[]:=,;()'\"").find(c) != std::string_view::npos) c = '_';
  return value;
}

class NewickWriter {
 public:
  NewickWriter(const ExportedRun& run, bool comments) : run_(run), comments_(comments) {}

  /// Returns the tree of the cell and all its descendants, up to depth CellPath::maxDepth.
  std::string subtree(const LineageEntry& cell) const {
    std::string text;
    if (cell.path.depth() < CellPath::maxDepth)
      for (const bool b : {false, true})
        if (const int daughter = run_.cellNumber(cell.path.daughter(b)); daughter >= 0)
          text += (text.empty() ? "(" : ",") + subtree(run_.results.lineage[static_cast<std::size_t>(daughter)]);
    if (!text.empty()) text += ')';
    const double end = cell.fate == Fate::alive ? run_.run.time : cell.ended;
    text += label(run_.nameOf(cell)) + ':' + exactText(end - cell.born);
    if (!comments_) return text;
    return text + "[&&NHX:path=" + (cell.path.isEgg() ? "egg" : cell.path.text()) + ":fate=" + name(cell.fate) +
           ":state=" + commentValue(run_.results.stateTexts.at(cell.state)) + ']';
  }

 private:
  const ExportedRun& run_;
  bool comments_;
};

}  // namespace

std::string newickTree(const ExportedRun& run, bool comments) {
  const NewickWriter writer(run, comments);
  std::vector<std::string> roots;
  for (const LineageEntry& cell : run.results.lineage)
    if (cell.path.isEgg() || run.cellNumber(cell.path.mother()) < 0) roots.push_back(writer.subtree(cell));
  if (roots.size() == 1) return roots[0] + ";\n";
  std::string text;
  for (const std::string& root : roots) text += (text.empty() ? "(" : ",") + root;
  return text + (text.empty() ? ";\n" : ");\n");
}

}  // namespace morula
