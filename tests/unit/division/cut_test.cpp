// The cut: the daughters' shares add up to the mother's.
#include "division/cut.h"

#include "catch.h"
#include "cuts.h"

using namespace morula;

namespace {

Body moving(const Mesh& mesh) {
  Body b = shakenBody(mesh, 0, 1);
  b.mass = 3;
  b.restScale = 0.9;
  b.pressureConstant = 5;
  return b;
}

double volumeOf(const Body& b, const Mesh& mesh) { return measureVolume(b.position, mesh.faces); }

/// Returns star-shaped and convex bodies that a plane through the middle cuts into two pieces.
std::vector<zoo::Animal> convexBodies() {
  return {{"sphere", makeIcosphere(2)},
          {"egg", zoo::scaled(makeIcosphere(2), {27, 15, 11})},
          {"disc", zoo::scaled(makeIcosphere(2), {1, 1, 0.3})},
          {"away", zoo::moved(makeIcosphere(3), {5, -7, 11})},
          {"cube", zoo::box({-1, -1, -1}, {1, 1, 1})},
          {"tetrahedron", zoo::tetrahedron()}};
}

}  // namespace

TEST_CASE("Gas pressure and density at birth are the mother's where no volume is lost") {
  const Mesh mesh = makeIcosphere(2);
  const Body mother = moving(mesh);
  const CutResult cut =
      cutBody(mother, mesh.faces, throughMean(mother, randomDirection({5, {}, 0, Purpose::test})), 1.26);
  for (const Body* daughter : {&cut.daughters.a, &cut.daughters.b}) {
    CHECK(daughter->pressureConstant / volumeOf(*daughter, mesh) ==
          Approx(mother.pressureConstant / volumeOf(mother, mesh)).epsilon(1e-13));
    CHECK(daughter->mass / volumeOf(*daughter, mesh) == Approx(mother.mass / volumeOf(mother, mesh)).epsilon(1e-13));
  }
}

TEST_CASE("Volumes, masses, gas and momentum add up to the mother's, whatever the direction") {
  for (const auto& [name, mesh, handles] : convexBodies())
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Body mother = moving(mesh);
      const Vector normal = randomDirection({seed, {}, 0, Purpose::test});
      const CutResult cut = cutBody(mother, mesh.faces, throughMean(mother, normal), 1.26);
      CAPTURE(name, seed);
      REQUIRE(cut.failure == "");
      const auto& [a, b] = cut.daughters;
      const double volume = volumeOf(a, mesh) + volumeOf(b, mesh);
      // A slanted cut through a long body overhangs and is unfolded, which takes a little of its volume.
      if (projectionFolds(mother, mesh, normal) == 0) CHECK(volume == Approx(volumeOf(mother, mesh)).epsilon(1e-13));
      else CHECK(volume == Approx(volumeOf(mother, mesh)).epsilon(0.05));
      CHECK(a.mass + b.mass == Approx(3).epsilon(1e-15));
      CHECK(a.pressureConstant + b.pressureConstant == Approx(5).epsilon(1e-15));
      CHECK(norm(momentumOf(a) + momentumOf(b) - momentumOf(mother)) < 1e-15);
      // Shares go by volume, so that pressure and density of both daughters are equal.
      CHECK(a.mass / volumeOf(a, mesh) == Approx(3 / volume).epsilon(1e-13));
      CHECK(b.pressureConstant / volumeOf(b, mesh) == Approx(5 / volume).epsilon(1e-13));
      CHECK(a.velocity == mother.velocity);
      CHECK(b.velocity == mother.velocity);
    }
}

TEST_CASE("A tenth of the volume is enough for a daughter, and less is not") {
  const Mesh mesh = zoo::box({0, 0, 0}, {6, 1, 10});  // its volumes are exact
  const Body mother = moving(mesh);
  for (const double sign : {1.0, -1.0}) {
    const auto cutAt = [&](double height) {
      return cutBody(mother, mesh.faces, {.point = {0, 0, height}, .normal = {0, 0, sign}, .share = {}}, 1.26).failure;
    };
    CHECK(cutAt(1) == "");
    CHECK(cutAt(9) == "");
    CHECK(cutAt(0.999) != "");
    CHECK(cutAt(9.001) != "");
  }
}

