// Adhesion as work per area, whatever the mesh and the cells' sizes. Tests of the law's equations: pair_law_test.cpp.
#include <array>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "catch.h"
#include "contacts/pair_energy.h"
#include "crowd.h"

using namespace morula;

namespace {

constexpr double pi = std::numbers::pi;

ContactParameters sticky(double work, double viscosity = 0, double radius = 1) {
  ContactParameters c{ContactLaw::pair, 40, 0.05, viscosity, 0.01, radius};
  c.adhesion = AdhesionParameters{work, {}};
  return c;
}

/// Returns the mean rest area of a cell's vertices, from the mesh alone. [length²]
double restArea(const Bodies& b, int slot) {
  return measureArea(b.mesh.mesh.vertices, b.mesh.mesh.faces) * b.restScale[slot] * b.restScale[slot] / b.vertexCount();
}

/// Returns the adhesion energy between all cells. [force·length]
double adhesionEnergy(const Crowd& crowd) {
  double sum = 0;
  for (const PairSum& p : sumPairs(crowd.contacts, crowd.lab.bodies)) sum += p.adhesion;
  return sum;
}

/// Returns adhesion energy plus repulsion energy: surfaces that touch overlap where they slope at the border.
double contactEnergy(const Crowd& crowd) {
  double sum = adhesionEnergy(crowd);
  for (const PairSum& p : sumPairs(crowd.contacts, crowd.lab.bodies)) sum += p.repulsion;
  return sum;
}

constexpr int across = 28;             // edges of a cushion
constexpr double halfThickness = 0.6;  // more than the reach of vertices on the other side

/// Returns two flat sheets of one lattice at x = ±halfThickness, sewn together at their border, where faces slope and
/// are as large as the others.
Mesh cushion(const Vector& e, const Vector& f) {
  Mesh m;
  const auto along = [&](int i, const Vector& other) {  // from the middle, in steps
    const double row = norm(cross(e, f)) / norm(other), sloping = 1 - halfThickness * halfThickness / (row * row);
    const double inwards = 1 - std::sqrt(sloping);
    return (i == 0 ? inwards : i == across ? across - inwards : i) - across / 2.0;
  };
  std::map<std::tuple<int, int, int>, int> numbers;
  const auto number = [&](int side, int i, int j) {
    if (i == 0 || j == 0 || i == across || j == across) side = 0;
    const auto [it, isNew] = numbers.try_emplace({side, i, j}, static_cast<int>(m.vertices.size()));
    if (isNew) m.vertices.push_back(Vector{side * halfThickness, 0, 0} + along(i, f) * e + along(j, e) * f);
    return it->second;
  };
  for (int side : {-1, 1})
    for (int i = 0; i < across; ++i)
      for (int j = 0; j < across; ++j) {
        // With one diagonal only, corners would have a face of three border vertices on both sides.
        const bool other = (i == 0 && j == across - 1) || (i == across - 1 && j == 0);
        const int a = number(side, i, j), b = number(side, i + 1, j), c = number(side, i + 1, j + 1),
                  d = number(side, i, j + 1);
        for (const Face& t : other ? std::array<Face, 2>{Face{a, b, d}, Face{b, c, d}}
                                   : std::array<Face, 2>{Face{a, b, c}, Face{a, c, d}})
          m.faces.push_back(side > 0 ? t : Face{t[0], t[2], t[1]});
      }
  return m;
}

const double third = 2 * pi / 3;
struct Lattice {
  const char* name;
  Vector e, f;
};
const std::vector<Lattice> lattices{{"squares", {0, 1, 0}, {0, 0, 1}},
                                    {"triangles", {0, 1, 0}, {0, std::cos(third / 2), std::sin(third / 2)}},
                                    {"stretched", {0, 1, 0}, {0, 0, 0.7}}};

/// Returns the vertex in the middle of the right face.
int middleOf(const Mesh& mesh) {
  const auto nearest = std::ranges::min_element(mesh.vertices, {}, [](const Point& x) {
    return norm(x - Vector{halfThickness, 0, 0});
  });
  return static_cast<int>(nearest - mesh.vertices.begin());
}

/// Returns two cushions with a gap, the right one scaled by `size` and shifted.
Crowd faceToFace(const Mesh& mesh, double work, double gap, double size = 1, const Vector& shift = {}) {
  Body left = shakenBody(mesh, 0, 0), right = left;
  const double depth =
      Rings(mesh).see(mesh.vertices, middleOf(mesh), 1 / (meanEdge(mesh) * meanEdge(mesh)), measureSag(mesh)).y.x -
      halfThickness;
  for (Point& x : right.position) x = size * x + Vector{(halfThickness + depth) * (1 + size) + gap, 0, 0} + shift;
  right.restScale = size;
  return {limp(), sticky(work), mesh, {left, right}};
}

/// Returns the energy per area that the middle of the left cushion's right face holds, averaged over shifts, since it
/// is chance how vertices face each other. [force/length]
double energyPerArea(const Vector& e, const Vector& f, double gap, double size) {
  const Mesh mesh = cushion(e, f);
  constexpr int shifts = 4;
  double energy = 0;
  int vertices = 0;
  for (int a = 0; a < shifts; ++a)
    for (int b = 0; b < shifts; ++b) {
      const Vector shift = (a + 0.3) / shifts * e + (b + 0.3) / shifts * f;
      const Crowd crowd = faceToFace(mesh, 1, gap, size, size * shift);
      const Bodies& bodies = crowd.lab.bodies;
      for (int v = 0; v < bodies.vertexCount(); ++v) {
        const Point x = bodies.vertex(0, v);
        vertices += x.x > 0 && std::abs(x.y) < 2.6 && std::abs(x.z) < 2.6;
      }
      for (const PairSum& p : sumPairs(crowd.contacts, bodies)) {
        const Point x = bodies.vertex(p.slot, p.vertex / blockLanes);
        if (p.slot == 0 && x.x > 0 && std::abs(x.y) < 2.6 && std::abs(x.z) < 2.6) energy += 2 * p.adhesion;
      }
    }
  return energy / (vertices * norm(cross(e, f)));
}

/// Returns the energy of two balls with a gap between their surfaces, averaged over turns. [force·length]
double energyOfBalls(const Mesh& ball, double gap, double size = 1, double other = 1) {
  double surface = 0;  // the surface's radius, within the corners
  const Rings rings(ball);
  const double edge = meanEdge(ball);
  for (std::size_t v = 0; v < ball.vertices.size(); ++v)
    surface += norm(rings.see(ball.vertices, static_cast<int>(v), 1 / (edge * edge), measureSag(ball)).y) /
               static_cast<double>(ball.vertices.size());
  constexpr std::uint32_t turns = 24;
  double sum = 0;
  for (std::uint32_t key = 0; key < turns; ++key) {
    const double distance = surface * (size + other) + gap;
    const Crowd crowd(limp(), sticky(1), ball,
                      {turnedBody(ball, key, size), turnedBody(ball, key + 100, other, {distance, 0, 0})});
    sum += adhesionEnergy(crowd);
  }
  return sum / turns;
}

}  // namespace

