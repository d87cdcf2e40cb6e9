#include "bench/packed_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include "base/error.h"
#include "base/fields.h"
#include "base/maths.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "files/write_file.h"
#include "observation/measures.h"
#include "simulation/make_world.h"
#include "simulation/population.h"

namespace morula {
namespace {

constexpr int rounds = 60;
constexpr double spacing = 1.7;  // [share radii] wanted distance of centres; 1.81 is that of the densest packing

double fraction(double a) { return a - std::floor(a); }

/// Returns points of the recurrence with the steps 1/g, 1/g², 1/g³, g⁴ = g + 1: as even as an endless sequence can be.
std::vector<Point> spreadPoints(int count, double radius) {
  constexpr double g = 1.2207440846057596;
  std::vector<Point> points;
  for (int i = 1; static_cast<int>(points.size()) < count; ++i) {
    const Point p{2 * fraction(0.5 + i / g) - 1, 2 * fraction(0.5 + i / (g * g)) - 1,
                  2 * fraction(0.5 + i / (g * g * g)) - 1};
    if (dot(p, p) <= 1) points.push_back(radius * p);
  }
  return points;
}

/// Points by the cubes of a grid over the unit ball, no narrower than `distance`.
class PointGrid {
 public:
  PointGrid(const std::vector<Point>& points, double distance)
      : side_(std::max(1, static_cast<int>(2 / (1.01 * distance)))), begin_(std::size_t(side_) * side_ * side_ + 1) {
    for (const Point& p : points) cube_.push_back({index(p.x), index(p.y), index(p.z)});
    for (const auto& c : cube_) ++begin_[number(c[0], c[1], c[2]) + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<std::int32_t> next = begin_;
    members_.resize(points.size());
    for (std::size_t i = 0; i < cube_.size(); ++i) {
      const auto& c = cube_[i];
      members_[next[number(c[0], c[1], c[2])]++] = static_cast<std::int32_t>(i);
    }
  }
  /// Sets `near` to the points after i in the cubes around it, in rising order: all that are closer than `distance`.
  void findAfter(std::int32_t i, std::vector<std::int32_t>& near) const {
    near.clear();
    const auto [x, y, z] = cube_[i];
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, side_ - 1); ++u)
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, side_ - 1); ++v)
        for (int w = std::max(z - 1, 0); w <= std::min(z + 1, side_ - 1); ++w)
          for (auto m = begin_[number(u, v, w)]; m < begin_[number(u, v, w) + 1]; ++m)
            if (members_[m] > i) near.push_back(members_[m]);
    std::ranges::sort(near);
  }

 private:
  int index(double a) const { return std::clamp(static_cast<int>(0.5 * (a + 1) * side_), 0, side_ - 1); }
  int number(int x, int y, int z) const { return (x * side_ + y) * side_ + z; }

  int side_;  // [cube]
  std::vector<std::array<int, 3>> cube_;
  std::vector<std::int32_t> begin_, members_;
};

void nameByHalving(std::span<Point> points, const CellPath& path, std::vector<PlacedCell>& cells) {
  if (points.size() == 1) {
    cells.push_back({path, points[0]});
    return;
  }
  Point low = points[0], high = points[0];
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vector side = high - low;
  const auto along = [&](const Point& p) {
    return side.x >= side.y && side.x >= side.z ? p.x : side.y >= side.z ? p.y : p.z;
  };
  std::sort(points.begin(), points.end(), [&](const Point& a, const Point& b) {
    if (along(a) != along(b)) return along(a) < along(b);
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  });
  const std::size_t half = points.size() / 2;
  nameByHalving(points.first(half), path.daughter(false), cells);
  nameByHalving(points.subspan(half), path.daughter(true), cells);
}

// Version of the packing. A change of it needs a new number, so that old files are not read.
constexpr int recipe = 2;
constexpr double startScale = 0.72;  // share of the rest radius at which spheres hardly overlap
constexpr double wantedFill = 0.85;  // share of the shell's volume that the cells fill
constexpr double slow = 2e-4;        // rms move per step in edges, below which the cells are at rest
constexpr int minSteps = 200, maxSteps = 20000;

