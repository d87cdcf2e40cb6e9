// One broken mesh for each kind of fault; the message is part of the behaviour.
#include <limits>

#include "catch.h"
#include "mesh/mesh.h"
#include "zoo.h"

using namespace morula;

namespace {

std::string complaintAbout(const Mesh& mesh) {
  try {
    checkClosedManifold(mesh, "m");
  } catch (const InputError& e) { return e.what(); }
  return "";
}

// Returns one mesh with the second mesh's vertices behind the first's.
Mesh joined(Mesh a, const Mesh& b) {
  const auto shift = static_cast<std::int32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Face& f : b.faces) a.faces.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
  return a;
}

// Returns the mesh with vertex `gone` merged into vertex `kept`; the last vertex takes its number.
Mesh merged(Mesh m, int kept, int gone) {
  const auto last = static_cast<std::int32_t>(m.vertices.size()) - 1;
  for (Face& f : m.faces)
    for (auto& i : f) i = i == gone ? kept : i == last ? gone : i;
  m.vertices[gone] = m.vertices[last];
  m.vertices.pop_back();
  return m;
}

}  // namespace

TEST_CASE("Every animal of the zoo is a closed manifold, at any size") {
  for (const auto& [name, mesh, handles] : zoo::all()) {
    CAPTURE(name);
    CHECK(complaintAbout(mesh) == "");
    CHECK(complaintAbout(zoo::scaled(mesh, {1e-30, 1e-30, 1e-30})) == "");
    CHECK(complaintAbout(zoo::scaled(mesh, {1e30, 1e30, 1e30})) == "");
  }
}

TEST_CASE("A hole is named by an edge, whichever face is missing") {
  for (std::size_t f = 0; f < 4; ++f) {
    Mesh m = zoo::tetrahedron();
    m.faces.erase(m.faces.begin() + f);
    CHECK_THAT(complaintAbout(m), ContainsSubstring("encloses nothing"));
  }
  const Mesh ball = makeIcosphere(1);
  for (std::size_t f = 0; f < ball.faces.size(); ++f) {
    Mesh m = ball;
    m.faces.erase(m.faces.begin() + f);
    const int a = std::min({ball.faces[f][0], ball.faces[f][1], ball.faces[f][2]});
    REQUIRE_THAT(complaintAbout(m),
                 ContainsSubstring("the edge between vertices " + std::to_string(a + 1) + " and ") &&
                     ContainsSubstring("only; a closed mesh has two faces at each edge: fill the hole"));
  }
}

TEST_CASE("Vertices that are not merged leave holes, and the message says so") {
  Mesh soup;
  for (const Face& f : zoo::tetrahedron().faces) {
    const auto base = static_cast<std::int32_t>(soup.vertices.size());
    for (int i : f) soup.vertices.push_back(zoo::tetrahedron().vertices[i]);
    soup.faces.push_back({base, base + 1, base + 2});
  }
  CHECK(complaintAbout(soup) ==
        "m: the edge between vertices 1 and 2 belongs to face 1 only; a closed mesh has two faces at each edge: fill "
        "the hole, or merge vertices that lie at the same place");
}

TEST_CASE("A turned face is named with its neighbour") {
  Mesh m = makeIcosphere(1);
  std::swap(m.faces[7][0], m.faces[7][1]);
  CHECK_THAT(complaintAbout(m), ContainsSubstring("face 8") && ContainsSubstring("turn opposite ways"));
}

TEST_CASE("An inner wall and a double face are named") {
  Mesh m = joined(zoo::tetrahedron(), {});
  m.vertices.push_back({0, 0, 0});
  m.faces.push_back({0, 1, 4});
  m.faces.push_back({1, 0, 4});
  CHECK(complaintAbout(m) ==
        "m: the edge between vertices 1 and 2 belongs to 4 faces (face 1, face 2, face 5, face 6); a closed mesh has "
        "two faces at each edge: remove inner walls and double faces");
  Mesh twice = zoo::tetrahedron();
  twice.faces.push_back(twice.faces[0]);
  CHECK_THAT(complaintAbout(twice), ContainsSubstring("belongs to 3 faces (face 1, face 2, face 5)"));
}

TEST_CASE("Two bodies that touch in one vertex have two fans there") {
  const Mesh two = joined(zoo::tetrahedron(), zoo::moved(zoo::tetrahedron(), {2, 2, 2}));
  CHECK_THAT(complaintAbout(merged(two, 0, 5)),
             ContainsSubstring("m: vertex 1: face ") && ContainsSubstring(" meet at this vertex alone"));
}

TEST_CASE("Two bodies in one mesh are refused") {
  CHECK(complaintAbout(joined(zoo::tetrahedron(), zoo::moved(zoo::tetrahedron(), {9, 9, 9}))) ==
        "m: face 5 is not connected to face 1; a cell is one piece: keep one closed surface per file");
  // A cavity is a second surface and is refused.
  CHECK_THAT(complaintAbout(joined(makeIcosphere(1), zoo::inverted(zoo::scaled(makeIcosphere(1), {0.5, 0.5, 0.5})))),
             ContainsSubstring("face 81 is not connected to face 1"));
}

TEST_CASE("Inverted and flat meshes have no inside") {
  for (const auto& [name, mesh, handles] : zoo::all()) {
    CAPTURE(name);
    CHECK_THAT(complaintAbout(zoo::inverted(mesh)),
               ContainsSubstring("all faces are inverted") && ContainsSubstring("flip the orientation"));
  }
  Mesh pillow{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 0}, {0.3, 0.3, 0}},
              {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}}};
  CHECK_THAT(complaintAbout(pillow), ContainsSubstring("the mesh is flat"));
  pillow.vertices[3].z = 0.001;
  CHECK(complaintAbout(pillow) == "");
}

TEST_CASE("A face without area is named") {
  Mesh m = zoo::tetrahedron();
  m.faces.push_back({0, 0, 1});
  CHECK(complaintAbout(m) == "m: face 5: vertex 1 occurs twice; the corners of a face are different vertices");
  Mesh flat = makeIcosphere(1);
  const auto [a, b, c] = flat.faces[3];
  flat.vertices[b] = (flat.vertices[a] + flat.vertices[c]) / 2.0;
  CHECK_THAT(complaintAbout(flat), ContainsSubstring("lie on one line"));
}

TEST_CASE("Unused vertices, wrong numbers and numbers that are none are named") {
  Mesh unused = zoo::tetrahedron();
  unused.vertices.push_back({3, 3, 3});
  CHECK_THAT(complaintAbout(unused), ContainsSubstring("m: vertex 5: no face has this vertex"));
  Mesh beyond = zoo::tetrahedron();
  beyond.faces[2][1] = 4;
  CHECK(complaintAbout(beyond) == "m: face 3: there is no vertex 5; the mesh has vertices 1 to 4");
  beyond.faces[2][1] = -1;
  CHECK_THAT(complaintAbout(beyond), ContainsSubstring("m: face 3: there is no vertex 0"));
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Mesh m = zoo::tetrahedron();
    m.vertices[2].y = bad;
    CHECK_THAT(complaintAbout(m), ContainsSubstring("m: vertex 3: a coordinate that is not a number"));
  }
  CHECK_THAT(complaintAbout(Mesh{}), ContainsSubstring("encloses nothing"));
}