TEST_CASE("Flat surfaces hold W (1 - g²/A²)⁴ per area over a gap g, whatever the mesh and their sizes") {
  for (const auto& [name, e, f] : lattices)
    for (const double size : {1.0, 0.6}) {
      const double radius = attractionReach * meanEdge(cushion(e, f)),
                   reach = radius / std::sqrt((1 + 1 / (size * size)) / 2);
      for (const double gap : {0.0, 0.3, 0.6}) {
        const double share = 1 - gap * gap;
        CAPTURE(name, size, gap);
        CHECK(std::abs(energyPerArea(e, f, gap * reach, size) + share * share * share * share) < 0.01);
      }
    }
}

TEST_CASE("The work that parts two surfaces is the energy they held, and goes with W") {
  for (const auto& [name, e, f] : lattices) {
    const Mesh mesh = cushion(e, f);
    const double reach = 1.01 * attractionReach * meanEdge(mesh);
    constexpr int steps = 160;
    double work = 0;
    for (int k = 0; k <= steps; ++k) {  // [Simpson]
      Crowd crowd = faceToFace(mesh, 2, k * reach / steps);
      crowd.evaluateForces();
      work += (k == 0 || k == steps ? 1 : k % 2 ? 4 : 2) * crowd.lab.forceOn(0).x * reach / steps / 3;
    }
    CAPTURE(name);
    CHECK(work == Approx(-contactEnergy(faceToFace(mesh, 2, 0))).epsilon(1e-4));
    CHECK(adhesionEnergy(faceToFace(mesh, 2, 0)) == Approx(2 * adhesionEnergy(faceToFace(mesh, 1, 0))));
  }
}

