// The neighbour list equals what a test of all pairs finds.
#include <algorithm>
#include <map>

#include "catch.h"
#include "crowd.h"

using namespace morula;

namespace {

using ListsByVertex = std::map<VertexNumber, std::vector<VertexNumber>>;

/// Returns the lists that a test of all pairs gives.
ListsByVertex bruteForce(const Bodies& b, const AlignedVector<double>& radius, double skin,
                         const ContactParameters& law = {}) {
  ListsByVertex lists;
  const std::vector<SeenVertex> points = seen(b, law);
  const auto at = [&](int slot, int v) { return points[std::size_t(slot) * b.vertexCount() + v].x; };
  for (int s = 0; s < b.count; ++s)
    for (int v = 0; v < b.vertexCount(); ++v) {
      auto& own = lists[numberOf(b, s, v)];
      for (int t = 0; t < b.count; ++t)
        for (int w = 0; w < b.vertexCount(); ++w) {
          const double reach = 0.5 * (radius[s] + radius[t]) + skin;
          if (s != t && norm(at(s, v) - at(t, w)) < reach) own.push_back(numberOf(b, t, w));
        }
      std::sort(own.begin(), own.end());
    }
  return lists;
}

ListsByVertex listsByVertex(const NeighbourList& list, const Bodies& b) {
  ListsByVertex lists;
  for (int s = 0; s < b.count; ++s)
    for (int v = 0; v < b.vertexCount(); ++v) lists[numberOf(b, s, v)] = neighboursOf(list, numberOf(b, s, v));
  return lists;
}

std::size_t pairsIn(const ListsByVertex& lists) {
  std::size_t pairs = 0;
  for (const auto& [g, neighbours] : lists) pairs += neighbours.size();
  return pairs;
}

}  // namespace

TEST_CASE("The list holds the pairs within reach and no others, for cells of different sizes, heaped or strewn") {
  for (Isa isa : availableIsas())
    for (int count : {1, 2, 7, 8, 9, 17})
      for (double spacing : {0.1, 1.0, 1.8, 300.0}) {
        Crowd crowd(limp(), {}, ball, heap(ball, count, spacing, 0), isa);
        const Bodies& b = crowd.lab.bodies;
        const ListsByVertex expected = bruteForce(b, crowd.contacts.radius, crowd.contacts.list.skin);
        CAPTURE(name(isa), count, spacing);
        CHECK((listsByVertex(crowd.contacts.list, b) == expected));
        CHECK(crowd.contacts.list.pairs == pairsIn(expected));
        if (count > 2 && spacing < 2) CHECK(pairsIn(expected) > 100);
      }
}

TEST_CASE("After moves of less than half the skin the list still holds every pair within reach") {
  Crowd crowd(limp(), {}, ball, heap(ball, 9, 1.8, 0));
  Bodies& b = crowd.lab.bodies;
  const double skin = crowd.contacts.list.skin;
  const auto rebuilds = crowd.contacts.rebuilds;
  const ListsByVertex before = listsByVertex(crowd.contacts.list, b);
  for (int s = 0; s < b.count; ++s)
    for (int v = 0; v < b.vertexCount(); ++v) {
      const Vector way = noiseVector(static_cast<std::uint32_t>(100 * s + v), 77);
      crowd.lab.setPosition(s, v, b.vertex(s, v) + (0.499 * skin / norm(way)) * way);
    }
  crowd.evaluateForces();
  CHECK(crowd.contacts.rebuilds == rebuilds);
  int missing = 0;
  for (const auto& [g, near] : bruteForce(b, crowd.contacts.radius, 0)) {
    const auto& list = before.at(g);
    for (VertexNumber other : near) missing += !std::binary_search(list.begin(), list.end(), other);
  }
  CHECK(missing == 0);
}

