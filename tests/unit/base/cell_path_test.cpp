// The oracle is the order of std::string: a mother is a prefix of her daughters, and A < B.
#include "base/cell_path.h"

#include <algorithm>
#include <vector>

#include "catch.h"

using namespace morula;

namespace {

std::vector<std::string> textsUpTo(int depth) {
  std::vector<std::string> texts = {""};
  for (std::size_t i = 0; i < texts.size(); ++i)
    if (static_cast<int>(texts[i].size()) < depth)
      for (char c : {'A', 'B'}) texts.push_back(texts[i] + c);
  return texts;
}

// Paths on either side of the border between the two words that hold the letters.
std::vector<std::string> textsAtTheBorder() {
  std::vector<std::string> texts;
  for (const std::string& begin : {std::string(62, 'A'), std::string(62, 'B'), std::string(61, 'A') + "B"})
    for (const std::string& end : textsUpTo(4)) texts.push_back(begin + end);
  for (int depth : {119, 120})
    for (char c : {'A', 'B'}) texts.push_back(std::string(depth, c));
  return texts;
}

std::vector<std::string> manyTexts() {
  auto texts = textsUpTo(5);
  const auto more = textsAtTheBorder();
  texts.insert(texts.end(), more.begin(), more.end());
  return texts;
}

}  // namespace

TEST_CASE("A path is read, written, descended and climbed") {
  for (const std::string& text : manyTexts()) {
    CAPTURE(text);
    const CellPath path = CellPath::parse(text);
    REQUIRE(path.text() == text);
    REQUIRE(path.depth() == static_cast<int>(text.size()));
    REQUIRE(path.isEgg() == text.empty());
    for (std::size_t i = 0; i < text.size(); ++i) REQUIRE(path.letter(i) == (text[i] == 'B'));
    if (text.size() < CellPath::maxDepth)
      for (bool b : {false, true}) {
        REQUIRE(path.daughter(b).text() == text + (b ? 'B' : 'A'));
        REQUIRE(path.daughter(b).mother() == path);
      }
    if (!text.empty()) REQUIRE(path.mother().text() == text.substr(0, text.size() - 1));
  }
}

TEST_CASE("Paths are ordered as their texts, equal only to themselves") {
  const auto texts = manyTexts();
  for (const std::string& a : texts)
    for (const std::string& b : texts) {
      const CellPath p = CellPath::parse(a), q = CellPath::parse(b);
      if ((p < q) != (a < b) || (p == q) != (a == b)) FAIL("'" << a << "' and '" << b << "'");
    }
}

TEST_CASE("A cell is the ancestor of those whose text begins with its own, itself among them") {
  const auto texts = manyTexts();
  for (const std::string& a : texts)
    for (const std::string& b : texts)
      if (CellPath::parse(a).isAncestorOf(CellPath::parse(b)) != b.starts_with(a))
        FAIL("'" << a << "' and '" << b << "'");
}

TEST_CASE("A subtree is one range of the sorted paths, with its mother at the front") {
  std::vector<CellPath> paths;
  for (const std::string& text : manyTexts()) paths.push_back(CellPath::parse(text));
  std::sort(paths.begin(), paths.end());
  for (const CellPath& root : paths) {
    const auto within = [&root](const CellPath& p) { return root.isAncestorOf(p); };
    const auto first = std::find_if(paths.begin(), paths.end(), within);
    REQUIRE(*first == root);
    const auto end = std::find_if_not(first, paths.end(), within);
    REQUIRE(std::none_of(end, paths.end(), within));
  }
}

TEST_CASE("A line of descent ends at 120 divisions, with an error and not with a wrong name") {
  const CellPath deepest = CellPath::parse(std::string(120, 'B'));
  CHECK(deepest.depth() == CellPath::maxDepth);
  CHECK_THROWS_AS(deepest.daughter(false), InputError);
  CHECK_THROWS_WITH(deepest.daughter(true), ContainsSubstring("at most 120 divisions"));
  CHECK_THROWS_AS(CellPath::parse(std::string(121, 'A')), InputError);
}

TEST_CASE("Only A and B name daughters") {
  for (const char* text : {"a", "AC", "A B", " ", "AB\n", "0", "Ä"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(CellPath::parse(text), InputError);
  }
  CHECK_THROWS_WITH(CellPath::parse("ABX"), ContainsSubstring("\"ABX\"") && ContainsSubstring("A and B"));
  CHECK_THROWS_AS(CellPath{}.mother(), BugError);
}