std::vector<Body> smallSpheres(const World& world, const std::vector<PlacedCell>& places) {
  const int n = static_cast<int>(places.size());
  const double scale = shareRadius(n);
  std::vector<Body> bodies;
  for (const PlacedCell& place : places) {
    Body cell = makeEgg(*world.bodies);
    for (Point& x : cell.position) x = place.centre + (startScale * scale) * x;
    cell.mass /= n;
    cell.pressureConstant /= n;
    cell.restScale = scale;
    bodies.push_back(std::move(cell));
  }
  return bodies;
}

std::vector<CellPath> paths(const std::vector<PlacedCell>& places) {
  std::vector<CellPath> list;
  for (const PlacedCell& place : places) list.push_back(place.path);
  return list;
}

/// Returns the root mean square movement of a vertex in one step, in mean rest lengths.
double moveInEdges(const World& world) {
  const WorldMeasures m = measureWorld(world);
  const Bodies& b = *world.bodies;
  const double speed = std::sqrt(2 * m.at("kinetic_energy") / (b.mass(0) * b.count));
  return speed * world.clock.timeStep / (b.mesh.meanRestLength * b.restScale[0]);
}

std::vector<Body> settle(const PackedScene& packed, const std::vector<PlacedCell>& places,
                         const std::function<void(const std::string&)>& tell) {
  tell(fmt::format("packing {} cells of {} vertices, which are kept for the next bench", packed.cells,
                   makeIcosphere(packed.level).vertices.size()));
  const Scene scene = describe({packed.cells, packed.level});
  const World empty = makeWorld(scene);
  World world = makeWorldOf(scene, paths(places), smallSpheres(empty, places), {});
  beginWithBodies(world);
  for (int i = 1; i <= maxSteps; ++i) {
    step(world);
    // Compressed gas is stiff: as the cells swell the time step may grow.
    if (i % 256 == 0) beginWithBodies(world);
    if (i % 32 == 0 && i >= minSteps && moveInEdges(world) < slow) break;
  }
  const double fill = measureWorld(world)["shell_fill"].value_or(0);
  if (fill < wantedFill) throw BugError(fmt::format("{} cells fill only {:.3f} of their shell", packed.cells, fill));
  std::vector<Body> bodies;
  for (int slot = 0; slot < world.bodies->count; ++slot) bodies.push_back(takeBody(*world.bodies, slot));
  return bodies;
}

Hash keyOf(const PackedScene& packed, const Scene& scene) {
  const MechanicsScene& m = *scene.mechanics;
  Hasher h;
  h.field("packed").add(recipe).add(packed.cells).add(packed.level);
  h.field("membrane").add(m.physics.membrane.stiffness).add(m.physics.membrane.damping.fixed());
  h.field("pressure").add(m.physics.pressure.constant).add(m.physics.pressure.outside);
  h.field("drag").add(m.physics.drag);
  h.field("contact").add(m.contact->stiffness).add(m.contact->damping.fixed()).add(m.contact->radius);
  return h.digest();
}

constexpr std::uint64_t maxBytes = std::uint64_t{4} << 30;

std::string digest(const std::vector<double>& numbers) {
  Hasher h;
  return h.field("numbers").add(std::span<const double>(numbers)).digest().text();
}

}  // namespace

double shareRadius(int count) { return 1 / cubeRoot(count); }

void pushApart(std::vector<Point>& points, double distance, double radius) {
  const PointGrid grid(points, distance);
  std::vector<Vector> move(points.size());
  std::vector<std::int32_t> near;
  for (std::size_t i = 0; i < points.size(); ++i) {
    grid.findAfter(static_cast<std::int32_t>(i), near);
    for (const std::int32_t j : near) {
      const Vector d = points[j] - points[i];
      const double square = dot(d, d);
      if (square >= distance * distance || square == 0) continue;
      const Vector push = (0.25 * (distance / std::sqrt(square) - 1)) * d;
      move[i] -= push;
      move[j] += push;
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] += move[i];
    const double r = norm(points[i]);
    if (r > radius) points[i] = (radius / r) * points[i];
  }
}

