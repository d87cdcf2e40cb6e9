#pragma once
// The pair law by the equations at the heads of pair_law_kernel.h, surface_kernel.h and adhesion.h, for all pairs of
// vertices and from the mesh alone. Differences turn forces on surfaces into forces on vertices.
#include <numbers>

#include "crowd.h"

namespace morula {

struct PairOracle {
  const Bodies& b;
  ContactParameters law;
  double strongestGrip = 0, damping = 0;
  Rings rings;
  std::vector<SeenVertex> all;  // [slot · vertices + vertex]
  // Sums over the pairs of a vertex: e [energy] and ρ [1] of adhesion.h.
  struct Crowding {
    double held = 0, density = 0;
    double energy() const { return -held * saturation(density); }
  };
  std::vector<Crowding> crowding;  // [as all]

  PairOracle(const Bodies& bodies, const ContactParameters& parameters, double timeStep = 1)
      : b(bodies), law(parameters), rings(bodies.mesh.mesh), all(seen(bodies, parameters)) {
    const double lightest = *std::min_element(b.vertexMass.begin(), b.vertexMass.begin() + b.count);
    strongestGrip = std::min(0.3 * std::sqrt(law.stiffness * lightest), 0.16 * lightest / timeStep);
    damping = law.damping.of(law.stiffness, lightest);
    crowding.resize(all.size());
    for (std::size_t i = 0; law.adhesion && i < all.size(); ++i)
      for (const SeenVertex& j : all)
        if (j.slot != all[i].slot) add(crowding[i], crowdingBy(all[i], j), 1);
  }

  /// Returns the mean area of a cell's vertices at rest. [length²]
  double restArea(int slot) const {
    const Mesh& mesh = b.mesh.mesh;
    return measureArea(mesh.vertices, mesh.faces) / b.vertexCount() * b.restScale[slot] * b.restScale[slot];
  }
  /// Returns T, from the work W. [energy]
  double holds(const SeenVertex& i, const SeenVertex& j) const {
    if (!law.adhesion) return 0;
    const double ai = restArea(i.slot), aj = restArea(j.slot), g = 6 * ai * i.inverseRadiusSquared;
    const double m = 1 + (1 + 4.0 / 27) * g * g / (g * g + 4), s = m * m * (3 - m) / 4;  // flat, face to face
    return 24 / std::numbers::pi * law.adhesion->strength * ai * aj * kappa(i, j) / (1.5 * 1.5) / s;
  }
  /// Returns s = φ/ρ with φ = ρ up to 1, then 1 + 0.1 (1 − (1 − x)³), x = (ρ − 1)/0.3, and 1.1 from x = 1 on.
  static double saturation(double density) {
    if (density <= 1) return 1;
    return density < 1.3 ? (1.1 - 0.1 * std::pow(1 - (density - 1) / 0.3, 3)) / density : 1.1 / density;
  }
  static double slopeOfSaturation(double density) {
    if (density <= 1) return 0;
    const double slope = density < 1.3 ? std::pow(1 - (density - 1) / 0.3, 2) : 0;
    return (slope - saturation(density)) / density;
  }
  /// Returns what j adds to the sums of i.
  Crowding crowdingBy(const SeenVertex& i, const SeenVertex& j) const {
    const double w = std::max(0.0, 1 - kappa(i, j) * dot(i.x - j.x, i.x - j.x) / (1.5 * 1.5));
    const double m = 1 - dot(i.normal, j.normal), t = holds(i, j) * (m * m * (3 - m) / 4) * w * w * w;
    return {t / 12, t / law.adhesion->strength / (6 * restArea(i.slot))};
  }
  static void add(Crowding& sum, const Crowding& more, double times) {
    sum.held += times * more.held, sum.density += times * more.density;
  }
  std::size_t placeOf(const SeenVertex& i) const { return std::size_t(i.slot) * b.vertexCount() + i.v; }
  /// Returns T_eff. [energy]
  double effective(const SeenVertex& i, const SeenVertex& j) const {
    if (!law.adhesion) return 0;
    const Crowding &a = crowding[placeOf(i)], &c = crowding[placeOf(j)];
    const auto q = [&](const Crowding& of, int slot) {
      return of.held * slopeOfSaturation(of.density) / restArea(slot);
    };
    const double strength = holds(i, j), perWork = strength / law.adhesion->strength;
    return strength * (saturation(a.density) + saturation(c.density)) / 2 + perWork * (q(a, i.slot) + q(c, j.slot));
  }
  static double kappa(const SeenVertex& i, const SeenVertex& j) {
    return (i.inverseRadiusSquared + j.inverseRadiusSquared) / 2;
  }

