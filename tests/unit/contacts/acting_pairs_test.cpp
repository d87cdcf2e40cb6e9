// Pairs left out of slices contribute nothing, as long as the choice of pairs holds.
#include "contacts/acting_pairs.h"

#include <algorithm>

#include "catch.h"
#include "crowd.h"

using namespace morula;

namespace {

const double longest = std::sqrt(normalScaleSquared);  // ν

std::vector<SnapshotRow> rowsOf(const Crowd& crowd) {
  std::vector<SnapshotRow> rows;
  for (const RowMemory& row : crowd.contacts.rows) rows.push_back(readRow(row, crowd.lab.bodies.parameters.precision));
  return rows;
}

/// Returns the neighbours of each vertex that stand in slices.
std::vector<std::vector<VertexNumber>> chosenOf(const Contacts& c) {
  const auto far = static_cast<VertexNumber>(c.rows.size() - 1);
  std::vector<std::vector<VertexNumber>> chosen(c.rows.size());
  for (const BlockLists& lists : c.list.perBlock)
    for (const NeighbourSlice& slice : lists.slices)
      for (int l = 0; l < blockLanes; ++l)
        for (int k = 0; k < slice.length; ++k) {
          const VertexNumber j = lists.indices[(slice.start + k) * blockLanes + l];
          if (j != far) chosen[slice.vertex[l]].push_back(j);
        }
  return chosen;
}

/// Returns how many numbers the slices hold, including the far row's.
std::size_t entriesOf(const Contacts& c) {
  std::size_t entries = 0;
  for (const AlignedVector<std::int32_t>& indices : indicesOf(c.list)) entries += indices.size();
  return entries;
}

/// Chooses pairs with a margin of `share` smallest influence radii R and the given horizon. Gaps that change by ċ =
/// (M/1.4)²/R per evaluation ask for 1.4 √(R ċ) and for √(R/ċ) evaluations.
void choose(Crowd& crowd, double share, double horizon) {
  ActingPairs& acting = crowd.contacts.acting;
  const double radius = crowd.contacts.list.skin / crowd.contacts.skinShare, perRadius = share / 1.4;
  acting.age = 1;
  std::ranges::fill(acting.change, static_cast<float>(perRadius * perRadius * radius));
  for (ActingPairs::OfBlock& block : acting.blocks) block.time = perRadius * horizon;
  choosePairs(crowd.contacts, crowd.lab.bodies, 1);
}

/// Returns true if the last evaluation chose pairs of single vertices anew.
bool hasRenewed(const ActingPairs& acting) {
  return acting.age > 1 && std::ranges::any_of(acting.blocks, [](const auto& block) { return block.endedCount > 0; });
}

/// The worst motion of a pair within its margin M: returns the smallest gap left before the pair acts, in units of M.
struct WorstMotion {
  const Contacts& c;
  double ofStraying, ofTurning, ofSpeeding;  // how M is shared between 2νδ, R η and 2ντw

  double operator()(const SnapshotRow& i, const SnapshotRow& j, double margin) const {
    const double most = 0.999 * margin, strayed = ofStraying * most / (2 * longest),
                 turned = ofTurning * most / c.acting.largestRadius,
                 spedUp =
                     ofSpeeding * most / (2 * longest * std::max(c.damping / c.parameters.stiffness, 1e-6));
    const double delay = c.damping / c.parameters.stiffness;
    const Vector a{i.x - j.x, i.y - j.y, i.z - j.z};
    const Vector h = 0.5 * Vector{j.nx - i.nx, j.ny - i.ny, j.nz - i.nz};
    const Vector u = Vector{i.vx, i.vy, i.vz} - Vector{j.vx, j.vy, j.vz};
    const double curvature = 0.5 * (double(i.inverseRadiusSquared) + double(j.inverseRadiusSquared));
    const double horizon = c.acting.horizon, nearest = std::clamp(-dot(a, u) / (dot(u, u) + 1e-300), 0.0, horizon);
    double worst = INFINITY;
    // At each time vertices come nearer, against the normals or across, and turn against the distance or the speed.
    for (double time : {0.0, nearest, 0.5 * horizon, horizon}) {
      const Vector then = a + time * u;
      for (const Vector& way : {then, h, cross(cross(then, h), then)})
        for (const Vector& b : {then, u, then + delay * u}) {
          const Vector nearer = then - 2 * strayed / (norm(way) + 1e-300) * way;
          if (!(curvature * dot(nearer, nearer) < 1)) continue;
          const Vector turnedBy = h - turned / (norm(b) + 1e-300) * b;
          if (norm(turnedBy) > longest) continue;
          const Vector faster = u - 2 * spedUp / (norm(turnedBy) + 1e-300) * turnedBy;
          const double gap = dot(nearer, turnedBy);
          worst = std::min({worst, gap, gap + delay * dot(faster, turnedBy)});
        }
    }
    return worst / margin;
  }
};

struct Motion {
  ContactParameters law;
  double speed;  // [length/time]
};

}  // namespace

