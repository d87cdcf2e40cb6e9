// Measures of all cells together: worked out by hand for rows of balls, and invariant where they must be.
#include "observation/organism_measures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "base/error.h"
#include "catch.h"
#include "observation/body_measures.h"
#include "simulation/population.h"
#include "simulation/restore.h"
#include "unit/simulation/worlds.h"

using namespace morula;

namespace {

/// Returns a world of balls of radius 1 that never divide, at these places: the first is AAA, the last BBB.
World balls(const std::vector<Point>& places) {
  std::vector<StartCell> cells;
  for (const Point& place : places) cells.push_back({.at = place});
  return makeWorld(looseBalls(cells));
}

/// Returns eight balls in a row, each touching the next; `order` says which ball of the list stands at which place.
World row(const std::vector<int>& order) {
  std::vector<Point> places(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) places[order[i]] = {1.75 * static_cast<double>(i), 0, 0};
  return balls(places);
}

std::vector<TakenMeasure> taken(const World& world, const std::vector<std::string>& names,
                                const Reference* reference = nullptr) {
  Observation now(world);
  now.reference = reference;
  return takeMeasures(now, names);
}

std::optional<double> valueOf(const char* name, const World& world, const Reference* reference = nullptr) {
  const std::vector<TakenMeasure> values = taken(world, {name}, reference);
  REQUIRE(values.size() <= 1);
  if (values.empty()) return {};
  CHECK(values[0].scope == Scope::world);
  CHECK(values[0].name == name);
  return values[0].value;
}

const std::vector<std::string> ofWorlds{"organism_elongation", "sister_contact", "cousin_contact",   "clone_contact",
                                        "homotypic_contact",   "clone_radius",   "clone_components", "mixing_index",
                                        "lineage_space",       "clone_spread"};

constexpr double third = 1.0 / 3;

}  // namespace

TEST_CASE("Relatives side by side in a row: AAA AAB ABA ABB BAA BAB BBA BBB") {
  const World world = row({0, 1, 2, 3, 4, 5, 6, 7});
  CHECK(valueOf("sister_contact", world) == 1);        // all four pairs
  CHECK(valueOf("cousin_contact", world) == 2.0 / 8);  // AAB-ABA and BAB-BBA
  CHECK(*valueOf("clone_contact", world) == Approx(4.0 / 7).epsilon(1e-12));
  CHECK(valueOf("homotypic_contact", world) == 1);                         // all hold the same substances
  CHECK(*valueOf("clone_radius", world) == Approx(0.875).epsilon(1e-12));  // two cells 1.75 apart
  CHECK(valueOf("clone_components", world) == 1);
  CHECK(*valueOf("mixing_index", world) == Approx(3.0 / 7 / (48.0 / 56)).epsilon(1e-12));
}

TEST_CASE("Relatives dealt out in a row: AAA ABA BAA BBA AAB ABB BAB BBB") {
  const World world = row({0, 2, 4, 6, 1, 3, 5, 7});
  CHECK(valueOf("sister_contact", world) == 0);
  CHECK(valueOf("cousin_contact", world) == 4.0 / 8);  // AAA-ABA, BAA-BBA, AAB-ABB, BAB-BBB
  CHECK(valueOf("clone_contact", world) == 0);
  CHECK(*valueOf("clone_radius", world) == Approx(2 * 1.75).epsilon(1e-12));
  CHECK(valueOf("clone_components", world) == 2);
  CHECK(*valueOf("mixing_index", world) == Approx(1 / (48.0 / 56)).epsilon(1e-12));
}