TEST_CASE("Balls hold what spheres do by Derjaguin") {
  // [Derjaguin 1934] E(D) = −2πR* ∫ W (1 − g²/A²)⁴ dg from D on, with R* = ½ for two balls of radius 1. From 0 on the
  // integral is 128/315 W A.
  const auto expected = [](double star, double reach) { return -2 * pi * star * 128 / 315 * reach; };
  for (const auto& [level, tolerance] : {std::pair{2, 0.07}, {3, 0.03}, {4, 0.02}}) {
    const Mesh ball = makeIcosphere(level);
    const double reach = attractionReach * meanEdge(ball);
    CAPTURE(level, reach);
    CHECK(energyOfBalls(ball, 0) == Approx(expected(0.5, reach)).epsilon(tolerance));
    CHECK(energyOfBalls(ball, 0, 0.5, 0.5) == Approx(expected(0.25, reach / 2)).epsilon(tolerance));
    CHECK(energyOfBalls(ball, 0, 1, 0.5) == Approx(expected(1.0 / 3, reach * std::sqrt(2.0 / 5))).epsilon(tolerance));
  }
}

TEST_CASE("Surfaces that come near draw each other from A on, most at 0.38 A") {
  const Mesh mesh = cushion(lattices[1].e, lattices[1].f);
  const double reach = attractionReach * meanEdge(mesh);
  const auto pull = [&](double gap) {
    Crowd crowd = faceToFace(mesh, 1, gap * reach);
    crowd.evaluateForces();
    return crowd.lab.forceOn(0).x;
  };
  CHECK(pull(1.01) == 0);
  CHECK(pull(0.38) > 1.1 * pull(0.2));
  CHECK(pull(0.38) > 1.1 * pull(0.6));
}

TEST_CASE("No arrangement holds more than 1.1 W per area of its surfaces, however vertices crowd") {
  const Mesh ball = makeIcosphere(1);
  Worst most;
  for (std::uint32_t key = 0; key < 40; ++key) {
    // Cells in and beside each other; in every second heap all their vertices are drawn to a few places.
    std::vector<Body> cells = heap(ball, 6, 0.3 + 0.04 * key, 0, key);
    for (Body& cell : cells)
      for (std::size_t v = 0; key % 2 == 0 && v < cell.position.size(); ++v)
        cell.position[v] = 0.1 * cell.position[v] + noiseVector(v % 5, key);
    const Crowd crowd(limp(), sticky(2), ball, cells);
    double area = 0;
    for (int slot : crowd.lab.bodies.slots) area += restArea(crowd.lab.bodies, slot) * crowd.lab.bodies.vertexCount();
    most.see(-adhesionEnergy(crowd) / (2 * area / 2));
  }
  CHECK(most <= 1.1 * (1 + 1e-12));
  CHECK(most > 0.9);  // some come near
}

