// The pair law against its equations, written out for all pairs. In any state its forces are the gradient of an energy
// and keep momentum.
#include "catch.h"
#include "contacts/pair_energy.h"
#include "pair_oracle.h"

using namespace morula;

namespace {

struct Case {
  const char* name;
  ContactParameters law;
};

ContactParameters sticky(ContactParameters law, double work) {
  law.adhesion = AdhesionParameters{work, {}};
  return law;
}

const std::vector<Case> cases{{"plain", {}},
                              {"no damping", {ContactLaw::pair, 40, 0}},
                              {"damped", {ContactLaw::pair, 40, 0.5}},
                              {"viscosity", {ContactLaw::pair, 40, 0.05, 0.3}},
                              {"grip", {ContactLaw::pair, 40, 0.05, 2, 10}},
                              {"wide", {ContactLaw::pair, 40, 0.05, 0.1, 0.01, 2.5}},
                              {"adhesion", sticky({ContactLaw::pair, 40, 0}, 3)},
                              {"all", sticky({ContactLaw::pair, 40, 0.05, 0.3}, 3)}};

const Mesh ring = zoo::scaled(zoo::torus(7, 5), {0.33, 0.33, 0.33});
const Mesh box = zoo::box({-0.6, -0.6, -0.6}, {0.6, 0.6, 0.6});

/// Returns the largest difference between the crowd's and expected forces over the largest expected force, `largest`.
double errorOf(const Crowd& crowd, const std::vector<Vector>& expected, double& largest) {
  Worst error, most;
  const int vertices = crowd.lab.bodies.vertexCount();
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const int slot = static_cast<int>(i) / vertices, v = static_cast<int>(i) % vertices;
    error.see(norm(crowd.lab.force(slot, v) - expected[i]));
    most.see(norm(expected[i]));
  }
  largest = most;
  return error / most;
}

/// Returns a heap of cells whose vertices are `crumpled` at random, as an icosphere's are in `heap`.
std::vector<Body> heapOf(const Mesh& mesh, int count, double spacing, double crumpled, std::uint32_t key) {
  std::vector<Body> cells = heap(mesh, count, spacing, 0.5, key);
  for (std::uint32_t c = 0; c < cells.size(); ++c)
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v)
      cells[c].position[v] += crumpled * noiseVector(v, 31 * key + c);
  return cells;
}

}  // namespace

TEST_CASE("Contact forces are those of the equations over all pairs of vertices, for every variant of the law") {
  for (const auto& [name, law] : cases)
    for (const Mesh& mesh : {makeIcosphere(1), ring, box})
      for (int count : {2, 3, 9})
        for (const double timeStep : {0x1p-9, 0x1p-4}) {  // with the long step viscosity's bound follows from the step
          if (timeStep > 0x1p-9 && law.viscosity == 0) continue;
          Crowd crowd(
              evaluated({limp(), law, mesh, heapOf(mesh, count, mesh.vertices.size() == 42 ? 1.6 : 0.9, 0.03, 1)}));
          crowd.lawTimeStep = timeStep;
          crowd.evaluateForces();
          double largest;
          const double error = errorOf(crowd, PairOracle(crowd.lab.bodies, law, timeStep).forces(), largest);
          CAPTURE(name, mesh.vertices.size(), count, timeStep, largest);
          CHECK(largest > 0.1);
          CHECK(error < 1e-8);
        }
}