TEST_CASE("Spread of clones: a ball, two balls a known distance apart, a chain, whatever their sizes are") {
  // Expected for n balls of radius 1 with centres at xᵢ: √(1 + 5/3 mean |xᵢ − x|²) / ∛n
  const World single = row({0, 1, 2, 3});  // four clones of one ball
  CHECK(*valueOf("clone_spread", single) == Approx(1).epsilon(1e-12));
  CHECK(*valueOf("clone_spread", row({0, 1, 2, 3, 4, 5, 6, 7})) ==
        Approx(std::sqrt(1 + 5. / 3 * 0.875 * 0.875) / std::cbrt(2)).epsilon(1e-12));
  const World eight = row({0, 1, 2, 3, 4, 5, 6, 7});
  const double chain = 1.75 * 1.75 * (0.25 + 2.25) / 2;  // four balls in a row: ±½ and ±3/2 times 1.75
  CHECK(*valueOf("clone_spread of generation 1", eight) ==
        Approx(std::sqrt(1 + 5. / 3 * chain) / std::cbrt(4)).epsilon(1e-12));
  CHECK(*valueOf("clone_spread of generation 3", eight) == Approx(1).epsilon(1e-12));
  CHECK(valueOf("clone_radius of generation 2", eight) == valueOf("clone_radius", eight));
  CHECK(*valueOf("clone_radius of generation 1", eight) == Approx(std::sqrt(chain)).epsilon(1e-12));
  CHECK(valueOf("clone_components of generation 0", eight) == 1);
  // A cube of 64 cubes is as compact as a cube of 8: √(3/12)/√(3/5 (3/4π)^(2/3)) for edge 1
  const double cube = std::sqrt(0.25 / 0.6) / std::cbrt(0.75 / std::numbers::pi);
  for (const int n : {1, 2, 4}) {
    double volume = 0, second = 0;
    for (int i = 0; i < n * n * n; ++i) {
      const Point low{double(i % n), double(i / n % n), double(i / (n * n))};
      const Mesh piece = zoo::box(low / n, (low + Vector{1, 1, 1}) / n);
      const SolidMoments m = measureMoments(piece.vertices, piece.faces);
      volume += m.volume,
          second += m.second + m.volume * dot(m.centre - Point{.5, .5, .5}, m.centre - Point{.5, .5, .5});
    }
    CHECK(std::sqrt(second / volume / 0.6) / std::cbrt(volume * 0.75 / std::numbers::pi) ==
          Approx(cube).epsilon(1e-12));
  }
}

TEST_CASE("How far a cell lies below the surface, and where in the shell") {
  std::vector<Point> places;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k) places.push_back(1.9 * Vector{double(i), double(j), double(k)});
  std::swap(places[13], places.back());  // the last cell, BBB…, is in the middle
  const World crowd = balls(places);
  const auto distances = taken(crowd, {"surface_distance"});
  REQUIRE(distances.size() == 27);
  // Distances from a ball's centre to its mesh: to the farthest corner and to the nearest plane of a face.
  const Mesh ball = measureShape(*crowd.bodies, 13).surface;
  double farthest = 0, nearest = 2;
  for (const auto& [i, j, k] : ball.faces) {
    const Vector one = ball.vertices[i] - places[13];
    const Vector normal = cross(ball.vertices[j] - ball.vertices[i], ball.vertices[k] - ball.vertices[i]);
    farthest = std::max(farthest, norm(one));
    nearest = std::min(nearest, std::abs(dot(one, normal)) / norm(normal));
  }
  REQUIRE(farthest < 1.1);
  REQUIRE(nearest > 0.8);
  constexpr double twiceEdge = 0.12;
  for (const TakenMeasure& m : distances) {
    INFO(m.a.text());
    if (&m == &distances.back()) CHECK(m.value > 2);
    else CHECK(m.value < farthest + twiceEdge);
    CHECK(m.value > nearest - twiceEdge);
  }
  CHECK(valueOf("lumen", row({0, 1, 2})) == 0);

  const World world = ranToEnd(scenes::ellipsoid());
  const double* a = world.bodies->parameters.shell->semiAxes.data();
  const auto cells = measureCells(world);
  const auto values = taken(world, {"shell_x", "shell_y", "shell_z", "shell_r"});
  REQUIRE(values.size() == 4 * cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Vector at{cells[i].at("x") / a[0], cells[i].at("y") / a[1], cells[i].at("z") / a[2]};
    CHECK(values[4 * i].value == Approx(at.x).margin(1e-12));
    CHECK(values[4 * i + 1].value == Approx(at.y).margin(1e-12));
    CHECK(values[4 * i + 2].value == Approx(at.z).margin(1e-12));
    CHECK(values[4 * i + 3].value == Approx(norm(at)));
    CHECK(norm(at) < 1);
  }
  const auto mesh = std::make_shared<const ConvexShell>(
      ConvexShell{zoo::box({-0.5, -0.25, -0.5}, {0.5, 0.75, 0.5}), {{{1, 0, 0}, 0.5}}});
  const ShellPlace place = measurePlaceInShell({{}, mesh}, {0.25, -0.125, 0});
  CHECK(place.along == Vector{0.5, -0.5, 0});
  CHECK(place.out == 0.5);
}

