// All search methods find the same pairs: the pairs within reach.
#include <algorithm>
#include <limits>

#include "catch.h"
#include "contacts/any_search.h"
#include "crowd.h"

using namespace morula;

namespace {

const Mesh cube = zoo::box({-0.6, -0.6, -0.6}, {0.6, 0.6, 0.6});

/// Returns the neighbours of each vertex, by vertex number, as the kernels of the laws read them.
using Lists = std::vector<std::vector<VertexNumber>>;

Lists listsOf(const NeighbourList& list, const Bodies& b) {
  Lists lists(std::size_t(b.blockCount()) * b.vertexCount() * blockLanes);
  for (std::size_t g = 0; g < lists.size(); ++g) lists[g] = neighboursOf(list, static_cast<VertexNumber>(g));
  return lists;
}

/// Counts faults of lists: pairs within reach that are missing, pairs beyond reach, and disorder. Pairs at the edge of
/// reach may be listed or not.
struct Expected {
  const Bodies& b;
  const AlignedVector<double>& radius;
  double skin;

  int faults(const Lists& lists) const {
    int faults = 0;
    for (int s = 0; s < b.count; ++s)
      for (int v = 0; v < b.vertexCount(); ++v) {
        const auto& own = lists[numberOf(b, s, v)];
        faults += !std::is_sorted(own.begin(), own.end());
        faults += std::adjacent_find(own.begin(), own.end()) != own.end();
        for (int t = 0; t < b.count; ++t)
          for (int w = 0; w < b.vertexCount(); ++w) {
            const Vector apart = b.vertex(s, v) - b.vertex(t, w);
            const double reach = 0.5 * (radius[s] + radius[t]) + skin, distance = norm(apart);
            const bool listed = std::binary_search(own.begin(), own.end(), numberOf(b, t, w));
            if (s == t || !(distance < 1.00001 * reach)) faults += listed;
            else if (distance < reach) faults += !listed;
          }
      }
    return faults;
  }
};

/// Builds the list anew for the cells' present positions.
void renew(NeighbourList& list, const Crowd& crowd, int threads = 1) {
  list.skin = crowd.contacts.list.skin;
  list.reference = crowd.lab.bodies.position;
  buildNeighbourList(list, crowd.lab.bodies, crowd.contacts.radius, threads);
}

NeighbourList searched(ContactSearch search, Isa isa, const Crowd& crowd, int threads = 1) {
  NeighbourList list = makeNeighbourList(search, isa);
  renew(list, crowd, threads);
  return list;
}

std::vector<NeighbourList> oneOfEachSearch() {
  std::vector<NeighbourList> lists;
  for (ContactSearch search : valuesOf<ContactSearch>()) lists.push_back(makeNeighbourList(search, bestIsa()));
  return lists;
}

/// Returns how many combinations of search, instruction set and number of threads differ from brute force.
int differences(const Crowd& crowd, const Lists& expected) {
  int different = 0;
  for (ContactSearch search : valuesOf<ContactSearch>())
    for (Isa isa : availableIsas())
      for (int threads : {1, 3}) {
        const NeighbourList list = searched(search, isa, crowd, threads);
        const bool same = listsOf(list, crowd.lab.bodies) == expected;
        if (!same) UNSCOPED_INFO(nameOf(search) << ' ' << name(isa) << ' ' << threads << " threads");
        different += !same;
      }
  return different;
}

Lists bruteForce(const Crowd& crowd) {
  return listsOf(searched(ContactSearch::bruteForce, Isa::scalar, crowd), crowd.lab.bodies);
}

std::size_t pairsIn(const Lists& lists) {
  std::size_t pairs = 0;
  for (const auto& list : lists) pairs += list.size();
  return pairs;
}

void check(const std::vector<Body>& cells, const Mesh& mesh, std::size_t atLeast) {
  const Crowd crowd(limp(), {}, mesh, cells);
  const Lists expected = bruteForce(crowd);
  CHECK(pairsIn(expected) >= atLeast);
  CHECK((Expected{crowd.lab.bodies, crowd.contacts.radius, crowd.contacts.list.skin}.faults(expected) == 0));
  CHECK(differences(crowd, expected) == 0);
}

std::vector<Body> moved(std::vector<Body> cells, const Vector& by) {
  for (Body& b : cells)
    for (Point& x : b.position) x += by;
  return cells;
}

}  // namespace

TEST_CASE("Random crowds of cells of like sizes, dense to strewn") {
  for (int count : {2, 8, 9, 20})
    for (double spacing : {0.3, 1.6, 1.9, 300.0}) {
      CAPTURE(count, spacing);
      check(heap(ball, count, spacing, 0, 7), ball, spacing < 2 ? 20 : 0);
    }
}

