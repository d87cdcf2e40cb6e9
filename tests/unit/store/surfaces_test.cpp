// Surfaces in the database: their precision, the times at which they are kept, and files that are refused.
#include <algorithm>
#include <cmath>
#include <map>

#include "catch.h"
#include "database/store_error.h"
#include "example_run.h"
#include "observation/measures.h"
#include "scenes.h"
#include "store/recorder.h"

using namespace morula;

namespace {

/// Returns the max error: half a step, and rounding of three operations on numbers no larger than the coordinates.
double bound(double step, double low, double x) {
  return step / 2 + 4 * 0x1p-53 * std::max({std::abs(low), std::abs(x), 65535 * step});
}

void requireWithinBound(const CellSurface& kept, const std::vector<Point>& exact) {
  const std::vector<Point> read = vertexPositions(kept);
  REQUIRE(read.size() == exact.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    REQUIRE(std::abs(read[i].x - exact[i].x) <= bound(kept.step.x, kept.low.x, exact[i].x));
    REQUIRE(std::abs(read[i].y - exact[i].y) <= bound(kept.step.y, kept.low.y, exact[i].y));
    REQUIRE(std::abs(read[i].z - exact[i].z) <= bound(kept.step.z, kept.low.z, exact[i].z));
  }
}

std::vector<Point> moved(Mesh mesh, const Vector& scale, const Vector& by) {
  for (Point& v : mesh.vertices) v = Point{v.x * scale.x, v.y * scale.y, v.z * scale.z} + by;
  return mesh.vertices;
}

/// A world, its recorder, and the exact surfaces at each step until the end.
struct Watched {
  World world;
  Recorder recorder;
  std::map<std::uint64_t, std::map<CellPath, Mesh>> exact;  // by step
  Watched(const Scene& scene, RecordOptions options) : world(makeWorld(scene)), recorder(std::move(options)) {
    for (observe(); !finished(world); observe()) step(world);
  }
  void observe() {
    recorder.observe(world);
    for (const CellPath& path : world.cells.path) exact[world.clock.step][path] = cellMesh(world, path);
  }
};

RunResults withSurfaces() {
  RunResults r = exampleResults();
  r.meshes = {{0, 3, {{0, 1, 2}, {2, 1, 0}}}, {2, 1, {}}};
  r.samples[1].surfaces = {
      {CellPath::parse("A"), 0, {0.1, -2, 0}, {0x1p-20, 0, 1e-300}, {{0, 0, 1}, {65535, 0, 2}, {258, 0, 3}}},
      {CellPath::parse("B"), 2, {1, 2, 3}, {0, 0, 0}, {{0, 0, 0}}}};
  return r;
}

}  // namespace

TEST_CASE("a kept coordinate is off by half a step at most, and a step is the 65535th part of the extent") {
  for (const auto& [scale, by] : {std::pair(Vector{1, 1, 1}, Vector{}),
                                  {Vector{27, 15, 1e-9}, Vector{-400, 0.1, 3}},
                                  {Vector{1e-200, 1e200, 1}, Vector{0, 1e199, -1e6}},
                                  {Vector{1, 0, 1}, Vector{5, 7, 9}}}) {
    const auto vertices = moved(makeIcosphere(3), scale, by);
    const CellSurface kept = quantise({}, 0, vertices);
    requireWithinBound(kept, vertices);
    const Box box = measureBox(vertices);
    CHECK(kept.low == box.low);
    CHECK(kept.step.x == (box.high.x - box.low.x) / 65535);
    const bool isFlat = scale.y == 0;
    CHECK((kept.step.y == 0) == isFlat);
    if (!isFlat) CHECK(std::ranges::any_of(kept.numbers, [](const auto& n) { return n[1] == 65535; }));
  }
  const CellSurface point = quantise({}, 0, {{1, 2, 3}});
  CHECK(vertexPositions(point) == std::vector<Point>{{1, 2, 3}});
}

TEST_CASE("the bound is reached: it could not be said smaller") {
  std::vector<Point> vertices{{0, 0, 0}, {65535, 65535, 65535}};
  for (int i = 0; i < 100; ++i) vertices.push_back({i + 0.5, i + 0.25, double(i)});
  const auto read = vertexPositions(quantise({}, 0, vertices));
  CHECK(read[2].x == 1);  // 0.5 off
  CHECK(read[2].y == 0);
  CHECK(read[2 + 99].z == 99);
}