TEST_CASE("Measures of some cells alone: rows of these, how many they are, and what is no measure on demand") {
  const World eight = row({0, 1, 2, 3, 4, 5, 6, 7});
  const std::vector<std::string> names{"count of AA*", "generation of AAB", "generation",           "kinship of AA*",
                                       "count of a0",  "count of clones",   "count of generation 2"};
  std::map<std::string, int> rows;
  for (const TakenMeasure& m : taken(eight, names)) {
    ++rows[m.name];
    if (m.name == "count of AA*") CHECK(m.value == 2);
    if (m.name == "count of a0" || m.name == "count of clones") CHECK(m.value == 8);
    if (m.name == "count of generation 2") CHECK(m.value == 0);
    if (m.name == "generation of AAB") CHECK(m.a.text() == "AAB");
  }
  CHECK(rows == std::map<std::string, int>{{"count of AA*", 1},
                                           {"count of a0", 1},
                                           {"count of clones", 1},
                                           {"count of generation 2", 1},
                                           {"generation", 8},
                                           {"generation of AAB", 1},
                                           {"kinship of AA*", 2}});
  for (const char* wrong : {"volume", "cells of AA*", "count", "clone_radius of AA*", "age of a b"})
    CHECK_THROWS_AS(taken(eight, {wrong}), BugError);
}

TEST_CASE("Kinship and distance: by hand for three cells, AA, AB and B") {
  // Divisions on the way: AA-AB 2, AA-B 3, AB-B 3: ranks 1, 2.5, 2.5. Distances 1.75, 3.5, 1.75: ranks 1.5, 3, 1.5.
  // Minus their means: (−1, ½, ½)·(−½, 1, −½) = ¾ over √(3/2 · 3/2).
  CHECK(*valueOf("lineage_space", row({0, 1, 2})) == Approx(0.5).epsilon(1e-14));
  CHECK_FALSE(valueOf("lineage_space", row({0, 1})));  // one pair has no order
  CHECK_FALSE(valueOf("lineage_space", row({0})));
}

TEST_CASE("Cells of several depths: sisters and cousins only where both live; clones from depth 2 on") {
  const World world = row({0, 1, 2, 3, 4});        // AAA AAB AB BA BB
  CHECK(valueOf("sister_contact", world) == 1);    // AAA-AAB, BA-BB
  CHECK(valueOf("cousin_contact", world) == 0.5);  // AB-BA, not AB-BB; the egg is their grandmother
  CHECK(valueOf("clone_components", world) == 1);
  CHECK(*valueOf("clone_contact", world) == Approx(0.25).epsilon(1e-12));
  const World young = row({0, 1});  // A and B belong to no clone
  for (const char* name : {"clone_contact", "clone_radius", "clone_components", "mixing_index"})
    CHECK_FALSE(valueOf(name, young));
  CHECK(valueOf("sister_contact", young) == 1);
  const World apart = balls({{0, 0, 0}, {5, 0, 0}, {0, 5, 0}, {0, 0, 5}});
  CHECK(valueOf("sister_contact", apart) == 0);
  for (const char* name : {"clone_contact", "homotypic_contact", "mixing_index"}) CHECK_FALSE(valueOf(name, apart));
}