std::vector<PlacedCell> packBall(int count) {
  const double share = shareRadius(count), radius = count == 1 ? 0 : 1 - 0.75 * share;
  std::vector<Point> points = spreadPoints(count, radius);
  for (int i = 0; i < rounds; ++i) pushApart(points, spacing * share, radius);
  std::vector<PlacedCell> cells;
  nameByHalving(points, CellPath{}, cells);
  return cells;
}

Scene describe(const PackedScene& packed) {
  Scene scene;
  scene.name = "bench";
  scene.dna = parseDna("START: a0\ng1(a0|a0)\n", "bench");
  scene.cycle.length = 1e9;
  MechanicsScene& m = scene.mechanics.emplace();
  m.mesh = makeIcosphere(packed.level);
  m.physics.drag = 20;
  m.physics.precision = packed.precision;
  if (packed.contact) {
    m.physics.shell = ShellParameters{};
    m.contact = ContactParameters{};
    m.contact->viscosity = packed.viscosity;
  }
  return scene;
}

World makeWorldOf(const Scene& scene, const std::vector<CellPath>& paths, const std::vector<Body>& bodies,
                  const Execution& execution) {
  World world = makeWorld(scene, execution);
  const StateId state = world.cells.state[0];
  world.cells = {};
  world.lineage.entries.clear();
  for (const CellPath& path : paths) addFounder(world, path, state);
  setBodies(*world.bodies, bodies);
  return world;
}

std::vector<Body> settledBodies(const PackedScene& packed, const std::filesystem::path& folder,
                                const std::function<void(const std::string&)>& tell) {
  const Hash key = keyOf(packed, describe({packed.cells, packed.level}));
  const auto file = folder / fmt::format("packed-{}x{}.bodies", packed.cells, packed.level);
  if (!folder.empty())
    if (auto bodies = readBodies(file, key)) return *std::move(bodies);
  auto bodies = settle(packed, packBall(packed.cells), tell);
  if (!folder.empty()) writeBodies(file, key, bodies);
  return bodies;
}

World makePackedWorld(const PackedScene& packed, const Execution& execution, const std::filesystem::path& folder,
                      const std::function<void(const std::string&)>& tell) {
  World world =
      makeWorldOf(describe(packed), paths(packBall(packed.cells)), settledBodies(packed, folder, tell), execution);
  beginWithBodies(world);
  return world;
}

std::optional<std::vector<Body>> readBodies(const std::filesystem::path& file, const Hash& key) {
  if (!fileExists(file)) return {};
  try {
    const std::string bytes = readFile(file, maxBytes);
    FieldReader in(bytes, "bodies");
    const std::vector<std::string> header = in.texts("key and digest");
    const std::vector<std::uint64_t> counts = in.numbers("bodies and vertices");
    const std::vector<double> numbers = in.reals("numbers");
    in.end();
    if (header != std::vector{key.text(), digest(numbers)} || counts.size() != 2) return {};
    if (counts[1] > numbers.size() || counts[0] * (3 + 6 * counts[1]) != numbers.size()) return {};
    std::vector<Body> bodies(counts[0]);
    const double* next = numbers.data();
    for (Body& body : bodies) {
      body.mass = *next++, body.restScale = *next++, body.pressureConstant = *next++;
      for (auto* array : {&body.position, &body.velocity})
        for (std::size_t v = 0; v < counts[1]; ++v, next += 3) array->push_back({next[0], next[1], next[2]});
    }
    return bodies;
  } catch (const InputError&) { return {}; }
}

void writeBodies(const std::filesystem::path& file, const Hash& key, const std::vector<Body>& bodies) {
  std::vector<double> numbers;
  for (const Body& body : bodies) {
    numbers.insert(numbers.end(), {body.mass, body.restScale, body.pressureConstant});
    for (const auto* array : {&body.position, &body.velocity})
      for (const Vector& a : *array) numbers.insert(numbers.end(), {a.x, a.y, a.z});
  }
  FieldWriter out;
  out.add("key and digest", std::vector{key.text(), digest(numbers)});
  out.add("bodies and vertices",
          std::vector<std::uint64_t>{bodies.size(), bodies.empty() ? 0 : bodies[0].position.size()});
  out.add("numbers", numbers);
  makeFolder(file.parent_path());
  overwriteFile(file, out.bytes());
}

}  // namespace morula
