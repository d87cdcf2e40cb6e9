#include "biology/lineage.h"

#include "catch.h"

using namespace morula;

namespace {

LineageEntry entry(const char* path, Fate fate) {
  LineageEntry e;
  e.path = CellPath::parse(path);
  e.fate = fate;
  return e;
}

// Returns a lineage in order of birth: B divided before A did, and AB died.
Lineage smallLineage() {
  return {{entry("", Fate::divided), entry("A", Fate::divided), entry("B", Fate::divided), entry("BA", Fate::alive),
           entry("BB", Fate::alive), entry("AA", Fate::alive), entry("AB", Fate::died)}};
}

}  // namespace

TEST_CASE("fates have the names that the database holds") {
  CHECK(name(Fate::alive) == std::string("alive"));
  CHECK(name(Fate::divided) == std::string("divided"));
  CHECK(name(Fate::died) == std::string("died"));
}

TEST_CASE("cells are ordered, found and filtered by path") {
  const Lineage lineage = smallLineage();
  const auto order = orderByPath(lineage);
  CHECK(order == std::vector<std::uint32_t>{0, 1, 5, 6, 2, 3, 4});
  for (const LineageEntry& e : lineage.entries) CHECK(find(lineage, order, e.path) == &e);
  CHECK(find(lineage, order, CellPath::parse("AAA")) == nullptr);
  CHECK(find(lineage, order, CellPath::parse("BBB")) == nullptr);
  CHECK(leaves(lineage) == std::vector<std::uint32_t>{5, 6, 3, 4});
  CHECK(orderByPath({}).empty());
  CHECK(find({}, {}, CellPath{}) == nullptr);
}