TEST_CASE("Turning, moving and mirroring the organism, and who is A, change none of it") {
  const std::vector<int> order{3, 0, 5, 1, 7, 2, 6, 4};
  const World world = row(order);
  std::vector<Point> turned(8), mirrored(8);
  for (int i = 0; i < 8; ++i) {
    const double x = 1.75 * i;
    turned[order[i]] = {2 * third * x + 1, -third * x, 2 * third * x - 3};
    mirrored[7 - order[i]] = {-x, 0, 0};  // ABB becomes BAA
  }
  for (const World& other : {balls(turned), balls(mirrored)})
    for (const std::string& name : ofWorlds) {
      INFO(name);
      const auto here = valueOf(name.c_str(), world), there = valueOf(name.c_str(), other);
      REQUIRE(here.has_value() == there.has_value());
      if (here && name != "organism_elongation") CHECK(*there == Approx(*here).epsilon(1e-12));
    }
}

TEST_CASE("Contacts are compared among living cells of the reference alone") {
  const World world = row({0, 1, 2, 3, 4, 5, 6, 7});
  const auto cell = [](const char* path) { return CellPath::parse(path); };
  Reference reference;
  const auto add = [&](const char* a, const char* b) { reference.contacts.insert({cell(a), cell(b)}); };
  add("AAA", "AAB");   // touches in the world, too
  add("AAB", "ABA");   // touches in the world, too
  add("AAA", "ABA");   // does not touch in the world
  add("AAA", "BBBB");  // BBBB does not live
  // Among the cells AAA, AAB, ABA two pairs touch in the world, and three in the reference.
  CHECK(*valueOf("contact_jaccard", world, &reference) == Approx(2.0 / 3));
  CHECK(*valueOf("contact_f1", world, &reference) == Approx(4.0 / 5));
  add("BAA", "BAB");
  add("BBA", "BBB");  // now BAB-BBA touches in the world only
  CHECK(*valueOf("contact_jaccard", world, &reference) == Approx(4.0 / 6));
  CHECK(*valueOf("contact_f1", world, &reference) == Approx(8.0 / 10));
  CHECK_FALSE(valueOf("contact_f1", world));  // there is no reference
  Reference dead;
  dead.contacts.insert({cell("AAAA"), cell("AAAB")});
  CHECK_FALSE(valueOf("contact_jaccard", world, &dead));
}

TEST_CASE("Positions are compared turned and moved, and their shape also scaled") {
  const World world = balls({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {0, 0, 5}});
  Reference same, half, other;
  const auto at = [](const char* path) { return CellPath::parse(path); };
  same.positions = {{at("AA"), {7, 0, 0}}, {at("AB"), {7, 3, 0}}, {at("BA"), {7, 0, 4}}, {at("BB"), {12, 0, 0}}};
  half.positions = {{at("AA"), {0, 0, 0}}, {at("AB"), {0, 1.5, 0}}, {at("BA"), {0, 0, 2}}, {at("BB"), {2.5, 0, 0}}};
  CHECK(*valueOf("position_rmsd", world, &same) < 1e-14);
  CHECK(*valueOf("position_shape_rmsd", world, &same) < 1e-14);
  CHECK(*valueOf("position_rmsd", world, &half) > 1);
  CHECK(*valueOf("position_shape_rmsd", world, &half) < 1e-14);
  other.positions = {{at("AA"), {0, 0, 0}}, {at("AB"), {1, 0, 0}}, {at("ABA"), {9, 9, 9}}};
  CHECK_FALSE(valueOf("position_rmsd", world, &other));  // only two cells of the reference live
}