TEST_CASE("No pair that is left out can act, whatever moves on, strays, turns and speeds up within the margin") {
  for (Isa isa : availableIsas())
    for (Precision precision : {Precision::binary64, Precision::binary32})
      for (const auto& [law, speed] : {Motion{{}, 0}, Motion{{}, 30}, Motion{{ContactLaw::pair, 40, 20}, 1},
                                       Motion{{ContactLaw::pair, 40, 0}, 1}}) {
        PhysicsParameters p = limp();
        p.precision = precision;
        int left = 0, act = 0;
        double closest = INFINITY;
        for (std::uint32_t key = 0; key < 4; ++key) {
          Crowd crowd(p, law, ball, heap(ball, 9, 1.4, 0, key), isa);
          Contacts& c = crowd.contacts;
          std::vector<SnapshotRow> rows = rowsOf(crowd);
          for (std::size_t g = 0; g + 1 < rows.size(); ++g) {
            const auto k = static_cast<std::uint32_t>(100 * g + key);
            SnapshotRow& row = rows[g];
            // Normals of neighbouring cells point up and down in turn, so that many face each other.
            const Vector way = noiseVector(0, k) + Vector{0, 0, g % 2 == 0 ? 2.0 : -2.0},
                         n = (0.99 * longest / norm(way)) * way, v = speed * noiseVector(1, k);
            row.nx = n.x, row.ny = n.y, row.nz = n.z;
            row.vx = float(v.x), row.vy = float(v.y), row.vz = float(v.z);
            c.rows[g] = asMemory(row, precision);
          }
          rows = rowsOf(crowd);
          const double radius = crowd.contacts.list.skin / crowd.contacts.skinShare;
          for (const auto& [margin, ahead] :
               {std::pair{0.02, 0.0}, {0.04, 0.0}, {0.06, 0.0}, {0.02, 0.3}, {0.06, 1.0}}) {
            choose(crowd, margin, speed > 0 ? ahead * radius / speed : 0);
            const auto chosen = chosenOf(c);
            const WorstMotion motions[]{{c, 0, 0, 0}, {c, 1, 0, 0}, {c, 0, 1, 0}, {c, 0, 0, 1}, {c, 0.5, 0.5, 0}};
            CHECK(std::abs(c.acting.margin / radius / margin - 1) < 1e-6);
            for (VertexNumber g = 0; g + 1 < static_cast<VertexNumber>(rows.size()); ++g) {
              if (!(rows[g].inverseRadiusSquared > 0)) continue;
              for (VertexNumber j : neighboursOf(c.list, g))
                if (!std::ranges::binary_search(chosen[g], j))
                  for (const WorstMotion& worst : motions) {
                    const double gap = worst(rows[g], rows[j], c.acting.margin);
                    act += gap < 0, ++left;
                    closest = std::min(closest, gap);
                  }
            }
          }
        }
        CAPTURE(name(isa), law.damping, speed, left);
        CHECK(act == 0);
        CHECK(left > 10000);
        // The margin is not much wider than needed. The excess comes from the upper bound on |u₀| and from t² u₀².
        CHECK(closest < 0.45);
      }
}

