#pragma once
// The pair law by the equations at the heads of pair_law_kernel.h, surface_kernel.h and adhesion.h, for all pairs of
// vertices and from the mesh alone. Differences turn forces on surfaces into forces on vertices.
#include <numbers>

#include "crowd.h"

namespace morula {

struct PairOracle {
  const Bodies& b;
  ContactParameters law;
  double strongestGrip = 0;
  Rings rings;
  std::vector<SeenVertex> all;  // [slot · vertices + vertex]

  PairOracle(const Bodies& bodies, const ContactParameters& parameters, double timeStep = 1)
      : b(bodies), law(parameters), rings(bodies.mesh.mesh), all(seen(bodies, parameters)) {
    const double lightest = *std::min_element(b.vertexMass.begin(), b.vertexMass.begin() + b.count);
    strongestGrip = std::min(0.3 * std::sqrt(law.stiffness * lightest), 0.16 * lightest / timeStep);
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
  static double kappa(const SeenVertex& i, const SeenVertex& j) {
    return (i.inverseRadiusSquared + j.inverseRadiusSquared) / 2;
  }

  /// The energy that two vertices hold by overlap and by adhesion. [energy]
  struct Energy {
    double repulsion = 0, adhesion = 0;
    double total() const { return repulsion + adhesion; }
  };
  Energy energyOf(const SeenVertex& i, const SeenVertex& j, double held) const {
    const Vector a = i.x - j.x, h = (j.normal - i.normal) / 2.0;
    const double k = kappa(i, j), q = k * dot(a, a), u = std::max(0.0, 1 - q * q),
                 w = std::max(0.0, 1 - q / (1.5 * 1.5));
    const double depth = std::max(0.0, -dot(a, h)), bulk = k * depth * depth * u;
    const double m = 1 - dot(i.normal, j.normal), t = std::min(2 * m, 1.0), s = t * t * (3 - 2 * t);
    return {s * 0.5 * law.stiffness * depth * depth * u * u * (1 + 6 * bulk + 200 * bulk * bulk),
            -m * m * (3 - m) / 4 * held / 6 * w * w * w};
  }

  Energy energy() const {
    Energy sum;
    for (const SeenVertex& i : all)
      for (const SeenVertex& j : all) {
        if (j.slot <= i.slot || kappa(i, j) * dot(i.x - j.x, i.x - j.x) >= 1.5 * 1.5) continue;
        const Energy e = energyOf(i, j, holds(i, j));
        sum.repulsion += e.repulsion, sum.adhesion += e.adhesion;
      }
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

  /// Force f and turn q of j on i, with damping and friction.
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
    const double byDepth = std::max(0.0, s * u * u * (law.stiffness * overlap * hard - law.damping * dot(v, h)));
    const double held = holds(i, j), barrier = law.stiffness * depth * depth;
    const double byNearness = -near * s * barrier * u * (2 + 18 * bulk + 800 * bulk * bulk) +
                              m * m * (3 - m) / 4 * held / 2 / (1.5 * 1.5) * fade * fade;
    const double byNormals = 12 * t * (1 - t) * u * u * barrier / 2 * (1 + 6 * bulk + 200 * bulk * bulk) -
                             0.75 * m * (2 - m) * held / 6 * fade * fade * fade;
    Push p{byDepth * h - 2 * k * byNearness * a, byNormals * j.normal - byDepth / 2 * a};
    if (law.friction > 0 && dot(a, a) > 0) {
      const double slip = std::sqrt(std::max(0.0, dot(v, v) - dot(v, h) * dot(v, h)));
      const double grip = std::min(2 * law.friction * byDepth / std::max(slip, law.slipSpeed), strongestGrip);
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
    std::vector<double> held(b.count, 0.0);
    for (int other = 0; other < b.count; ++other) held[other] = holds(first, all[std::size_t(other) * b.vertexCount()]);
    return byDifferences(
        x, v, step,
        [&](int w, const SeenSurface& s) {
          const SeenVertex i{slot, w, s.y, {}, s.n, first.inverseRadiusSquared};
          double sum = 0;
          for (const SeenVertex& j : all)
            if (j.slot != slot && kappa(i, j) * dot(i.x - j.x, i.x - j.x) < 1.5 * 1.5)
              sum -= energyOf(i, j, held[j.slot]).total();
          return sum;
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