TEST_CASE("Of a sphere each daughter gets half") {
  const Mesh mesh = makeIcosphere(2);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const CutResult cut = cutBody(moving(mesh), mesh.faces,
                                  throughMean(moving(mesh), randomDirection({seed, {}, 0, Purpose::test})), 1.26);
    CHECK(volumeOf(cut.daughters.a, mesh) == Approx(measureVolume(mesh.vertices, mesh.faces) / 2).epsilon(1e-13));
    CHECK(cut.daughters.a.mass == Approx(1.5).epsilon(1e-13));
  }
}

TEST_CASE("Each vertex stays with one daughter and lies on the plane in the other, below itself") {
  const Mesh mesh = makeIcosphere(2);
  const Vector normal = randomDirection({1, {}, 0, Purpose::test});
  const Body mother = moving(mesh);
  const CutResult cut = cutBody(mother, mesh.faces, throughMean(mother, normal), 1.26);
  const auto& [a, b] = cut.daughters;
  const Point centre = measureCentroid(mother.position);
  Worst error;
  int toA = 0, toB = 0;
  for (std::size_t v = 0; v < mother.position.size(); ++v) {
    const double height = dot(mother.position[v] - centre, normal);
    const Point foot = mother.position[v] - height * normal;
    const Body &owner = height > 0 ? a : b, &other = height > 0 ? b : a;
    ++(height > 0 ? toA : toB);
    CHECK(owner.position[v] == mother.position[v]);
    error.see(norm(other.position[v] - foot));
  }
  CHECK(error < 1e-15);
  CHECK(toA == 81);
  CHECK(toB == 81);
}

TEST_CASE("No face of a convex body is turned over by a cut that folds nothing") {
  int cuts = 0;
  for (const auto& [name, mesh, handles] : convexBodies())
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Vector normal = randomDirection({seed, {}, 0, Purpose::test});
      const CutResult cut = cutBody(moving(mesh), mesh.faces, throughMean(moving(mesh), normal), 1.26);
      if (projectionFolds(moving(mesh), mesh, normal) > 0) continue;
      ++cuts;
      for (const Body* daughter : {&cut.daughters.a, &cut.daughters.b}) {
        // Seen from inside the daughter all faces look outward, except faces that a needle-thin edge made flat.
        Point inside;
        double weight = 0;
        for (const auto& [i, j, k] : mesh.faces) {
          const auto& x = daughter->position;
          const double area = norm(cross(x[j] - x[i], x[k] - x[i]));
          inside += area * (x[i] + x[j] + x[k]) / 3.0;
          weight += area;
        }
        inside = inside / weight;
        Worst inwards;
        for (const auto& [i, j, k] : mesh.faces) {
          const auto& x = daughter->position;
          inwards.see(-dot(cross(x[j] - x[i], x[k] - x[i]), x[i] - inside) / weight);
        }
        CAPTURE(name, seed);
        CHECK(inwards < 1e-12);
      }
    }
  CHECK(cuts > 40);
}

TEST_CASE("Membrane: two halves share `production` times their mother's area alike") {
  const Mesh mesh = makeIcosphere(2);
  const Body mother = moving(mesh);
  for (double production : {1.0, 1.26, 1.5}) {
    const CutResult cut = cutBody(mother, mesh.faces, throughMean(mother, {1, 0, 0}), production);
    const double a = cut.daughters.a.restScale / mother.restScale, b = cut.daughters.b.restScale / mother.restScale;
    CHECK(a * a + b * b == Approx(production).epsilon(1e-14));
    CHECK(a == Approx(b).epsilon(1e-13));
  }
  // With a production of ∛2 a half has the lengths of a sphere of half the volume: 2^(−1/3).
  const CutResult cut = cutBody(mother, mesh.faces, throughMean(mother, {1, 0, 0}), std::cbrt(2.0));
  CHECK(cut.daughters.a.restScale == Approx(mother.restScale / std::cbrt(2.0)).epsilon(1e-13));
}