TEST_CASE("Measures on demand: names are no other's, pairs and cells come by path, and others are refused") {
  std::set<std::string> names;
  for (const MeasureOnDemand& m : measuresOnDemand()) CHECK(names.insert(m.name).second);
  for (const auto& m : sampledMeasures<Observation>()) CHECK_FALSE(names.contains(m.name));
  for (const auto& m : sampledMeasures<CellContext>()) CHECK_FALSE(names.contains(m.name));
  for (const auto& m : sampledMeasures<Touch>()) CHECK_FALSE(names.contains(m.name));

  const World world = row({0, 1, 2});  // AA AB B
  const auto measures = taken(world, {"kinship", "generation", "contact_share", "clone_radius"});
  std::vector<std::string> lines;
  for (const TakenMeasure& m : measures)
    if (m.name != "contact_share")
      lines.push_back(m.name + " " + m.a.text() + " " + m.b.text() + " " + std::to_string(static_cast<int>(m.value)));
  CHECK(lines == std::vector<std::string>{"generation AA  2", "generation AB  2", "generation B  1", "kinship AA AB 1",
                                          "kinship AB B 2"});  // no clone has two cells
  // Area of the disc in which two balls of radius 1 meet at distance 1.75, over the ball's surface
  for (const TakenMeasure& m : measures)
    if (m.name == "contact_share") CHECK(m.value == Approx((1 - 0.875 * 0.875) / 4).epsilon(1e-12));
  CHECK_THROWS_AS(taken(world, {"volume"}), BugError);
}

TEST_CASE("A lineage without bodies has ages and generations, and nothing else on demand") {
  World world = makeWorld(scenes::lineageOnly(scenes::everybodyDivides, 3));
  step(world), step(world);
  std::vector<std::string> all;
  for (const MeasureOnDemand& m : measuresOnDemand()) all.push_back(m.name);
  for (const TakenMeasure& m : taken(world, all)) {
    CHECK(m.scope == Scope::cell);
    CHECK(((m.name == "age" && m.value >= 0) || (m.name == "generation" && m.value == m.a.depth())));
  }
  CHECK(taken(world, all).size() == 2 * world.cells.path.size());
}

TEST_CASE("Of each cell: how the divisions that made it lay, its extents, and how much lies on the shell") {
  const World world = ranToEnd(scenes::ellipsoid());
  const std::vector<std::string> names{"axis_turn",       "axis_to_x",   "birth_share",
                                       "birth_ambiguity", "extent_1",    "extent_2",
                                       "extent_3",        "shell_share", "age"};
  const auto measures = taken(world, names);
  REQUIRE(measures.size() == world.cells.path.size() * names.size());
  const auto of = [&](const CellPath& cell, const std::string& name) {
    return std::ranges::find_if(measures, [&](const TakenMeasure& m) { return m.a == cell && m.name == name; })->value;
  };
  const auto divisionOf = [&](const CellPath& mother) {
    return *std::ranges::find(world.divisions, mother, &DivisionRecord::path);
  };
  const auto degrees = [](double cosine) {
    return std::acos(std::min(1.0, std::abs(cosine))) * 180 / std::numbers::pi;
  };
  bool touchesShell = false;
  for (const CellPath& cell : world.cells.path) {
    const DivisionRecord own = divisionOf(cell.mother()), before = divisionOf(cell.mother().mother());
    CHECK(of(cell, "axis_turn") == Approx(degrees(dot(own.axis, before.axis))).margin(1e-6));
    CHECK(of(cell, "axis_to_x") == Approx(degrees(own.axis.x)).margin(1e-6));
    CHECK(of(cell, "birth_share") == (cell.letter(cell.depth() - 1) ? 1 - own.share : own.share));
    CHECK(of(cell, "birth_ambiguity") == own.extentRatio.value());
    CHECK(of(cell, "extent_1") >= of(cell, "extent_2"));
    CHECK(of(cell, "extent_2") >= of(cell, "extent_3"));
    CHECK(of(cell, "extent_3") > 0);
    CHECK(of(cell, "age") > 0);
    touchesShell |= of(cell, "shell_share") > 0.1;
  }
  CHECK(touchesShell);
}