TEST_CASE("Forces are the gradient of an energy: its differences at 1000 random states, with and without adhesion") {
  const ContactParameters plain{ContactLaw::pair, 40, 0}, holding = sticky(plain, 3),
                                                          wide{ContactLaw::pair, 40, 0, 0, 0.01, 1.7};
  struct Kind {
    Mesh mesh;
    double spacing;
    std::uint32_t states;
    int every;  // one vertex in this many is tested
  };
  Worst worst;
  std::uint32_t touching = 0, saturated = 0;
  for (const auto& [mesh, spacing, states, every] :
       {Kind{makeIcosphere(1), 1.8, 500, 5}, {makeIcosphere(2), 1.9, 100, 17}, {ring, 0.8, 200, 5}, {box, 1.0, 200, 1}})
    for (std::uint32_t key = 0; key < states; ++key) {
      const ContactParameters& law = key % 3 == 0 ? plain : key % 3 == 1 ? holding : wide;
      auto cells =
          heapOf(mesh, 2 + static_cast<int>(key % 2), spacing + 0.3 * noise(2, key), key % 7 == 0 ? 0.2 : 0.03, key);
      const double size = key % 5 == 0 ? 0.6 : 1;  // sometimes the first cell is much smaller
      for (Point& x : cells[0].position) x = size * x;
      cells[0].restScale *= size;
      const Crowd crowd = evaluated({limp(), law, mesh, cells});
      const PairOracle oracle(crowd.lab.bodies, law);
      const double largest = largestForce(crowd.lab);
      for (const PairOracle::Crowding& of : oracle.crowding) saturated += of.density > 1.02;
      touching += largest > 0;
      for (int slot = 0; slot < crowd.lab.bodies.count; ++slot)
        for (int v = static_cast<int>(key) % every; v < crowd.lab.bodies.vertexCount(); v += every) {
          const Vector difference = crowd.lab.force(slot, v) - oracle.energyFalls(slot, v, 1e-6);
          if (largest > 1e-3) worst.see(norm(difference) / largest);
          else CHECK(norm(difference) < 1e-9);
        }
    }
  CHECK(touching > 900);
  CHECK(saturated > 200);  // vertices of which adhesion saturates
  CHECK(worst < 1e-6);
}

TEST_CASE("In single precision forces are the same but for its rounding") {
  PhysicsParameters p = limp();
  p.precision = Precision::binary32;
  for (const auto& [name, law] : cases) {
    const Crowd crowd = evaluated({p, law, ball, heap(ball, 9, 1.6, 0.5)});
    double largest;
    const double error = errorOf(crowd, PairOracle(crowd.lab.bodies, law, crowd.lawTimeStep).forces(), largest);
    CAPTURE(name, largest);
    CHECK(error < 2e-5);
  }
}

TEST_CASE("Energies that are measured are those of the equations, and their halves add up") {
  for (const auto& [name, law] : cases)
    for (const Mesh& mesh : {makeIcosphere(1), ring}) {
      Crowd crowd(limp(), law, mesh, heapOf(mesh, 9, mesh.vertices.size() == 42 ? 1.6 : 0.9, 0.03, 2));
      PairOracle::Energy sum;
      for (const PairSum& p : sumPairs(crowd.contacts, crowd.lab.bodies))
        sum.repulsion += p.repulsion, sum.adhesion += p.adhesion;
      const PairOracle::Energy expected = PairOracle(crowd.lab.bodies, law).energy();
      CAPTURE(name);
      CHECK(expected.repulsion > 0.01);
      CHECK(sum.repulsion == Approx(expected.repulsion).epsilon(1e-9));
      CHECK((expected.adhesion < -0.01) == law.adhesion.has_value());
      CHECK(sum.adhesion == Approx(expected.adhesion).epsilon(1e-6));
    }
}

TEST_CASE("How deep the deepest overlap of each block is, is that of the equations") {
  for (const auto& [name, law] : cases) {
    const Crowd crowd = evaluated({limp(), law, ball, heapOf(ball, 9, 1.6, 0.03, 3)});
    const PairOracle oracle(crowd.lab.bodies, law);
    CAPTURE(name);
    CHECK(crowd.lab.bodies.blockCount() == 2);
    for (int block = 0; block < crowd.lab.bodies.blockCount(); ++block) {
      const double expected = oracle.deepest(block * blockLanes, blockLanes);
      CHECK(expected > 0.001);
      CHECK(crowd.contacts.deepest[block] == Approx(expected).epsilon(1e-9));
    }
  }
}