TEST_CASE("Unequal daughters get membrane by the area of spheres of their volumes") {
  const Mesh mesh = zoo::tetrahedron();
  const CutResult cut =
      cutBody(moving(mesh), mesh.faces, throughMean(moving(mesh), Vector{1, 1, 1} / std::sqrt(3.0)), 1.26);
  REQUIRE(cut.failure == "");
  const auto& [a, b] = cut.daughters;
  const double volumes = volumeOf(a, mesh) / volumeOf(b, mesh);
  REQUIRE(std::abs(volumes - 1) > 0.1);
  CHECK(a.restScale / b.restScale == Approx(std::cbrt(volumes)).epsilon(1e-13));
}

TEST_CASE("A body that would have next to no volume on one side does not divide, and the failure says so") {
  // A nail has most vertices in its thin shaft and most of its volume in its head.
  const Mesh mesh = makeIcosphere(2);
  Body nail = moving(mesh);
  for (Point& x : nail.position)
    if (x.x > -0.5) x = {x.x, 0.05 * x.y, 0.05 * x.z};
  CHECK_THAT(cutBody(nail, mesh.faces, throughMean(nail, {1, 0, 0}), 1.26).failure,
             ContainsSubstring("cut the cell's volume into"));
  CHECK(cutBody(nail, mesh.faces, throughMean(nail, {0, 1, 0}), 1.26).failure == "");

  const Mesh insideOut = zoo::inverted(mesh);
  CHECK(cutBody(moving(insideOut), insideOut.faces, throughMean(moving(insideOut), {1, 0, 0}), 1.26).failure != "");
  Body broken = moving(mesh);
  broken.position[3].x = std::nan("");
  CHECK(cutBody(broken, mesh.faces, throughMean(broken, {1, 0, 0}), 1.26).failure != "");
}

TEST_CASE("A plane beside the centre gives daughter A the cap before it") {
  const Mesh ball = makeIcosphere(3);
  for (const double height : {-0.4, 0.0, 0.3, 0.5}) {
    const CutResult cut = cutBody(moving(ball), ball.faces, {{0, height, 7}, {0, 1, 0}}, 1.26);
    REQUIRE(cut.failure == "");
    const double cap = (1 - height) * (1 - height) * (2 + height) / 4;  // π(1−h)²(2+h)/3 over 4π/3
    CHECK(cut.daughters.a.mass / moving(ball).mass == Approx(cap).margin(0.01));
    CHECK(cut.daughters.a.mass + cut.daughters.b.mass == moving(ball).mass);
    for (const Point& x : cut.daughters.a.position) CHECK(x.y >= height - 1e-15);
    for (const Point& x : cut.daughters.b.position) CHECK(x.y <= height + 1e-15);
  }
}

TEST_CASE("A sphere is shared by the cut's ratio, and both parts touch its outline from inside") {
  Body mother;
  mother.position = {{1, 2, 3}};
  mother.velocity = {{}};
  mother.mass = 3;
  mother.restScale = 0.8;
  mother.pressureConstant = 5;
  const Vector axis{0.6, 0, 0.8};
  for (const double ratio : {0.5, 0.58, 0.2}) {
    const auto [a, b] = divideSphere(mother, 2, {{9, 9, 9}, axis, ratio});
    const double radiusA = 2 * a.restScale / mother.restScale, radiusB = 2 * b.restScale / mother.restScale;
    CHECK(std::pow(radiusA / 2, 3) == Approx(ratio).epsilon(1e-14));
    CHECK(std::pow(radiusB / 2, 3) == Approx(1 - ratio).epsilon(1e-14));
    CHECK(a.mass == Approx(3 * ratio).epsilon(1e-15));
    CHECK(a.mass + b.mass == 3);
    CHECK(a.pressureConstant + b.pressureConstant == 5);
    const double outA = dot(a.position[0] - mother.position[0], axis) + radiusA;
    const double outB = dot(mother.position[0] - b.position[0], axis) + radiusB;
    CHECK(outA == Approx(2).epsilon(1e-14));
    CHECK(outB == Approx(2).epsilon(1e-14));
    CHECK(norm(cross(a.position[0] - b.position[0], axis)) < 1e-14);
  }
}
