// Folded and compressed edges, and cells that lie in themselves, against their definitions.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "catch.h"
#include "mesh/overlap.h"
#include "observation/sanity.h"
#include "unit/simulation/worlds.h"

using namespace morula;

namespace {

Scene sceneOf(const Mesh& egg) {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 1, egg);
  scene.mechanics->physics.pressure.constant = 4;
  return scene;
}

double ofCell(const World& world, const char* name, int cell = 0) {
  const Observation now(world);
  return *measure<CellContext>(name).get(ObservedCell(now, cell));
}

double ofWorld(const World& world, const char* name) { return *measure<Observation>(name).get(Observation(world)); }

/// [1] The angle of the unit normals of both faces at each edge, and whether it is above 90°.
double foldedByAngles(const Mesh& m) {
  std::map<std::pair<int, int>, std::vector<Vector>> normals;
  for (const Face& f : m.faces) {
    const Vector normal = cross(m.vertices[f[1]] - m.vertices[f[0]], m.vertices[f[2]] - m.vertices[f[0]]);
    for (int k = 0; k < 3; ++k)
      normals[std::minmax(f[k], f[(k + 1) % 3])].push_back(normal / norm(normal));
  }
  double folded = 0;
  for (const auto& [edge, both] : normals) folded += std::acos(dot(both[0], both[1])) > std::numbers::pi / 2;
  return folded / static_cast<double>(normals.size());
}

double compressedByLengths(const Mesh& m, const Mesh& rest) {
  const auto length = [](const Mesh& of, int i, int j) { return norm(of.vertices[i] - of.vertices[j]); };
  double compressed = 0;
  for (const Face& f : m.faces)
    for (int k = 0; k < 3; ++k) {
      const int i = f[k], j = f[(k + 1) % 3];
      compressed += length(m, i, j) / length(rest, i, j) < 0.98;
    }
  return compressed / static_cast<double>(3 * m.faces.size());  // each edge stands in two faces
}

Body bodyOf(const Mesh& mesh) {
  Body body = ballAt(mesh, {}, 4);
  body.mass = 1;
  return body;
}

SanityMeasure sanityOf(const World& world, SanityKind kind) {
  const auto all = measureSanity(world);
  const auto at = std::ranges::find(all, kind, &SanityMeasure::kind);
  REQUIRE(at != all.end());
  return *at;
}

}  // namespace

TEST_CASE("A ball at rest has no fold and no compressed edge, and does not lie in itself") {
  const World world = makeWorld(sceneOf(makeIcosphere(2)));
  for (const char* name : {"folded", "compressed", "self_overlap"}) CHECK(ofCell(world, name) == 0);
  for (const char* name : {"folded_edges", "compressed_edges"}) CHECK(ofWorld(world, name) == 0);
  const World spheres = makeWorld(scenes::spheres());
  for (const char* name : {"folded", "compressed", "self_overlap"}) CHECK(ofCell(spheres, name) == 0);
  for (const char* name : {"folded_edges", "compressed_edges"}) CHECK(ofWorld(spheres, name) == 0);
}

TEST_CASE("Compressed are edges below 0.98 of their rest length, which is that of the cell's own scale") {
  const Mesh ball = makeIcosphere(2);
  const Scene scene = sceneOf(ball);
  Body body = bodyOf(zoo::scaled(ball, {0.97, 0.97, 0.97}));
  CHECK(ofCell(worldOf(scene, {body}), "compressed") == 1);
  body.restScale = 0.985;
  CHECK(ofCell(worldOf(scene, {body}), "compressed") == 0);
  const Mesh flat = zoo::scaled(ball, {1.1, 1.05, 0.6});
  const double compressed = ofCell(worldOf(scene, {bodyOf(flat)}), "compressed");
  CHECK(compressed == compressedByLengths(flat, ball));
  CHECK(compressed > 0.2);
  CHECK(compressed < 0.8);
}

TEST_CASE("Folded are edges whose faces' normals are more than 90 degrees apart, but not those of the mesh at rest") {
  const Mesh ball = makeIcosphere(2);
  const Scene scene = sceneOf(ball);
  for (const double size : {0.3, 0.5, 0.8}) {
    const Mesh crumpled = zoo::crumpled(ball, size, 3);
    const double folded = ofCell(worldOf(scene, {bodyOf(crumpled)}), "folded");
    CHECK(folded == Approx(foldedByAngles(crumpled)).epsilon(1e-12));
    CHECK(folded > 0);
  }
  const Mesh lens = zoo::scaled(makeIcosphere(1), {1, 1, 0.05});
  REQUIRE(foldedByAngles(lens) > 0);
  CHECK(ofCell(worldOf(sceneOf(lens), {bodyOf(lens)}), "folded") == 0);
}

TEST_CASE("The shares of all cells count every edge once, also where cells have different meshes") {
  const Mesh fine = makeIcosphere(2), coarse = makeIcosphere(1);
  Scene scene = sceneOf(fine);
  scene.mechanics->coarser = {coarse};
  Body crumpled = bodyOf(zoo::crumpled(fine, 0.5, 3)), small = bodyOf(zoo::scaled(coarse, {0.9, 0.9, 0.9}));
  small.meshLevel = 1;
  const World world = worldOf(scene, {crumpled, small});
  const double edges[2] = {480, 120};
  for (const auto& [whole, single] :
       {std::pair("folded_edges", "folded"), std::pair("compressed_edges", "compressed")}) {
    const double first = ofCell(world, single, 0), second = ofCell(world, single, 1);
    CHECK(first > 0);
    CHECK(first != second);
    CHECK(ofWorld(world, whole) == Approx((edges[0] * first + edges[1] * second) / 600).epsilon(1e-12));
  }
  CHECK(ofCell(world, "compressed", 1) == 1);
}

TEST_CASE("A cell in itself is measured and told, and the sentence names the cell and the share") {
  const Mesh ball = makeIcosphere(2);
  const Mesh through = zoo::dented(ball, 2.6, 0.3);
  Body whole = bodyOf(zoo::moved(ball, {5, 0, 0}));
  const World world = worldOf(sceneOf(ball), {whole, bodyOf(through)});
  const double share = ofCell(world, "self_overlap", 1);
  CHECK(share > 0.005);
  CHECK(share == Approx(measureSelfOverlap({through.vertices, through.faces}, 24)).epsilon(1e-12));
  CHECK(ofCell(world, "self_overlap", 0) == 0);
  const SanityMeasure told = sanityOf(world, SanityKind::selfOverlap);
  CHECK(!told.holds());
  CHECK(told.value == share);
  CHECK(told.cell->text() == "B");
  CHECK_THAT(describe(told, world), ContainsSubstring("cell B passes through itself: it covers "));
}

TEST_CASE("A surface that is folded at more than 0.15 of its edges is told, with how many are compressed") {
  const Mesh ball = makeIcosphere(2);
  const Body whole = bodyOf(zoo::moved(ball, {5, 0, 0}));
  const auto crumpled = [&](double size) {
    return worldOf(sceneOf(ball), {whole, bodyOf(zoo::crumpled(ball, size, 3))});
  };
  const World little = crumpled(0.2), much = crumpled(0.5);
  CHECK(sanityOf(little, SanityKind::folded).holds());
  const SanityMeasure told = sanityOf(much, SanityKind::folded);
  CHECK(told.value == ofCell(much, "folded", 1));
  CHECK(told.value < 0.2);
  CHECK(!told.holds());
  CHECK_THAT(describe(told, much), ContainsSubstring("the surface of cell B is folded over by more than 90° at ") &&
                                       ContainsSubstring(" of its edges are compressed"));
}