TEST_CASE("Any two cells keep momentum and angular momentum, with damping, viscosity and adhesion") {
  for (const auto& [name, law] : cases)
    for (const Mesh& mesh : {makeIcosphere(1), ring, box})
      for (std::uint32_t key = 0; key < 10; ++key) {
        const Crowd crowd =
            evaluated({limp(), law, mesh, heapOf(mesh, 2, mesh.vertices.size() == 42 ? 1.6 : 0.9, 0.05, key)});
        Vector momentum, angular;
        double size = 0, moment = 0;
        for (int slot : {0, 1})
          for (int v = 0; v < crowd.lab.bodies.vertexCount(); ++v) {
            const Vector f = crowd.lab.force(slot, v), x = crowd.lab.bodies.vertex(slot, v);
            momentum += f, angular += cross(x, f);
            size += norm(f), moment += norm(x) * norm(f);
          }
        CAPTURE(name, mesh.vertices.size(), key);
        CHECK(size > 0.1);
        CHECK(norm(momentum) < 1e-14 * size);
        CHECK(norm(angular) < 1e-12 * moment);
      }
}

TEST_CASE("Two balls that overlap are pushed apart along the line between them; balls apart feel nothing") {
  const Mesh ball = makeIcosphere(2);
  double before = 0;
  for (double distance : {2.5, 1.95, 1.9, 1.8}) {
    const Crowd crowd = evaluated({limp(), {}, ball, {ballAt(ball, {}), ballAt(ball, {distance, 0, 0})}});
    const Vector push = crowd.lab.forceOn(1);
    CAPTURE(distance);
    if (distance > 2) CHECK(norm(push) == 0);
    else CHECK(push.x > 1.5 * before);
    CHECK(std::abs(push.y) + std::abs(push.z) <= 0.02 * push.x);
    before = push.x;
  }
}

TEST_CASE(
    "The force is continuous where pairs come into reach and where they begin to overlap, with damping and adhesion") {
  for (const auto& [name, law] : cases) {
    const Body left = ballAt(ball, {});
    Body right = ballAt(ball, {2.9, 0.1, 0.05});
    for (Vector& u : right.velocity) u = {-0.5, 0.2, 0};
    Crowd crowd(limp(), law, ball, {left, right});
    std::vector<Vector> before(2 * ball.vertices.size());
    Worst jump, largest;
    for (int i = 0; i < 2800; ++i) {
      for (std::size_t v = 0; v < right.position.size(); ++v)
        crowd.lab.setPosition(1, static_cast<int>(v), right.position[v] - Vector{i * 5e-4, 0, 0});
      crowd.evaluateForces();
      for (std::size_t k = 0; k < before.size(); ++k) {
        const Vector now =
            crowd.lab.force(static_cast<int>(k / ball.vertices.size()), static_cast<int>(k % ball.vertices.size()));
        jump.see(norm(now - before[k]));
        largest.see(norm(now));
        before[k] = now;
      }
    }
    CAPTURE(name);
    CHECK(largest > 1);
    CHECK(jump < 0.02 * largest);
  }
}

TEST_CASE("A ring that folds, its normal turning over through nothing, gives no jump and no large force") {
  for (const auto& [name, law] : cases) {
    Body left = shakenBody(ball, 0, 0), right = left;
    for (Point& x : right.position) x = Vector{1.9, 0, 0} + Vector{-x.x, -x.y, x.z};  // half a turn
    // The vertex of the left ball that is nearest to the right one, whose ring is turned inside out.
    const auto moving = std::max_element(left.position.begin(), left.position.end(),
                                         [](const Point& a, const Point& b) { return a.x < b.x; }) -
                        left.position.begin();
    const Point start = left.position[moving];
    std::vector<int> around = Rings(ball).neighbours[moving];
    Crowd crowd(limp(), law, ball, {left, right});
    std::vector<Vector> before;
    Worst jump, largest;
    for (int i = 0; i <= 4000; ++i) {
      // The ring shrinks to a point and comes out on the other side: G passes through 0 at i = 2000.
      for (int k : around) crowd.lab.setPosition(0, k, start + (1 - i / 2000.0) * (left.position[k] - start));
      crowd.evaluateForces();
      std::vector<Vector> now;
      for (int slot : {0, 1})
        for (int v = 0; v < crowd.lab.bodies.vertexCount(); ++v) now.push_back(crowd.lab.force(slot, v));
      for (std::size_t k = 0; k < now.size(); ++k) {
        if (!before.empty()) jump.see(norm(now[k] - before[k]));
        largest.see(norm(now[k]));
      }
      before = now;
    }
    CAPTURE(name);
    CHECK(largest > 0.5);
    CHECK(largest < 100);
    CHECK(jump < 0.02 * largest);
  }
}