TEST_CASE("A pair's two strengths in the list are the same to the bit, and those of its cells' kinds") {
  Crowd crowd(limp(), sticky(3), ball, heap(ball, 9, 1.9, 0.5));
  Contacts& c = crowd.contacts;
  AdhesionKinds kinds{{}, 2, {1, 2, 2, 5}};
  for (int slot = 0; slot < 16; ++slot) kinds.ofSlot.push_back(slot / 3 % 2);  // row by row
  setAdhesionKinds(c, kinds);
  crowd.evaluateForces();
  const VertexNumber far = crowd.lab.bodies.lineCount() * blockLanes;
  std::map<std::pair<VertexNumber, VertexNumber>, double> strength;
  for (int block = 0; block < crowd.lab.bodies.blockCount(); ++block)
    for (const NeighbourSlice& slice : c.list.perBlock[block].slices)
      for (int lane = 0; lane < blockLanes; ++lane)
        for (int k = 0; k < slice.length; ++k) {
          const std::int64_t at = (slice.start + k) * blockLanes + lane;
          const VertexNumber j = c.list.perBlock[block].indices[at];
          if (j == far) CHECK(c.adhesion.ofPairs[block][at] == 0);
          else strength[{slice.vertex[lane], j}] = c.adhesion.ofPairs[block][at];
        }
  CHECK(strength.size() > 100);
  bool same = true;
  Worst error;
  std::set<double> works;
  for (const auto& [pair, s] : strength) {
    same = same && strength.at({pair.second, pair.first}) == s;
    const int i = crowd.slotOf(pair.first), j = crowd.slotOf(pair.second);
    const double work = kinds.work[kinds.ofSlot[i] * 2 + kinds.ofSlot[j]];
    works.insert(work);
    const double x = 1 / (c.radius[i] * c.radius[i]), y = 1 / (c.radius[j] * c.radius[j]);
    const double mean = (x + y) / 2 / (attractionReach * attractionReach);
    // The factor s belongs to flat meshes face to face, with normals as long as G = 6a makes them.
    const double g = 6 * restArea(crowd.lab.bodies, 0) / (c.radius[0] * c.radius[0]);
    const double m = 1 + (1 + 4.0 / 27) * g * g / (g * g + 4);
    error.see(std::abs(s - 24 / pi * work * restArea(crowd.lab.bodies, i) * restArea(crowd.lab.bodies, j) * mean /
                               (m * m * (3 - m) / 4)));
  }
  CHECK(same);
  CHECK(error < 1e-12);
  CHECK(works == std::set<double>{1, 2, 5});
}

TEST_CASE("The steepest adhesion counts against the time step; without adhesion there is none") {
  const Mesh ball = makeIcosphere(2);
  ContactParameters plain = sticky(2), pairs = sticky(2);
  plain.adhesion.reset();
  pairs.adhesion->pairs.push_back({"a", "b", 4});
  const auto of = [&](const ContactParameters& law, double smaller) {
    Body one = shakenBody(ball, 0, 0), other = one;
    other.restScale = smaller;
    const Crowd crowd(limp(), law, ball, {one, other});
    return adhesionStiffness(crowd.contacts, crowd.lab.bodies);
  };
  // α² T/A² = T/R² for W = 1, with n = 1 to a hundredth: 24/π a²/(A² R²)
  const double share = measureArea(ball.vertices, ball.faces) / static_cast<double>(ball.vertices.size()) /
                       (meanEdge(ball) * meanEdge(ball));
  const double one = 24 / pi * share * share / (attractionReach * attractionReach);
  CHECK(of(plain, 1) == 0);
  CHECK(of(sticky(2), 1) == Approx(2 * one).epsilon(0.03));
  CHECK(of(pairs, 1) == Approx(4 * one).epsilon(0.03));
  CHECK(of(sticky(2), 0.5) == Approx(of(sticky(2), 1) * 25 / 16).epsilon(1e-6));
}

TEST_CASE("Two cells stick with the mean of their own factors") {
  const Mesh ball = makeIcosphere(2);
  const Body one = ballAt(ball, {}), other = ballAt(ball, {2.05, 0, 0});
  const auto pullWith = [&](std::vector<double> factor) {
    Crowd crowd(limp(), sticky(2), ball, {one, other});
    AdhesionKinds kinds{std::vector<int>(8, 0), 1, {2}, std::move(factor)};
    setAdhesionKinds(crowd.contacts, kinds);
    crowd.evaluateForces();
    return crowd.lab.forceOn(0).x;
  };
  const double plain = pullWith({});
  CHECK(plain > 0.1);
  CHECK(pullWith(std::vector<double>(8, 1)) == plain);
  CHECK(pullWith({1.5, 0.9, 1, 1, 1, 1, 1, 1}) == Approx(1.2 * plain));
}