TEST_CASE("The share on the shell: of a tetrahedron one corner, then all") {
  const std::vector<Point> corners{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  BodyShape shape{{corners, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}}, {}, 1, 1, {}, false};
  const double far = std::sqrt(3.0), out = far - 1 / far;
  shape.sag = 1 / far;  // l²/8far with edges of l² = 8
  CHECK(measureShellShare(shape, ShellParameters{{out, out, out}}) == Approx(1));
  CHECK(measureShellShare(shape, ShellParameters{{2, 2, 2}}) == 0);
  for (std::size_t i = 1; i < 4; ++i) shape.surface.vertices[i] *= 0.97;  // three faces lose their outer corners
  CHECK(measureShellShare(shape, ShellParameters{{out, out, out}}) == Approx(0.25).epsilon(0.02));
}

TEST_CASE("Displacement: a cell is moved by (3, 4, 0), and so is 5 away from where it was born") {
  Scene scene = scenes::withBodies(scenes::everybodyDivides, 9, makeIcosphere(1));
  scene.mechanics->division = {DivisionPlane::axis, {1, 0, 0}};
  // The egg lies off the origin, which is no displacement.
  World world = worldOf(scene, {ballAt(scenes::scaled(makeIcosphere(1), 0.9), {7, -2, 1}, 100)});
  const auto ways = [&] {
    std::map<std::string, double> all;
    for (const TakenMeasure& m : taken(world, {"displacement"})) all[m.a.text()] = m.value;
    return all;
  };
  const auto divide = [&](const std::vector<CellChange>& changes) {
    changePopulation(world, Observation(world), changes);
  };
  CHECK(ways().empty());  // no division led to the egg
  divide({CellChange::divides});
  CHECK(ways() == std::map<std::string, double>{{"A", 0}, {"B", 0}});
  std::vector<Body> bodies;
  for (const int slot : world.bodies->slots) bodies.push_back(takeBody(*world.bodies, slot));
  for (Point& x : bodies[0].position) x += Vector{3, 4, 0};
  setBodies(*world.bodies, bodies);
  CHECK(ways().at("A") == Approx(5).epsilon(1e-12));
  CHECK(ways().at("B") == 0);
  divide({CellChange::divides, CellChange::none});
  CHECK(ways() == std::map<std::string, double>{{"AA", 0}, {"AB", 0}, {"B", 0}});
  CHECK(taken(balls({{}, {4, 0, 0}}), {"displacement"}).empty());  // start cells were not born by a division either
}

TEST_CASE("Displacement is what the centres tell of a life, of meshes and of balls, and after a checkpoint") {
  for (const Scene& scene : {scenes::packed(), scenes::spheres()}) {
    World world = makeWorld(scene);
    std::map<CellPath, Point> births;
    const auto centre = [](const CellMeasures& m) { return Point{m.at("x"), m.at("y"), m.at("z")}; };
    bool isSaved = false;
    while (!finished(world)) {
      for (const CellMeasures& m : measureCells(world)) births.try_emplace(m.path, centre(m));
      if (!isSaved && births.size() > 3) {
        World restored = makeWorld(scene, {Isa::scalar, 1});
        restoreState(restored, saveState(world));
        world = std::move(restored);
        isSaved = true;
      }
      step(world);
    }
    for (const CellMeasures& m : measureCells(world)) births.try_emplace(m.path, centre(m));
    REQUIRE(isSaved);
    const auto displacements = taken(world, {"displacement"});
    const auto cells = measureCells(world);
    REQUIRE(displacements.size() == cells.size());
    double farthest = 0;
    const double takenIn = world.bodies->areSpheres() ? 1e-12 : 5e-4;  // measured: 3.8e-4 at most
    for (std::size_t i = 0; i < cells.size(); ++i) {
      CHECK(displacements[i].a == cells[i].path);
      // A shell that holds surfaces moves newborn daughters' new meshes inward a little.
      CHECK(displacements[i].value == Approx(norm(centre(cells[i]) - births.at(cells[i].path))).margin(takenIn));
      farthest = std::max(farthest, displacements[i].value);
    }
    CHECK(farthest > 0.01);
  }
}