TEST_CASE("Forces of the chosen pairs are those of all, bit for bit: cells that fly, spin and are shaken") {
  const Mesh ball = makeIcosphere(2);
  for (const ContactParameters& law : {ContactParameters{}, ContactParameters{ContactLaw::pair, 40, 0.2, 0.3}}) {
    int different = 0, choices = 0, renewals = 0, evaluations = 0;
    double entries = 0, all = 0;
    for (std::uint32_t key = 0; key < 6; ++key) {
      PhysicsParameters p = limp();
      if (key % 2 == 1) p.precision = Precision::binary32;
      Crowd crowd(p, law, ball, heap(ball, 9, 1.8, 0, key), bestIsa());
      Bodies& b = crowd.lab.bodies;
      for (int i = 0; i < 120; ++i) {
        for (int slot = 0; slot < b.count; ++slot) {
          const auto k = static_cast<std::uint32_t>(10 * key + slot);
          const double size = key < 2 ? 1e-3 : 2e-4;
          const Vector along = noiseVector(2, k), spin = 3 * noiseVector(3, k), middle = b.vertex(slot, 0);
          for (int v = 0; v < b.vertexCount(); ++v) {
            const Vector way = along + cross(spin, b.vertex(slot, v) - middle) + 0.3 * noiseVector(4 + v, k + 1000 * i);
            crowd.lab.setPosition(slot, v, b.vertex(slot, v) + size * way);
            crowd.lab.setVelocity(slot, v, (i % 20 == 7 ? 300 : 30) * size * way);
          }
        }
        crowd.evaluateContacts(key % 3 == 0 ? 0 : 1.0 / 30);  // 1/30 fits the velocities, 0 ignores them
        const Reals chosen = b.acceleration;
        Contacts whole = crowd.contacts;
        buildNeighbourList(whole.list, b, whole.radius, 1);
        b.acceleration.assign(b.acceleration.size(), 0);
        for (int block = 0; block < b.blockCount(); ++block) addContactForces(whole, b, block, crowd.lawTimeStep);
        if (i == 0) {
          const auto slices = chosenOf(whole);
          for (std::size_t g = 0; g + 1 < slices.size(); ++g)
            different += slices[g] != neighboursOf(whole.list, static_cast<VertexNumber>(g));
        }
        different += chosen != b.acceleration || whole.deepest != crowd.contacts.deepest;
        choices += crowd.contacts.acting.age == 1, renewals += hasRenewed(crowd.contacts.acting), ++evaluations;
        entries += double(entriesOf(crowd.contacts)), all += double(entriesOf(whole));
      }
    }
    CHECK(different == 0);
    CAPTURE(choices, renewals, evaluations, entries / all);
    CHECK(choices < 0.9 * evaluations);
    CHECK(renewals > 0.1 * evaluations);
    CHECK(entries < 0.8 * all);
  }
}

TEST_CASE("Where little moves the choice is narrow and lasts") {
  Crowd crowd(limp(), {}, ball, heap(ball, 9, 1.8, 0));
  const ActingPairs& acting = crowd.contacts.acting;
  Bodies& b = crowd.lab.bodies;
  const double radius = crowd.contacts.list.skin / crowd.contacts.skinShare;
  std::vector<double> shares;
  for (double way : {1e-5, 1e-4}) {
    std::int64_t oldest = 0;
    for (int i = 0; i < 60; ++i) {
      for (int slot : b.slots)
        for (int v = 0; v < b.vertexCount(); ++v)
          b.write(b.position, slot, v, b.vertex(slot, v) + Vector{0, 0, i % 2 == 0 ? way : -way});
      crowd.evaluateContacts();
      oldest = std::max(oldest, acting.age);
    }
    CHECK(oldest > 20);
    shares.push_back(acting.margin / radius);
  }
  CHECK(shares[0] < shares[1]);
  CHECK(shares[1] < 0.05);
}

TEST_CASE("Where now one vertex jumps and now another, their pairs alone are chosen anew") {
  Crowd crowd(limp(), {}, ball, heap(ball, 9, 1.8, 0));
  Bodies& b = crowd.lab.bodies;
  const double jump = 0.1 * crowd.contacts.list.skin / crowd.contacts.skinShare;
  const ActingPairs& acting = crowd.contacts.acting;
  int choices = 0, renewals = 0, different = 0, late = 0;
  for (int i = 0; i < 200; ++i) {
    const int slot = b.slots[i % b.count], v = i / b.count % b.vertexCount();
    b.write(b.position, slot, v, b.vertex(slot, v) + Vector{0, 0, i / b.count % 2 == 0 ? jump : -jump});
    crowd.evaluateContacts(1e-3);
    choices += acting.age == 1, renewals += hasRenewed(acting);
    late += acting.blocks[0].time > acting.horizon;
    const Reals chosen = b.acceleration;
    Contacts whole = crowd.contacts;
    buildNeighbourList(whole.list, b, whole.radius, 1);
    b.acceleration.assign(b.acceleration.size(), 0);
    for (int block = 0; block < b.blockCount(); ++block) addContactForces(whole, b, block, crowd.lawTimeStep);
    different += chosen != b.acceleration;
  }
  CAPTURE(choices, renewals);
  CHECK(different == 0);
  CHECK(late == 0);  // new choices for single vertices do not replace the choice for all
  CHECK(choices < 20);
  CHECK(renewals > 150);
}