TEST_CASE("numbers and faces are the same as bytes, in 16 or 32 bits") {
  const CellSurface s = quantise({}, 0, makeIcosphere(2).vertices);
  CHECK(numberBytes(s).size() == 6 * 162);
  CHECK(numbersFrom(numberBytes(s)) == s.numbers);
  CHECK(numberBytes({{}, 0, {}, {}, {{1, 258, 65535}}}) == std::string("\x01\x00\x02\x01\xff\xff", 6));
  for (const std::uint64_t vertices : {65536u, 65537u}) {
    const MeshFaces mesh{0, vertices, {{0, 1, 258}, {65535, 3, 2}}};
    const std::string bytes = faceBytes(mesh);
    CHECK(bytes.size() == (vertices > 65536 ? 24 : 12));
    std::vector<Face> faces;
    REQUIRE(facesFrom(bytes, vertices, faces));
    CHECK(faces == mesh.faces);
    CHECK_FALSE(facesFrom(bytes, 65535, faces));  // an unknown vertex, or another size of corners
    CHECK_FALSE(facesFrom(bytes.substr(1), vertices, faces));
  }
}

TEST_CASE("surfaces are kept at their times, of every living cell, and at the end") {
  Watched run(scenes::packed(), {.every = 1, .meshes = 0.75});
  const RunResults results = run.recorder.take(run.world);
  const double dt = results.timeSteps[0].timeStep;
  std::vector<double> kept;
  for (const Sample& s : results.samples) {
    if (s.surfaces.empty()) continue;
    kept.push_back(s.world.time);
    const auto& exact = run.exact.at(s.world.step);
    REQUIRE(s.surfaces.size() == exact.size());
    REQUIRE(s.cells.size() == exact.size());
    for (const CellSurface& c : s.surfaces) requireWithinBound(c, exact.at(c.path).vertices);
  }
  REQUIRE(kept.size() == 7);  // at 0, 0.75, … 4.5, which is the end
  for (std::size_t i = 0; i < kept.size(); ++i) {
    CHECK(kept[i] >= 0.75 * double(i));
    CHECK(kept[i] < 0.75 * double(i) + dt);
  }
  CHECK(results.samples.size() == 7 + 3);  // further samples at 1, 2 and 4; 0 and 3 have surfaces, too
  REQUIRE(results.meshes.size() == 1);
  CHECK(results.meshes[0].faces == makeIcosphere(1).faces);
}

TEST_CASE("the end keeps surfaces, also where a sample was due there anyway; without being asked nothing is kept") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 1);
  scene.stop = {.cycles = {}, .time = 0.5, .cells = {}};
  Watched due(scene, {.every = 0.25, .meshes = 0.4});
  const auto samples = due.recorder.take(due.world).samples;
  CHECK(samples.back().world.time == 0.5);
  CHECK(samples.back().surfaces.size() == 1);
  CHECK(samples[1].surfaces.empty());
  Watched none(scene, {.every = 0.25});
  const RunResults plain = none.recorder.take(none.world);
  CHECK(plain.meshes.empty());
  for (const Sample& s : plain.samples) CHECK(s.surfaces.empty());
  Watched at(scene, {.meshesAt = {0.1, 0.3}});
  const auto twice = at.recorder.take(at.world).samples;
  REQUIRE(twice.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) CHECK(twice[i].surfaces.empty() == (i == 0 || i == 3));
}

TEST_CASE("each mesh's faces are kept once, and cells say which is theirs; spheres have the egg's") {
  Watched coarse(scenes::coarsening(), {.meshes = 1});
  const RunResults results = coarse.recorder.take(coarse.world);
  REQUIRE(results.meshes.size() == 2);
  bool isCoarse = false;
  for (const Sample& s : results.samples)
    for (const CellSurface& c : s.surfaces) {
      const Mesh& exact = coarse.exact.at(s.world.step).at(c.path);
      const MeshFaces& mesh = results.meshes[static_cast<std::size_t>(c.mesh)];
      CHECK(mesh.mesh == c.mesh);
      CHECK(mesh.vertices == exact.vertices.size());
      CHECK(mesh.faces == exact.faces);
      isCoarse = isCoarse || c.mesh == 1;
    }
  CHECK(isCoarse);
  Scene balls = scenes::spheres();
  balls.stop = {.cycles = {}, .time = 1.5, .cells = {}};
  Watched spheres(balls, {.meshes = 0.5});
  const RunResults round = spheres.recorder.take(spheres.world);
  REQUIRE(round.meshes.size() == 1);
  CHECK(round.samples.back().surfaces.size() == 2);
  const Bodies& b = *spheres.world.bodies;
  for (const CellSurface& c : round.samples.back().surfaces) {  // vertices on the ball, where the egg has them
    const int slot = b.slots[cellNumber(spheres.world.cells, c.path)];
    std::vector<Point> exact = cellMesh(spheres.world, c.path).vertices;
    for (Point& p : exact) {
      const Vector way = p - b.vertex(slot, 0);
      p = b.vertex(slot, 0) + (b.parameters.cell.radius * b.restScale[slot] / norm(way)) * way;
    }
    requireWithinBound(c, exact);
  }
}

