// The oracle for rings is brute force over all faces.
#include "mesh/connectivity.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "catch.h"
#include "zoo.h"

using namespace morula;

namespace {

bool hasFaceCorner(const Mesh& m, int i, int from, int to) {
  for (const Face& f : m.faces)
    for (int k = 0; k < 3; ++k)
      if (f[k] == i && f[(k + 1) % 3] == from && f[(k + 2) % 3] == to) return true;
  return false;
}

}  // namespace

TEST_CASE("Every closed mesh has the Euler characteristic of its handles, and three edges per two faces") {
  for (const auto& [name, mesh, handles] : zoo::all()) {
    CAPTURE(name);
    const Connectivity c = makeConnectivity(mesh);
    CHECK(c.vertexCount == static_cast<int>(mesh.vertices.size()));
    CHECK(c.edgeCount == static_cast<int>(c.edges.size()));
    CHECK(c.vertexCount - c.edgeCount + static_cast<int>(c.faces.size()) == 2 - 2 * handles);
    CHECK(2 * c.edges.size() == 3 * c.faces.size());
    CHECK(c.faces == mesh.faces);
  }
}

TEST_CASE("Edges are sorted, the smaller index first, and are the pairs that the faces hold, each twice") {
  for (const auto& [name, mesh, handles] : zoo::all()) {
    CAPTURE(name);
    const Connectivity c = makeConnectivity(mesh);
    std::multiset<std::array<int, 2>> sides;
    for (const Face& f : mesh.faces)
      for (int k = 0; k < 3; ++k) sides.insert({std::min(f[k], f[(k + 1) % 3]), std::max(f[k], f[(k + 1) % 3])});
    CHECK(std::is_sorted(c.edges.begin(), c.edges.end()));
    CHECK(std::set<std::array<int, 2>>(c.edges.begin(), c.edges.end()).size() == c.edges.size());
    CHECK(sides.size() == 2 * c.edges.size());
    for (const auto& e : c.edges) {
      REQUIRE(e[0] < e[1]);
      REQUIRE(sides.count(e) == 2);
    }
  }
}

TEST_CASE("The ring of a vertex is its link, counter-clockwise, from the smallest neighbour on") {
  for (const auto& [name, mesh, handles] : zoo::all()) {
    if (mesh.vertices.size() > 700) continue;  // the oracle is quadratic
    CAPTURE(name);
    const Connectivity c = makeConnectivity(mesh);
    REQUIRE(c.ringStart.size() == mesh.vertices.size() + 1);
    REQUIRE(c.ringStart.front() == 0);
    REQUIRE(c.ringStart.back() == 2 * c.edgeCount);
    REQUIRE(c.ringVertex.size() == static_cast<std::size_t>(2 * c.edgeCount));
    REQUIRE(c.ringEdge.size() == c.ringVertex.size());
    for (int i = 0; i < c.vertexCount; ++i) {
      const std::vector<int> ring(c.ringVertex.begin() + c.ringStart[i], c.ringVertex.begin() + c.ringStart[i + 1]);
      std::set<int> link;
      for (const Face& f : mesh.faces)
        if (std::count(f.begin(), f.end(), i))
          for (int v : f)
            if (v != i) link.insert(v);
      REQUIRE(std::set<int>(ring.begin(), ring.end()) == link);
      REQUIRE(ring.size() == link.size());
      REQUIRE(ring.front() == *link.begin());
      for (std::size_t k = 0; k < ring.size(); ++k)
        REQUIRE(hasFaceCorner(mesh, i, ring[k], ring[(k + 1) % ring.size()]));
    }
  }
}

TEST_CASE("The edge beside a neighbour joins it to the vertex, and each edge stands in two rings") {
  for (const auto& [name, mesh, handles] : zoo::all()) {
    CAPTURE(name);
    const Connectivity c = makeConnectivity(mesh);
    std::vector<int> uses(c.edgeCount, 0);
    for (int i = 0; i < c.vertexCount; ++i)
      for (int k = c.ringStart[i]; k < c.ringStart[i + 1]; ++k) {
        const auto& e = c.edges[c.ringEdge[k]];
        REQUIRE(std::set<int>{e[0], e[1]} == std::set<int>{i, c.ringVertex[k]});
        ++uses[c.ringEdge[k]];
      }
    CHECK(std::all_of(uses.begin(), uses.end(), [](int n) { return n == 2; }));
  }
}

TEST_CASE("Rings turn counter-clockwise seen from outside") {
  // On a sphere about the origin, outside is the direction of the vertex itself.
  const Mesh m = makeIcosphere(2);
  const Connectivity c = makeConnectivity(m);
  for (int i = 0; i < c.vertexCount; ++i)
    for (int k = c.ringStart[i]; k < c.ringStart[i + 1]; ++k) {
      const int next = k + 1 < c.ringStart[i + 1] ? k + 1 : c.ringStart[i];
      const Point &here = m.vertices[i], &a = m.vertices[c.ringVertex[k]], &b = m.vertices[c.ringVertex[next]];
      REQUIRE(dot(here, cross(a - here, b - here)) > 0);
    }
}

TEST_CASE("A mesh that no ring could describe is a bug of the caller") {
  Mesh open = zoo::tetrahedron();
  open.faces.pop_back();
  CHECK_THROWS_AS(makeConnectivity(open), BugError);
  Mesh loose = zoo::tetrahedron();
  loose.vertices.push_back({9, 9, 9});
  CHECK_THROWS_AS(makeConnectivity(loose), BugError);
  Mesh turned = zoo::tetrahedron();
  std::swap(turned.faces[2][0], turned.faces[2][1]);
  CHECK_THROWS_AS(makeConnectivity(turned), BugError);
}
