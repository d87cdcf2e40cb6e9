// Policies can be compared seed by seed: a cell has the same deviates under each policy, for every quantity that a seed
// varies.
#include <map>

#include "catch.h"
#include "worlds.h"

using namespace morula;

namespace {

/// Returns a scene of balls in a shell that divide into eight; spheres are shared out exactly.
Scene balls() {
  Scene s = scenes::withBodies(scenes::everybodyDivides, 3);
  s.mechanics->physics.cell.model = CellModel::sphere;
  s.mechanics->physics.drag = 20;
  s.mechanics->physics.shell = ShellParameters{{2, 2, 2}};
  s.mechanics->contact = scenes::pairContact;
  s.mechanics->contact->adhesion.emplace().strength = 1;
  s.variation = {.cycle = 0.1, .share = 0.05, .start = 0.1, .tilt = 6, .adhesion = 0.2};
  s.seed = 11;
  return s;
}

/// Returns scenes whose policies move the cells to different places.
std::vector<std::pair<std::string, Scene>> policies() {
  std::vector<std::pair<std::string, Scene>> list;
  for (const auto& [name, plane] : {std::pair<std::string, PlaneChoice>{"along x", {DivisionPlane::axis, {1, 0, 0}}},
                                    {"along (1, 2, 2)", {DivisionPlane::axis, {1, 2, 2}}},
                                    {"random", {DivisionPlane::random, {}}},
                                    {"parallel", {DivisionPlane::parallel, {}}}})
    for (const bool connected : {false, true}) {
      Scene s = balls();
      s.mechanics->division.otherwise = plane;
      if (connected)
        s.mechanics->connections =
            ConnectionParameters{MakeConnections::atDivision, ConnectionsOnDivision::both, 0.2, {}};
      list.emplace_back(name + (connected ? ", connected" : ""), s);
    }
  return list;
}

Point centreOf(const World& world) {
  const CellMeasures egg = measureCells(world).at(0);
  return {egg.at("x"), egg.at("y"), egg.at("z")};
}

std::map<std::string, double> sharesOf(const World& world) {
  std::map<std::string, double> shares;
  for (const DivisionRecord& d : world.divisions) shares[d.path.text()] = d.share;
  return shares;
}

std::map<std::string, double> factorsOf(const World& world) {
  std::map<std::string, double> factors;
  for (std::size_t i = 0; i < world.cells.path.size(); ++i)
    factors[world.cells.path[i].text()] = world.contacts->adhesion.kinds.factor.at(std::size_t(world.bodies->slots[i]));
  return factors;
}

/// [1] Returns the cosines of the angles between the divisions' axes and the axis that was asked for.
std::map<std::string, double> tiltsOf(const World& world, const Vector& asked) {
  std::map<std::string, double> tilts;
  for (const DivisionRecord& d : world.divisions) tilts[d.path.text()] = dot(d.axis, asked) / norm(asked);
  return tilts;
}

void checkSame(const std::map<std::string, double>& a, const std::map<std::string, double>& b, double tolerance) {
  REQUIRE(a.size() == b.size());
  for (const auto& [path, value] : a) {
    CAPTURE(path);
    CHECK(b.at(path) == Approx(value).margin(tolerance));
  }
}

/// Checks that the values vary by more than `by`, so that a comparison means something.
void checkVaries(const std::map<std::string, double>& values, double by) {
  double least = INFINITY, most = -INFINITY;
  for (const auto& [path, value] : values) least = std::min(least, value), most = std::max(most, value);
  CHECK(most - least > by);
}

}  // namespace

TEST_CASE("The same cell has the same cycle, share and adhesion under every policy, and another with another seed") {
  const auto all = policies();
  const World first = ranToEnd(all[0].second);
  checkVaries(birthsOf(first), 0.1);
  checkVaries(sharesOf(first), 0.02);
  checkVaries(factorsOf(first), 0.05);
  for (const auto& [name, scene] : all) {
    CAPTURE(name);
    const World world = ranToEnd(scene);
    // A cell is born at the first step after its cycle, and the step depends on contacts.
    double longest = 0;
    for (const auto& period : world.timeSteps) longest = std::max(longest, period.timeStep);
    for (const auto& period : first.timeSteps) longest = std::max(longest, period.timeStep);
    checkSame(birthsOf(first), birthsOf(world), 3 * longest);  // one step for each of three divisions
    checkSame(sharesOf(first), sharesOf(world), 1e-12);        // fluid is shared out exactly, up to rounding
    checkSame(factorsOf(first), factorsOf(world), 0);
  }
  Scene other = all[0].second;
  other.seed = 12;
  const World another = ranToEnd(other);
  CHECK(birthsOf(another) != birthsOf(first));
  CHECK(sharesOf(another) != sharesOf(first));
  CHECK(factorsOf(another) != factorsOf(first));
}

TEST_CASE("The first cells stand off their places by the same under every policy") {
  std::vector<Point> starts;
  for (const auto& [name, scene] : policies()) starts.push_back(centreOf(makeWorld(scene)));
  for (const Point& x : starts) CHECK(norm(x - starts[0]) == 0);
  Scene still = policies()[0].second;
  still.variation.start = 0;
  CHECK(norm(centreOf(makeWorld(still)) - starts[0]) > 0.01);
}

TEST_CASE("An axis is tilted by the same angle, whatever direction it is tilted from") {
  Scene x = balls(), y = balls();
  x.mechanics->division.otherwise = {DivisionPlane::axis, {1, 0, 0}};
  y.mechanics->division.otherwise = {DivisionPlane::axis, {1, 2, 2}};
  y.mechanics->connections = ConnectionParameters{MakeConnections::atDivision, ConnectionsOnDivision::both, 0.2, {}};
  const auto a = tiltsOf(ranToEnd(x), {1, 0, 0}), b = tiltsOf(ranToEnd(y), {1, 2, 2});
  checkVaries(a, 1e-3);
  checkSame(a, b, 1e-13);  // rounding of the products and root that turn the angle into place
}