TEST_CASE("steps in between may be taken at once, up to the next surfaces") {
  World world = makeWorld(scenes::withBodies(scenes::uniqueFour, 1));
  Recorder recorder({.meshes = 0.5, .meshesAt = {0.125}});
  recorder.observe(world);
  CHECK(recorder.stepsUntilDue(world) == stepsUntil(world.clock, 0.125));
  takeSteps(world, recorder.stepsUntilDue(world));
  recorder.observe(world);
  CHECK(recorder.sampled());
  CHECK(recorder.stepsUntilDue(world) == stepsUntil(world.clock, 0.5));
}

TEST_CASE_METHOD(BegunRun, "what the database has of surfaces is what was given to it") {
  finish(withSurfaces());
  const RunResults read = store.results(id);
  CHECK(read.meshes == withSurfaces().meshes);
  CHECK(read.samples[0].surfaces.empty());
  CHECK(read.samples[1].surfaces == withSurfaces().samples[1].surfaces);
  store.begin(exampleRecord());
  finish();  // replaces the surfaces
  CHECK(store.results(id).meshes.empty());
  CHECK(store.results(id).samples[1].surfaces.empty());
}

TEST_CASE("surfaces that cannot be are refused with their column") {
  for (const auto& [change, because] :
       {std::pair("UPDATE mesh_sample SET vertices = x'0000' WHERE path = 'A'", "three corners a face"),
        {"UPDATE mesh_sample SET mesh = 0 WHERE path = 'B'", "six bytes for each vertex"},
        {"UPDATE mesh_sample SET mesh = 7 WHERE path = 'A'", "the number of a mesh among the documents"},
        {"UPDATE mesh_sample SET mesh = -1 WHERE path = 'A'", "mesh"},
        {"UPDATE mesh_sample SET low_x = 9e999 WHERE path = 'A'", "a finite number"},
        {"UPDATE mesh_sample SET path = 'C' WHERE path = 'A'", "a cell's path"},
        {"UPDATE document SET content = x'000001000300' WHERE length(content) = 12", "three corners a face"},
        {"UPDATE document SET content = x'00' WHERE length(content) = 12", "three corners a face"}}) {
    INFO(change);
    BegunRun run;
    run.finish(withSurfaces());
    run.database().execute(change);
    REQUIRE_THROWS_WITH(run.store.results(run.id), ContainsSubstring(because));
  }
}

TEST_CASE_METHOD(BegunRun, "replay finds a vertex that was changed, and says it in a line") {
  Store again = Store::temporary();
  const std::string idAgain = again.begin(exampleRecord());
  finish(withSurfaces());
  RunResults changed = withSurfaces();
  changed.samples[1].surfaces[0].numbers[1][2] += 1;
  again.finish(idAgain, exampleEnd(), changed);
  std::size_t differing = 0;
  for (const TableDifference& t : store.compareResults(id, again, idAgain)) {
    differing += t.differing;
    if (t.table != "mesh_sample") continue;
    REQUIRE(t.first);
    CHECK(t.first->column == "vertices");
    CHECK_THAT(t.first->stored, ContainsSubstring("18 bytes with the hash "));
    CHECK(t.first->stored != t.first->recomputed);
  }
  CHECK(differing == 1);
}

TEST_CASE("a run that goes on keeps the surfaces that were due, not those of where it was stopped") {
  const Scene scene = scenes::coarsening();
  const RecordOptions options{.every = 1, .meshes = 0.75};
  Watched whole(scene, options);
  const RunResults all = whole.recorder.take(whole.world);
  for (const double stop : {1.3, 1.0}) {  // at 1 a sample without surfaces is due
    World world = makeWorld(scene);
    Recorder first(options);
    for (first.observe(world); world.clock.time < stop; first.observe(world)) step(world);
    const RunResults stopped = Recorder(first).take(world);
    REQUIRE(!stopped.samples.back().surfaces.empty());
    Recorder second(options);
    second.resume(world, stopped);
    while (!finished(world)) step(world), second.observe(world);
    const RunResults resumed = second.take(world);
    CHECK(resumed.meshes == all.meshes);
    REQUIRE(resumed.samples.size() == all.samples.size());
    for (std::size_t i = 0; i < all.samples.size(); ++i)
      REQUIRE(resumed.samples[i].surfaces == all.samples[i].surfaces);
  }
}
