#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.h"
#include "base/random.h"
#include "catch.h"
#include "pictures.h"
#include "trees/lineage_tree.h"

namespace morula {
namespace {

/// Adds a cell and its descendants; chance decides whether a cell divides.
void grow(std::vector<LineageNode>& nodes, const std::string& path, double born, std::uint64_t seed) {
  const std::uint32_t lot = randomWords({seed, CellPath::parse(path), 0, Purpose::test}, 0)[0];
  const bool divides = path.size() < 7 && lot % 4 != 0;
  const Fate fate = divides ? Fate::divided : lot % 8 ? Fate::alive : Fate::died;
  nodes.push_back({path, born, born + 1 + (lot >> 8) % 3, fate, red, ""});
  if (!divides) return;
  const double end = nodes.back().ended;
  grow(nodes, path + "A", end, seed);
  grow(nodes, path + "B", end, seed);
}

LineageNode cell(const char* path, double born = 0, double ended = 1) {
  return {path, born, ended, Fate::alive, red, ""};
}

}  // namespace

TEST_CASE("leaves stand side by side, A left of B, mothers between their daughters", "[tree]") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    std::vector<LineageNode> nodes;
    grow(nodes, "", 0, seed);
    std::rotate(nodes.begin(), nodes.begin() + nodes.size() / 3, nodes.end());
    const TreeLayout layout = layoutTree(nodes);
    REQUIRE(layout.places.size() == nodes.size());
    std::set<double> taken;
    std::size_t leaves = 0;
    for (const TreePlace& place : layout.places) {
      if (place.isLeaf()) {
        REQUIRE(taken.insert(place.x).second);
        ++leaves;
      } else {
        const TreePlace &a = layout.places[place.daughter[0]], &b = layout.places[place.daughter[1]];
        REQUIRE(a.x < place.x);
        REQUIRE(place.x < b.x);
        REQUIRE(a.node->path == place.node->path + "A");
        REQUIRE(b.node->path == place.node->path + "B");
        REQUIRE(&layout.places[a.mother] == &place);
        REQUIRE(place.leaves == a.leaves + b.leaves);
      }
    }
    REQUIRE(layout.leaves == leaves);
    REQUIRE(*taken.begin() == 0.5);
    REQUIRE(*taken.rbegin() == double(leaves) - 0.5);
    for (const TreePlace& one : layout.places)  // whole subtrees are separate, not only daughters
      for (const TreePlace& other : layout.places)
        if (one.isLeaf() && other.isLeaf() && one.node->path < other.node->path) REQUIRE(one.x < other.x);
  }
}

TEST_CASE("cells without a mother in the list hang alone", "[tree]") {
  const std::vector<LineageNode> nodes{cell("AB"), cell("ABBA", 0, 2), cell("B")};
  const TreeLayout layout = layoutTree(nodes);
  REQUIRE(layout.leaves == 3);
  for (const TreePlace& place : layout.places) REQUIRE(place.mother == -1);
}

TEST_CASE("an only daughter hangs straight down", "[tree]") {
  const std::vector<LineageNode> nodes{cell(""), cell("B")};
  const TreeLayout layout = layoutTree(nodes);
  REQUIRE(layout.leaves == 1);
  REQUIRE(layout.places[0].x == layout.places[1].x);
}

TEST_CASE("no cells, no tree", "[tree]") {
  REQUIRE(layoutTree({}).places.empty());
  REQUIRE(layoutTree({}).leaves == 0);
}

TEST_CASE("trees that cannot be are refused", "[tree]") {
  const auto refused = [](const std::vector<LineageNode>& nodes, const char* word) {
    REQUIRE_THROWS_AS(layoutTree(nodes), InputError);
    REQUIRE_THROWS_WITH(layoutTree(nodes), ContainsSubstring(word));
  };
  refused({cell("AC")}, "'AC'");
  refused({cell("A"), cell("B"), cell("A")}, "twice");
  refused({cell("A", 2, 1)}, "before it is born");
  refused({cell("A", NAN)}, "not finite");
  refused({cell("A", 0, INFINITY)}, "not finite");
}

}  // namespace morula