TEST_CASE("Radii that differ by a factor of forty") {
  auto cells = heap(ball, 12, 1.7, 0);
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i].restScale = i % 3 == 0 ? 0.05 : i % 3 == 1 ? 0.4 : 2;
  check(cells, ball, 1000);
}

TEST_CASE("Other meshes: few vertices, many, and one with a hole") {
  check(heap(cube, 10, 1.1, 0), cube, 20);
  check(heap(makeIcosphere(2), 3, 1.8, 0), makeIcosphere(2), 100);
  const Mesh ring = zoo::scaled(zoo::torus(7, 5), {0.33, 0.33, 0.33});
  check(heap(ring, 9, 0.9, 0), ring, 100);
}

TEST_CASE("Cells at one place: vertices coincide, and everything is everybody's neighbour") {
  check(std::vector<Body>(9, shakenBody(ball, 0, 0)), ball, 9 * 42 * 8);
  std::vector<Body> points(9, shakenBody(ball, 0, 0));  // each cell in one point: lists are too long for a short sort
  for (Body& b : points)
    for (Point& x : b.position) x = {1, 2, 3};
  check(points, ball, 9 * 42 * 8 * 42);
}

TEST_CASE("One cell has no neighbours") { check({shakenBody(ball, 0.02, 0)}, ball, 0); }

TEST_CASE("Cells far from each other: memory and result do not depend on the distance") {
  for (double distance : {1e3, 1e6, 1e12}) {
    auto cells = heap(ball, 4, 1.8, 0);
    const auto other = moved(heap(ball, 4, 1.8, 0, 1), {distance, -distance / 3, distance / 7});
    cells.insert(cells.end(), other.begin(), other.end());
    CAPTURE(distance);
    check(cells, ball, 20);
    Crowd crowd(limp(), {}, ball, cells);
    CHECK(std::get<GridSearch>(crowd.contacts.list.search->way).start.size() < 5 * 8 * 42 + 100);
  }
}

TEST_CASE("Huge coordinates, where the distance of two numbers is a fair part of the reach") {
  for (double far : {1e6, 1e12, 1e14, 1e15}) {
    CAPTURE(far);
    check(moved(heap(ball, 9, 1.8, 0), {far, -far, far}), ball, 20);
  }
}

TEST_CASE("Vertices that are nowhere, or whose squares overflow, have no neighbours and do no harm to others") {
  for (double lost : {std::numeric_limits<double>::quiet_NaN(), double(INFINITY), -double(INFINITY), 1e200, -1e308}) {
    auto cells = heap(ball, 9, 1.8, 0);
    cells[0].position[0].x = -lost;
    cells[4].position[17] = {lost, lost, lost};
    cells[8].position[41].z = lost;
    for (Point& x : cells[3].position) x.y = lost;
    Crowd crowd(limp(), {}, ball, heap(ball, 9, 1.8, 0));
    setBodies(crowd.lab.bodies, cells);
    const Lists expected = bruteForce(crowd);
    CAPTURE(lost);
    CHECK(expected[numberOf(crowd.lab.bodies, 4, 17)].empty());
    CHECK(pairsIn(expected) > 100);
    CHECK(differences(crowd, expected) == 0);
  }
}

TEST_CASE("Points at the edges of bins") {
  // Vertices lie on a lattice of the bins' size, or a rounding or less beside it.
  std::vector<Body> cells(12, shakenBody(ball, 0, 0));
  Crowd probe(limp(), {}, ball, cells);
  const double reach = probe.contacts.radius[0] * (1 + 1e-6) + probe.contacts.list.skin;
  for (std::uint32_t c = 0; c < cells.size(); ++c)
    for (std::uint32_t v = 0; v < cells[c].position.size(); ++v) {
      const auto at = [&](int axis) {
        const double random = noise(3 * v + static_cast<std::uint32_t>(axis), c);
        const double step = std::floor(2.5 * (random + 1)) - 2;
        const int nudge = static_cast<int>(100 * (random + 1)) % 3 - 1;
        return std::nextafter(step * reach, nudge * INFINITY + (nudge == 0 ? step * reach : 0));
      };
      cells[c].position[v] = {at(0), at(1), at(2)};
    }
  const Crowd crowd(limp(), {}, ball, cells);
  const Lists expected = bruteForce(crowd);
  CHECK(pairsIn(expected) > 500);
  CHECK(differences(crowd, expected) == 0);
}