TEST_CASE("One vertex that moves by half the skin renews the list") {
  for (int slot : {0, 8}) {
    Crowd crowd(limp(), {}, ball, heap(ball, 9, 1.8, 0));
    Bodies& b = crowd.lab.bodies;
    const auto rebuilds = crowd.contacts.rebuilds;
    crowd.lab.setPosition(
        slot, 41,
        b.vertex(slot, 41) + Vector{0, 0.501 / 0.875 * crowd.contacts.list.skin, 0});  // a surface follows by 0.875
    crowd.evaluateForces();
    CHECK(crowd.contacts.rebuilds == rebuilds + 1);
    CHECK((listsByVertex(crowd.contacts.list, b) == bruteForce(b, crowd.contacts.radius, crowd.contacts.list.skin)));
  }
}

TEST_CASE("Random moves, step after step: the list is right each time it is new") {
  // Contacts are so weak that they do not throw vertices farther than the skin in a step.
  Crowd crowd(limp(), {ContactLaw::pair, 0.3, 0}, ball, heap(ball, 9, 1.8, 3));
  Bodies& b = crowd.lab.bodies;
  std::uint64_t rebuilds = crowd.contacts.rebuilds;
  int renewed = 0;
  for (int i = 0; i < 100; ++i) {
    crowd.step(0x1p-8);
    if (crowd.contacts.rebuilds == rebuilds) continue;
    rebuilds = crowd.contacts.rebuilds;
    ++renewed;
    CHECK((listsByVertex(crowd.contacts.list, b) == bruteForce(b, crowd.contacts.radius, crowd.contacts.list.skin)));
  }
  CHECK(renewed > 5);
  CHECK(renewed < 100);
}

TEST_CASE("Forces do not depend on when the list was built: the same bits if it is built at each step") {
  PhysicsParameters p = softCell();
  p.membrane = {40, 0.05, 1.26};
  p.pressure = {4, 0};
  for (const ContactParameters& law : {ContactParameters{}, ContactParameters{ContactLaw::pair, 40, 0.05, 0.3},
                                       ContactParameters{ContactLaw::thesis}}) {
    auto cells = heap(ball, 9, 1.8, 0.5);
    for (Body& b : cells) b.pressureConstant = 4 * b.mass;
    Crowd lazy(p, law, ball, cells), eager(p, law, ball, cells);
    for (int i = 0; i < 200; ++i) {
      eager.contacts.listIsValid = false;
      lazy.step(0x1p-9);
      eager.step(0x1p-9);
    }
    CHECK(lazy.lab.bodies.position == eager.lab.bodies.position);
    CHECK(lazy.lab.bodies.acceleration == eager.lab.bodies.acceleration);
    CHECK(eager.contacts.rebuilds == 201);
    CHECK(lazy.contacts.rebuilds < 150);
  }
}

TEST_CASE("Two threads build the list that one does") {
  Crowd crowd(limp(), {}, ball, heap(ball, 33, 1.8, 0));
  const auto indices = indicesOf(crowd.contacts.list);
  for (int threads : {2, 3, 7}) {
    crowd.contacts.listIsValid = false;
    refreshList(crowd.contacts, crowd.lab.bodies, threads);
    CHECK(indicesOf(crowd.contacts.list) == indices);
  }
}

TEST_CASE("Whether lists are too long, and whose, does not depend on the number of threads") {
  Crowd crowd(limp(), {}, ball, heap(ball, 25, 0.8, 0));
  NeighbourList& list = crowd.contacts.list;
  const double whole = double(list.pairs) * list.bytesPerNeighbour;
  int refused = 0, taken = 0;
  for (double share = 0.1; share < 4; share *= 1.4) {
    list.maxBytes = share * whole;
    std::vector<int> blocks;
    for (const int threads : {1, 2, 3, 8}) {
      try {
        buildNeighbourList(list, crowd.lab.bodies, crowd.contacts.radius, threads);
        blocks.push_back(-1);
      } catch (const ListsTooLong& lists) { blocks.push_back(lists.block); }
    }
    CAPTURE(share, blocks);
    CHECK(blocks == std::vector<int>(4, blocks[0]));
    ++(blocks[0] < 0 ? taken : refused);
  }
  CHECK((refused > 1 && taken > 1));
}