TEST_CASE("Where choices end soon, because all cells jump, all pairs are taken for a while") {
  Crowd crowd(limp(), {}, ball, heap(ball, 9, 1.8, 0));
  Bodies& b = crowd.lab.bodies;
  const double jump = 0.1 * crowd.contacts.list.skin / crowd.contacts.skinShare;
  int choices = 0;
  for (int i = 0; i < 200; ++i) {
    for (int slot : b.slots)
      for (int v = 0; v < b.vertexCount(); ++v)
        b.write(b.position, slot, v, b.vertex(slot, v) + Vector{0, 0, i % 2 == 0 ? jump : -jump});
    crowd.evaluateContacts(1e-3);
    choices += crowd.contacts.acting.age == 1;
  }
  CHECK(choices < 40);  // of 200 possible
  CHECK(choices > 5);   // choices are tried again later
}

TEST_CASE("Choices that searches end soon are no reason to take all pairs") {
  Crowd crowd(limp(), {}, ball, heap(ball, 9, 1.8, 0));
  Bodies& b = crowd.lab.bodies;
  for (int i = 0; i < 20; ++i) {
    b.write(b.position, 0, 0, b.vertex(0, 0) + Vector{0, 0, i % 2 == 0 ? 1e-4 : -1e-4});
    crowd.contacts.listIsValid = false;
    crowd.evaluateContacts(1e-3);
    CHECK(std::isfinite(crowd.contacts.acting.margin));
  }
}

TEST_CASE("Snapshots count by how much they may change gaps of each vertex, and tell which reach the margin") {
  for (Isa isa : availableIsas())
    for (Precision precision : {Precision::binary64, Precision::binary32}) {
      PhysicsParameters p = limp();
      p.precision = precision;
      Crowd crowd(p, {ContactLaw::pair, 40, 2}, ball, heap(ball, 9, 1.8, 0), isa);
      Bodies& b = crowd.lab.bodies;
      ActingPairs& acting = crowd.contacts.acting;
      constexpr double sinceLast = 0.01;
      std::vector<double> change(acting.change.size(), 0), speeds = change;  // [vertex]
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::vector<SnapshotRow> before = rowsOf(crowd);
        for (int slot = 0; slot < b.count; ++slot)
          for (int v = 0; v < b.vertexCount(); ++v) {
            const std::uint32_t k = 100 * slot + v + 1000 * i;
            crowd.lab.setPosition(slot, v, b.vertex(slot, v) + 0.01 * noiseVector(5, k));
            crowd.lab.setVelocity(slot, v, crowd.lab.velocity(slot, v) + noiseVector(6, k));
          }
        acting.margin = 0.4;
        crowd.advanceAndSnapshot(0, sinceLast);
        const std::vector<SnapshotRow> after = rowsOf(crowd);
        for (int slot : b.slots)
          for (int v = 0; v < b.vertexCount(); ++v) {
            const VertexNumber g = numberOf(b, slot, v);
            const SnapshotRow &r = before[g], &q = after[g];
            const double spedUp = norm(Vector{q.vx - r.vx, q.vy - r.vy, q.vz - r.vz});
            change[g] +=
                2 * longest * norm(Vector{q.x - r.x, q.y - r.y, q.z - r.z} - sinceLast * Vector{r.vx, r.vy, r.vz}) +
                2 * longest * (2.0 / 40 * spedUp + sinceLast * speeds[g]) +
                acting.largestRadius * norm(Vector{q.nx - r.nx, q.ny - r.ny, q.nz - r.nz});
            speeds[g] += spedUp;
          }
      }
      // The values are upper bounds, at most √(1 + 2 (√2 − 1)²) = 1.159 times too large, up to rounding of floats.
      double least = INFINITY, most = 0;
      for (int slot : b.slots)
        for (int v = 0; v < b.vertexCount(); ++v) {
          const VertexNumber g = numberOf(b, slot, v);
          for (double ratio : {acting.change[g] / change[g], acting.speeds[g] / speeds[g]})
            least = std::min(least, ratio), most = std::max(most, ratio);
        }
      CHECK(least > 1 - 1e-4);
      CHECK(most < 1.16);
      CHECK(most > 1.1);
      std::vector<VertexNumber> ended, expected;
      for (int block = 0; block < b.blockCount(); ++block)
        for (std::int32_t i = 0; i < acting.blocks[block].endedCount; ++i)
          ended.push_back(b.blocks[block].firstLine * blockLanes + acting.blocks[block].ended[i]);
      for (int slot : b.slots)
        for (int v = 0; v < b.vertexCount(); ++v)
          if (acting.change[numberOf(b, slot, v)] >= 0.4) expected.push_back(numberOf(b, slot, v));
      std::ranges::sort(expected);
      CHECK(ended == expected);
      CHECK(ended.size() > 20);
      CHECK(ended.size() < 0.9 * b.livingVertices);
      for (const ActingPairs::OfBlock& block : acting.blocks) CHECK(std::abs(block.time - 3 * sinceLast) < 1e-15);
    }
}