TEST_CASE("Pairs a hair within their reach and a hair beyond it, anywhere and in any direction") {
  // Each cell is one point in a chain: boxes are points, too, and bins lie at random.
  Crowd crowd(limp(), {}, cube, std::vector<Body>(9, shakenBody(cube, 0, 0)));
  const double reach = crowd.contacts.radius[0] * (1 + 1e-6) + crowd.contacts.list.skin;
  std::vector<NeighbourList> lists = oneOfEachSearch();
  int wrong = 0;
  for (double hair : {-1e-12, 1e-12})
    for (std::uint32_t key = 0; key < 1000; ++key) {
      const Vector random = noiseVector(0, key);
      const Vector direction = key % 4 == 0   ? Vector{1, 0, 0}
                               : key % 4 == 1 ? Vector{0, 1, 0}
                               : key % 4 == 2 ? Vector{0, 0, -1}
                                              : random / norm(random);
      std::vector<Body> cells(9, shakenBody(cube, 0, 0));
      for (int i = 0; i < 9; ++i) {
        // Bins begin at the outermost cell, so the first cell stands apart at random.
        const double along = i == 0 ? -20 - 3 * noise(1, key) : i * (1 + hair);
        for (Point& x : cells[i].position) x = along * reach * direction;
      }
      setBodies(crowd.lab.bodies, cells);
      for (NeighbourList& list : lists) {
        renew(list, crowd);
        wrong += list.pairs != (hair < 0 ? 7u * 2 * 8 * 8 : 0);
      }
    }
  CHECK(wrong == 0);
}

TEST_CASE("Cells on the move: trees that are refitted stay right, and are not built anew") {
  PhysicsParameters p = softCell();
  p.membrane = {40, 0.05, 1.26};
  auto cells = heap(ball, 9, 1.8, 3);
  for (Body& b : cells) b.pressureConstant = 4 * b.mass;
  Crowd crowd(p, {}, ball, cells);
  std::vector<NeighbourList> lists = oneOfEachSearch();
  int different = 0;
  for (int i = 0; i < 150; ++i) {
    crowd.step(0x1p-8);
    for (NeighbourList& list : lists) {
      renew(list, crowd);
      different += indicesOf(list) != indicesOf(lists[0]) || list.pairs != lists[0].pairs;
    }
    const Lists brute = listsOf(lists[3], crowd.lab.bodies);
    different += listsOf(lists[0], crowd.lab.bodies) != brute;
  }
  CHECK(different == 0);
  CHECK(lists[1].counters.treesBuilt == 1);
  CHECK(lists[1].counters.searches == 150);
}

TEST_CASE("A list serves crowds that grow and shrink, and another mesh") {
  for (ContactSearch search : valuesOf<ContactSearch>()) {
    NeighbourList list = makeNeighbourList(search, bestIsa());
    for (const Mesh& ball : {makeIcosphere(1), makeIcosphere(2), cube})
      for (int count : {9, 2, 17, 1}) {
        const Crowd crowd(limp(), {}, ball, heap(ball, count, 1.0, 0));
        renew(list, crowd);
        CAPTURE(nameOf(search), ball.vertices.size(), count);
        CHECK((listsOf(list, crowd.lab.bodies) == bruteForce(crowd)));
      }
  }
}

TEST_CASE("Counters tell the work: the same for every instruction set and number of threads") {
  const Crowd crowd(limp(), {}, ball, heap(ball, 27, 1.8, 0));
  const std::uint64_t cells = 27, vertices = 27 * 42;
  for (ContactSearch search : valuesOf<ContactSearch>()) {
    const SearchCounters one = searched(search, Isa::scalar, crowd).counters;
    CAPTURE(nameOf(search));
    CHECK(one.searches == 1);
    CHECK(one.pairs == pairsIn(bruteForce(crowd)));
    CHECK(one.distanceTests >= one.pairs);
    if (search == ContactSearch::bruteForce) CHECK(one.distanceTests == vertices * (cells - 1) * 42);
    else CHECK(one.distanceTests < vertices * (cells - 1) * 42 / 5);
    CHECK((search == ContactSearch::aabbTree ? one.rootTests : cells * (cells - 1)) == cells * (cells - 1));
    CHECK(one.boxTests >= one.rootTests);
    for (Isa isa : availableIsas())
      for (int threads : {1, 2, 7}) CHECK((searched(search, isa, crowd, threads).counters == one));
  }
}

TEST_CASE("Without a skin there is a search at every step, and the same motion") {
  auto cells = heap(ball, 9, 1.8, 0.5);
  PhysicsParameters p = softCell();
  for (Body& b : cells) b.pressureConstant = 4 * b.mass;
  Crowd lazy(p, {}, ball, cells), eager(p, {}, ball, cells);
  eager.contacts = makeContacts({}, Isa::scalar, {ContactSearch::aabbTree, 0});
  resetContacts(eager.contacts, eager.lab.bodies);
  lazy.step(0);
  eager.step(0);
  const auto before = lazy.contacts.rebuilds;
  for (int i = 0; i < 100; ++i) lazy.step(0x1p-9), eager.step(0x1p-9);
  CHECK(eager.contacts.rebuilds == 101);
  CHECK(lazy.contacts.rebuilds - before < 80);
  CHECK(lazy.lab.bodies.position == eager.lab.bodies.position);
}
