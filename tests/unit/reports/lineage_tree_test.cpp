#include "trees/lineage_tree.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "catch.h"
#include "pictures.h"

namespace morula {
namespace {

/// Returns a tree in which every cell divides until there are 2^depth leaves; each cell lives one time unit.
TreePicture fullTree(int depth) {
  TreePicture tree;
  std::vector<std::string> level{""};
  for (int d = 0; d <= depth; ++d) {
    std::vector<std::string> next;
    for (const std::string& path : level) {
      tree.nodes.push_back({.path = path,
                            .born = double(d),
                            .ended = d + 1.0,
                            .fate = d == depth ? Fate::alive : Fate::divided,
                            .colour = path.empty()     ? neutralGrey
                                      : path[0] == 'A' ? red
                                                       : blue,
                            .label = fmt::format("s{}", d)});
      next.push_back(path + "A");
      next.push_back(path + "B");
    }
    level = next;
  }
  return tree;
}

}  // namespace

TEST_CASE("branch A is drawn left of branch B, each in its colour", "[lineage]") {
  const Image image = drawLineage(fullTree(2)).pixels();
  const Extent reds = extentOf(image, [](Colour c) { return c == red; }),
               blues = extentOf(image, [](Colour c) { return c == blue; });
  REQUIRE(reds.left < reds.right);
  REQUIRE(reds.right < blues.left);
  REQUIRE(blues.left < blues.right);
  REQUIRE(countPixels(image, neutralGrey) > 100);
}

TEST_CASE("the tree is the same in whatever order its cells are given", "[lineage]") {
  TreePicture tree = fullTree(4);
  const Image first = drawLineage(tree).pixels();
  REQUIRE(drawLineage(tree).pixels() == first);
  std::reverse(tree.nodes.begin(), tree.nodes.end());
  REQUIRE(drawLineage(tree).pixels() == first);
}

TEST_CASE("1024 leaves keep their colours", "[lineage]") {
  const Image image = drawLineage(fullTree(10)).pixels();
  REQUIRE(image.width <= 2000);
  const int bottom = image.height - 60;  // among the leaves
  int reddish = 0, bluish = 0;
  for (int x = 0; x < image.width; ++x) {
    const Colour c = image.at(x, bottom);
    reddish += c.r > c.b + 40;
    bluish += c.b > c.r + 40;
  }
  REQUIRE(reddish > 0.4 * image.width);
  REQUIRE(bluish > 0.4 * image.width);
}

TEST_CASE("death is marked", "[lineage]") {
  TreePicture tree = fullTree(1);
  const Image living = drawLineage(tree).pixels();
  tree.nodes[1].fate = Fate::died;
  tree.nodes[1].ended = 1.5;
  const Image dead = drawLineage(tree).pixels();
  // Counts dark ink of the cross where the other picture has none.
  const auto dark = [](Colour c) { return brightness(c) < 200; };
  int crosses = 0;
  for (int y = 100; y < living.height - 120; ++y)
    for (int x = 100; x < living.width / 2; ++x) crosses += dark(dead.at(x, y)) && !dark(living.at(x, y));
  REQUIRE(crosses > 10);
}

TEST_CASE("few leaves are labelled, many are not", "[lineage]") {
  for (const auto& [depth, labelled] : {std::pair{3, true}, {5, true}, {6, false}}) {
    TreePicture tree = fullTree(depth);
    tree.width = 1600, tree.height = 900;
    const Image image = drawLineage(tree).pixels();
    for (LineageNode& node : tree.nodes)
      if (node.label == fmt::format("s{}", depth)) node.label = "X9";
    REQUIRE((drawLineage(tree).pixels() != image) == labelled);
  }
}

TEST_CASE("one cell is a line, and none is paper", "[lineage]") {
  TreePicture one;
  one.nodes = {{"", 0, 3, Fate::alive, red, "a0"}};
  REQUIRE(countPixels(drawLineage(one), red) > 300);
  one.nodes[0].ended = 0;  // before the first step
  REQUIRE_NOTHROW(drawLineage(one));
  const Image none = drawLineage({}).pixels();
  REQUIRE(countPixels(none, isInk) == 0);
}

TEST_CASE("sizes are kept or refused", "[lineage]") {
  TreePicture tree = fullTree(3);
  tree.width = 333, tree.height = 222;
  const Drawing drawing = drawLineage(tree);
  REQUIRE(drawing.width() == 333);
  REQUIRE(drawing.height() == 222);
  for (const auto& [w, h] : {std::pair{63, 500}, {500, 16385}, {-1, 500}}) {
    tree.width = w, tree.height = h;
    REQUIRE_THROWS_AS(drawLineage(tree), InputError);
  }
}

}  // namespace morula