  /// The energy that two vertices hold by overlap and by adhesion. [energy]
  struct Energy {
    double repulsion = 0, adhesion = 0;
  };
  double repulsionOf(const SeenVertex& i, const SeenVertex& j) const {
    const Vector a = i.x - j.x, h = (j.normal - i.normal) / 2.0;
    const double k = kappa(i, j), q = k * dot(a, a), u = std::max(0.0, 1 - q * q);
    const double depth = std::max(0.0, -dot(a, h)), bulk = k * depth * depth * u;
    const double m = 1 - dot(i.normal, j.normal), t = std::min(2 * m, 1.0), s = t * t * (3 - 2 * t);
    return s * 0.5 * law.stiffness * depth * depth * u * u * (1 + 6 * bulk + 200 * bulk * bulk);
  }

  Energy energy() const {
    Energy sum;
    for (const SeenVertex& i : all)
      for (const SeenVertex& j : all) {
        if (j.slot <= i.slot || kappa(i, j) * dot(i.x - j.x, i.x - j.x) >= 1.5 * 1.5) continue;
        sum.repulsion += repulsionOf(i, j);
      }
    for (const Crowding& of : crowding) sum.adhesion += of.energy();
    return sum;
  }

  /// Returns the largest B of the pairs of `count` slots from `firstSlot` on. [1]
  double deepest(int firstSlot, int count) const {
    double most = 0;
    for (const SeenVertex& i : all)
      for (const SeenVertex& j : all) {
        if (i.slot < firstSlot || i.slot >= firstSlot + count || j.slot == i.slot) continue;
        const Vector a = i.x - j.x;
        const double k = kappa(i, j), q = k * dot(a, a);
        const double depth = std::max(0.0, -dot(a, j.normal - i.normal) / 2);
        if (q < 1) most = std::max(most, k * depth * depth * (1 - q * q));
      }
    return most;
  }

  /// Returns S of two vertices, 0 if they do not overlap or are out of reach. [1]
  static double steepnessOf(const SeenVertex& i, const SeenVertex& j) {
    const Vector a = i.x - j.x;
    const double k = kappa(i, j), q = k * dot(a, a), depth = std::max(0.0, -dot(a, j.normal - i.normal) / 2);
    if (q >= 1) return 0;
    const double bulk = k * depth * depth * (1 - q * q), t = std::min(2 * (1 - dot(i.normal, j.normal)), 1.0);
    return t * t * (3 - 2 * t) * k * depth * depth * q * q * q * (1 + 18 * bulk + 1200 * bulk * bulk);
  }

  /// Force f and turn q of j on i, with damping and viscosity.
  struct Push {
    Vector force, turn;
  };
  Push pushOf(const SeenVertex& i, const SeenVertex& j) const {
    const Vector a = i.x - j.x, h = (j.normal - i.normal) / 2.0, v = i.velocity - j.velocity;
    const double k = kappa(i, j), near = k * dot(a, a), u = std::max(0.0, 1 - near * near),
                 fade = 1 - near / (1.5 * 1.5);
    if (near >= 1.5 * 1.5) return {};
    const double overlap = near < 1 ? -dot(a, h) : 0, depth = std::max(0.0, overlap), bulk = k * depth * depth * u;
    const double m = 1 - dot(i.normal, j.normal), t = std::min(2 * m, 1.0), s = t * t * (3 - 2 * t);
    const double hard = 1 + 12 * bulk + 600 * bulk * bulk;
    const double byDepth = std::max(0.0, s * u * u * (law.stiffness * overlap * hard - damping * dot(v, h)));
    const double held = effective(i, j), barrier = law.stiffness * depth * depth;
    const double byNearness = -near * s * barrier * u * (2 + 18 * bulk + 800 * bulk * bulk) +
                              m * m * (3 - m) / 4 * held / 2 / (1.5 * 1.5) * fade * fade;
    const double byNormals = 12 * t * (1 - t) * u * u * barrier / 2 * (1 + 6 * bulk + 200 * bulk * bulk) -
                             0.75 * m * (2 - m) * held / 6 * fade * fade * fade;
    Push p{byDepth * h - 2 * k * byNearness * a, byNormals * j.normal - byDepth / 2 * a};
    if (law.viscosity > 0 && dot(a, a) > 0) {
      const double slip = std::sqrt(std::max(0.0, dot(v, v) - dot(v, h) * dot(v, h)));
      const double grip = std::min(2 * law.viscosity * byDepth / std::max(slip, law.slipSpeed), strongestGrip);
      p.force -= grip * dot(v, a) / dot(a, a) * a;
    }
    return p;
  }