TEST_CASE("Vertices at one place, or with parallel normals, do not make a force infinite") {
  const Body one = shakenBody(ball, 0, 0);
  Body needle = one;  // all vertices but one lie in two points
  for (std::size_t v = 1; v < needle.position.size(); ++v)
    needle.position[v] = v < 20 ? Point{0.9, 0, 0} : needle.position[41];
  needle.position[0] = {0.3, 0.5, -0.1};
  for (const auto& [name, law] : cases) {
    CAPTURE(name);
    CHECK(largestForce(evaluated({limp(), law, ball, {one, one, one}}).lab) < 1e3);
    Crowd folded(limp(), law, ball, {one, one, one});
    for (int slot : {1, 2})
      for (int v = 0; v < folded.lab.bodies.vertexCount(); ++v) folded.lab.setPosition(slot, v, needle.position[v]);
    folded.evaluateContacts();  // contact alone: gas without volume has no pressure
    CHECK(largestForce(folded.lab) < 1e3);
  }
}

TEST_CASE("The steepest pair of each cell is that of the equation, on every instruction set") {
  for (const Isa isa : availableIsas())
    for (const Mesh& mesh : {makeIcosphere(1), box})
      for (const int count : {2, 9}) {
        const Crowd crowd = evaluated({limp(), {}, mesh, heapOf(mesh, count, 1.2, 0.05, 3), isa});
        const PairOracle oracle(crowd.lab.bodies, {});
        std::vector<double> expected(static_cast<std::size_t>(count)), steepness;
        for (const SeenVertex& i : oracle.all)
          for (const SeenVertex& j : oracle.all)
            if (i.slot != j.slot) expected[i.slot] = std::max(expected[i.slot], 16 * PairOracle::steepnessOf(i, j));
        CAPTURE(name(isa), count);
        measureSteepness(crowd.contacts, crowd.lab.bodies, 2, steepness);
        for (int slot = 0; slot < count; ++slot) {
          CHECK(expected[slot] > 0.1);
          CHECK(steepness[slot] == Approx(expected[slot]).epsilon(1e-12));
        }
      }
}

TEST_CASE("No pair is stiffer with its distance than hardening and steepness say, and some are nearly as stiff") {
  ContactParameters law;
  law.stiffness = 1;
  const Crowd crowd(limp(), law, ball, {ballAt(ball, {}), ballAt(ball, {5, 0, 0})});
  const PairOracle oracle(crowd.lab.bodies, law);
  SeenVertex i = oracle.all[0], j = oracle.all[ball.vertices.size()];
  j.x = {}, i.inverseRadiusSquared = j.inverseRadiusSquared = 1;
  Worst share;
  for (std::uint32_t key = 0; key < 4000; ++key) {
    // Each vertex lies behind the other, at a distance below 1. Leaning normals vary the overlap.
    const Vector away = noiseVector(1, key) / norm(noiseVector(1, key)), aside = noiseVector(2, key);
    i.normal = (1 / norm(away + 0.7 * aside)) * (away + 0.7 * aside);
    j.normal = (-1.0 / norm(away - 0.7 * noiseVector(3, key))) * (away - 0.7 * noiseVector(3, key));
    const double distance = 0.5 + 0.499 * std::abs(noise(4, key)), step = 1e-4 * (1 - distance);
    const auto energyAt = [&](double way) {
      i.x = way * away;
      return oracle.repulsionOf(i, j);
    };
    const double stiffness =
        (energyAt(distance + step) - 2 * energyAt(distance) + energyAt(distance - step)) / (step * step);
    i.x = distance * away;
    const double q = distance * distance, depth = std::max(0.0, -dot(i.x, j.normal - i.normal) / 2);
    const double bound = hardeningAt(depth * depth * (1 - q * q)) + 16 * PairOracle::steepnessOf(i, j);
    CHECK(stiffness <= bound * (1 + 1e-6));
    if (bound > 4) share.see(stiffness / bound);
  }
  CHECK(share > 0.9);
}
