// The list of connections: making, releasing, and the record.
#include "connections/connections.h"

#include "catch.h"

using namespace morula;

namespace {

CellPath cell(const char* path) { return CellPath::parse(path); }

std::vector<std::string> partnersOf(const Connections& c, const char* path) {
  std::vector<std::string> texts;
  for (const CellPath& p : partners(c, cell(path))) texts.push_back(p.text());
  return texts;
}

}  // namespace

TEST_CASE("A connection holds both ways round and is recorded once, the smaller path first") {
  Connections c;
  CHECK_FALSE(areConnected(c, cell("A"), cell("B")));
  connect(c, cell("B"), cell("A"), 1.5);
  CHECK(areConnected(c, cell("A"), cell("B")));
  CHECK(areConnected(c, cell("B"), cell("A")));
  connect(c, cell("A"), cell("B"), 2.5);
  REQUIRE(c.history.size() == 1);
  CHECK(c.history[0].a == cell("A"));
  CHECK(c.history[0].b == cell("B"));
  CHECK(c.history[0].made == 1.5);
  CHECK(c.history[0].released < 0);
  CHECK(c.history[0].cause == ReleaseCause::none);
}

TEST_CASE("A released connection stays on record, with time and cause; a new one is a new record") {
  Connections c;
  connect(c, cell("A"), cell("B"), 1);
  release(c, cell("B"), cell("A"), 2, ReleaseCause::gene);
  CHECK_FALSE(areConnected(c, cell("A"), cell("B")));
  release(c, cell("A"), cell("B"), 3, ReleaseCause::died);  // releasing an absent connection does nothing
  REQUIRE(c.history.size() == 1);
  CHECK(c.history[0].released == 2);
  CHECK(c.history[0].cause == ReleaseCause::gene);
  connect(c, cell("A"), cell("B"), 4);
  REQUIRE(c.history.size() == 2);
  CHECK(c.history[1].made == 4);
  CHECK(c.active == std::vector<std::size_t>{1});
}

TEST_CASE("Partners come in order of their paths, and a cell that dies loses them all") {
  Connections c;
  for (const char* other : {"BB", "A", "BAB", "BAA"}) connect(c, cell("AB"), cell(other), 0);
  connect(c, cell("A"), cell("BB"), 0);
  CHECK(partnersOf(c, "AB") == std::vector<std::string>{"A", "BAA", "BAB", "BB"});
  CHECK(partnersOf(c, "BAA") == std::vector<std::string>{"AB"});
  CHECK(partnersOf(c, "BBB").empty());
  releaseAll(c, cell("AB"), 7, ReleaseCause::died);
  CHECK(partnersOf(c, "AB").empty());
  CHECK(partnersOf(c, "A") == std::vector<std::string>{"BB"});
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(c.history[i].released == 7);
    CHECK(c.history[i].cause == ReleaseCause::died);
  }
}

TEST_CASE("The active list is sorted by pair, in whatever order connections were made") {
  Connections forward, backward;
  const std::vector<std::pair<const char*, const char*>> pairs{{"A", "BA"}, {"A", "BB"}, {"BA", "BB"}, {"AA", "B"}};
  for (const auto& [a, b] : pairs) connect(forward, cell(a), cell(b), 0);
  for (auto p = pairs.rbegin(); p != pairs.rend(); ++p) connect(backward, cell(p->second), cell(p->first), 0);
  REQUIRE(forward.active.size() == backward.active.size());
  for (std::size_t i = 0; i < forward.active.size(); ++i) {
    CHECK(forward.history[forward.active[i]].a == backward.history[backward.active[i]].a);
    CHECK(forward.history[forward.active[i]].b == backward.history[backward.active[i]].b);
  }
}

TEST_CASE("A cell connected to itself is a bug") {
  Connections c;
  CHECK_THROWS_AS(connect(c, cell("A"), cell("A"), 0), BugError);
}