  /// Returns the forces on all vertices, in the order of `all`.
  std::vector<Vector> forces() const {
    std::vector<Push> onSurface(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      for (const SeenVertex& j : all) {
        if (all[i].slot == j.slot) continue;
        const Push p = pushOf(all[i], j);
        onSurface[i].force += p.force, onSurface[i].turn += p.turn;
      }
    std::vector<Vector> forces;
    const int vertices = b.vertexCount();
    for (int slot = 0; slot < b.count; ++slot) {
      std::vector<Point> x = takeBody(b, slot).position;
      const std::size_t first = std::size_t(slot) * vertices;
      for (int v = 0; v < vertices; ++v)
        forces.push_back(byDifferences(
            x, v, 2e-5,
            [&](int w, const SeenSurface& s) {
              const Push& p = onSurface[first + w];
              return dot(p.force, s.y) + dot(p.turn, s.n);
            },
            all[first]));
    }
    return forces;
  }

  /// Returns −∂E/∂x of one vertex, by differences of the pairs of the vertex and its ring.
  Vector energyFalls(int slot, int v, double step) const {
    std::vector<Point> x = takeBody(b, slot).position;
    const SeenVertex& first = all[std::size_t(slot) * b.vertexCount()];
    return byDifferences(
        x, v, step,
        [&](int w, const SeenSurface& s) {
          const SeenVertex i{slot, w, s.y, {}, s.n, first.inverseRadiusSquared};
          // The energies of i and of all vertices that it crowds, while no other vertex moves.
          double sum = 0;
          Crowding own;
          for (const SeenVertex& j : all) {
            if (j.slot == slot) continue;
            sum -= repulsionOf(i, j);
            if (!law.adhesion) continue;
            add(own, crowdingBy(i, j), 1);
            Crowding other = crowding[placeOf(j)];
            const double before = other.energy();
            add(other, crowdingBy(j, i), 1);
            add(other, crowdingBy(j, all[placeOf(i)]), -1);
            sum -= other.energy() - before;
          }
          return sum - own.energy();
        },
        first);
  }

 private:
  /// Returns ∂/∂x of vertex v of the sum of `worth` over all vertices whose surface depends on v.
  template <class Worth>
  Vector byDifferences(std::vector<Point>& x, int v, double step, Worth&& worth, const SeenVertex& first) const {
    const double sag = b.sag[first.slot];
    const auto sum = [&] {
      double s = worth(v, rings.see(x, v, first.inverseRadiusSquared, sag));
      for (int w : rings.neighbours[v]) s += worth(w, rings.see(x, w, first.inverseRadiusSquared, sag));
      return s;
    };
    const Point here = x[v];
    Vector slope;
    for (double Vector::*axis : {&Vector::x, &Vector::y, &Vector::z}) {
      const auto at = [&](double way) {
        x[v] = here;
        x[v].*axis += way;
        return sum();
      };
      slope.*axis = (8 * (at(step) - at(-step)) - (at(2 * step) - at(-2 * step))) / (12 * step);
      x[v] = here;
    }
    return slope;
  }
};

}  // namespace morula
