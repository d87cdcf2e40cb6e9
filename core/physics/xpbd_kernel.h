#pragma once
// Extended position-based dynamics [Macklin, Müller, Chentanez 2016], in N sub-steps h = Δt/N of one sweep
// each [Macklin et al. 2019]: every spring, and then the fluid, by itself in backward Euler's closed form,
// one after the other. First order, and stable with any time step.
//
//   1. v ← (v + h a)/(1 + h·drag),  x ← x + h v   a: of all outer forces (contacts, connections), once per
//                                                 time step and held over its sub-steps: membranes follow
//                                                 them better than one impulse for all.
//   2. edges, in the mesh's order: along an edge of length l = |d| an impulse h f changes stretch and rate by
//      −2h² f/m and −2h f/m, so f = k_s (l − L0) + k_d l' after it is
//        f/m = (k_s (l − L0) + k_d l') / (m + 2h (h k_s + k_d)) before it; k_s and k_d with the edge's weight.
//   3. fluid: with ∇V = G/6 at x and c = h² Σ|∇V|²/m, a pressure p moves the volume to V' = V + c p. The
//      fluid's own pressure there, p = k_p/V' − P_0, is the larger root of
//        c p² + (V + c P_0) p + P_0 V − k_p = 0, and makes V' > 0 whatever V.
//      The fluid comes last: a sweep over stiff edges that are far from rest may halve a volume.
//   4. angular momentum: with x = x₀ + h v it is Σ m x₀ × v, and an edge that does not point where it did at
//      x₀ has changed it. A turn ω about the centre takes the change back:
//        Σ m x₀ × (ω × r) = J ω with J = tr(M) − M, M = Σ m r x₀ᵀ.
//      Without it spinning cells would slow down, and the order of edges would make resting ones spin.
//   5. the shell keeps what would leave it.
//
// Impulses change v by as much as they change x/h, so v need not be taken from differences of positions, whose rounding
// a short step magnifies. All impulses are inner: momentum stays.
#include "physics/lane_matrix.h"
#include "physics/ring_kernel.h"
#include "physics/shell_kernel.h"
#include "physics/spring_kernel.h"

namespace morula::MORULA_ISA {

/// The motion of each cell as a whole during a sub-step.
struct Spin {
  Vec origin[blockLanes / width];   // x₀ of the first vertex
  Vec angular[blockLanes / width];  // Σ (x₀ − origin) × v before the inner forces: angular momentum over m
};

/// Step 1: predicts the motion.
inline void predictMotion(const TemplateView& mesh, const BlockView& b, double kept, double h, Spin& spin) {
  const Lanes share = kept, step = h;
  for (int lane = 0, group = 0; lane < b.liveLanes; lane += width, ++group) {
    spin.origin[group] = loadVec(b.position, 0, lane);
    spin.angular[group] = zeroVec();
  }
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0, group = 0; lane < b.liveLanes; lane += width, ++group) {
      const Vec x = loadVec(b.position, v, lane);
      const Vec velocity = share * (loadVec(b.velocity, v, lane) + step * loadVec(b.acceleration, v, lane));
      spin.angular[group] += cross(x - spin.origin[group], velocity);
      storeVec(b.velocity, v, lane, velocity);
      storeVec(b.position, v, lane, x + step * velocity);
    }
}

/// Step 2: solves the springs.
template <bool damped, bool weighted>
inline void solveEdges(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double h) {
  const Lanes stiffness = p.stiffness, step = h;
  Lanes damping[blockLanes / width];
  findSpringDamping(b, p, damping);
  Lanes perTension[blockLanes / width];  // velocity over k_s (l − L0) + k_d l'
  const auto findPerTension = [&](double weight) MORULA_INLINE_LAMBDA {
    for (int lane = 0, group = 0; lane < b.liveLanes; lane += width, ++group) {
      const Lanes yielding = 2 * h * (h * p.stiffness + damping[group]) * weight;
      perTension[group] = Lanes(h * weight) / (load(b.vertexMass + lane) + yielding);
    }
  };
  findPerTension(1);
  for (int e = 0; e < mesh.edgeCount; ++e) {
    const int first = mesh.edges[2 * e], second = mesh.edges[2 * e + 1];
    const Lanes templateLength = mesh.restLengths[e];
    if constexpr (weighted) findPerTension(mesh.springWeights[e]);
    for (int lane = 0, group = 0; lane < b.liveLanes; lane += width, ++group) {
      const Vec x = loadVec(b.position, first, lane), y = loadVec(b.position, second, lane), d = y - x;
      const Vec v = loadVec(b.velocity, first, lane), w = loadVec(b.velocity, second, lane);
      const Lanes length = sqrt(dot(d, d) + tiny);
      const Lanes inverse = 1.0 / length;
      Lanes tension = stiffness * (length - templateLength * load(b.restScale + lane));
      if constexpr (damped) tension += damping[group] * (dot(w - v, d) * inverse);
      const Vec change = (perTension[group] * tension * inverse) * d, move = step * change;
      storeVec(b.velocity, first, lane, v + change);
      storeVec(b.velocity, second, lane, w - change);
      storeVec(b.position, first, lane, x + move);
      storeVec(b.position, second, lane, y - move);
    }
  }
}

/// Returns the larger root of c p² + (V + c P_0) p + P_0 V − k_p = 0, in the form that does not cancel.
MORULA_INLINE Lanes implicitPressure(Lanes volume, Lanes c, Lanes constant, Lanes outside) {
  const Lanes b = volume + c * outside, u = volume - c * outside;
  const Lanes root = sqrt(u * u + 4.0 * c * constant);  // = √(b² − 4c (P_0 V − k_p))
  const Lanes alike = 2.0 * (constant - outside * volume) / (b + root), opposite = (root - b) / (2.0 * c);
  return select(b > Lanes(0.0), alike, opposite);
}

/// Step 3: solves the fluid.
inline void solveFluid(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double h) {
  accumulateRings<false>(mesh, b, p);
  Lanes square[blockLanes / width];
  for (Lanes& s : square) s = Lanes(0.0);
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0, group = 0; lane < b.liveLanes; lane += width, ++group) {
      const Vec gradient = loadVec(b.gradient, v, lane);
      square[group] += dot(gradient, gradient);
    }
  Lanes perGradient[blockLanes / width];  // velocity over 6∇V
  for (int lane = 0, group = 0; lane < b.liveLanes; lane += width, ++group) {
    const Lanes mass = load(b.vertexMass + lane), c = Lanes(h * h / 36) * square[group] / mass;
    const Lanes pressure =
        implicitPressure(load(b.volume + lane), c, load(b.pressureConstant + lane), p.outsidePressure);
    perGradient[group] = Lanes(h / 6) * pressure / mass;
  }
  const Lanes step = h;
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0, group = 0; lane < b.liveLanes; lane += width, ++group) {
      const Vec change = perGradient[group] * loadVec(b.gradient, v, lane);
      storeVec(b.velocity, v, lane, loadVec(b.velocity, v, lane) + change);
      storeVec(b.position, v, lane, loadVec(b.position, v, lane) + step * change);
    }
}

/// A cell that turns by more in a sub-step is not turned back: J has no inverse near a quarter of a turn.
constexpr double maxTurn = 0.5;  // [rad]

/// Sums over a cell from which its turn follows.
struct Turn {
  Vec angular, x, s;  // Σ s × v, Σ x, Σ s with s = x₀, x from the first vertex each
  Matrix products;    // Σ x sᵀ
};

/// Returns ω, and leaves the mean of x in t.x.
MORULA_INLINE Vec findTurn(Turn& t, const Vec& angular, double vertices, double h) {
  t.x = Lanes(1 / vertices) * t.x;
  const Vec omega = solve(inertiaOf(t.products - outer(t.x, t.s)), t.angular - angular);
  const Mask sound = dot(omega, omega) < Lanes(maxTurn * maxTurn / (h * h));
  const Lanes none = 0.0;
  return {select(sound, omega.x, none), select(sound, omega.y, none), select(sound, omega.z, none)};
}

/// Step 4: restores angular momentum.
inline void keepAngularMomentum(const TemplateView& mesh, const BlockView& b, double h, const Spin& spin) {
  const Lanes step = h;
  for (int lane = 0, group = 0; lane < b.liveLanes; lane += width, ++group) {
    const Vec first = loadVec(b.position, 0, lane);
    Turn t{zeroVec(), zeroVec(), zeroVec(), zeroMatrix()};
    for (int v = 0; v < mesh.vertexCount; ++v) {
      const Vec position = loadVec(b.position, v, lane), velocity = loadVec(b.velocity, v, lane);
      const Vec x = position - first, s = (position - step * velocity) - spin.origin[group];
      t.angular += cross(s, velocity);
      t.x += x, t.s += s;
      t.products = t.products + outer(x, s);
    }
    const Vec omega = findTurn(t, spin.angular[group], mesh.vertexCount, h), centre = first + t.x;
    for (int v = 0; v < mesh.vertexCount; ++v) {
      const Vec x = loadVec(b.position, v, lane), change = cross(x - centre, omega);
      storeVec(b.velocity, v, lane, loadVec(b.velocity, v, lane) + change);
      storeVec(b.position, v, lane, x + step * change);
    }
  }
}

/// Step 5: the shell. predicted ← velocity.
template <ShellShape shell>
inline void endSubstep(const TemplateView& mesh, const BlockView& b, const KernelParameters& p) {
  const BlockShell<shell> felt(b, p);
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0, group = 0; lane < b.liveLanes; lane += width, ++group) {
      Vec velocity = loadVec(b.velocity, v, lane), predicted = velocity;
      if constexpr (shell != ShellShape::none) {
        Vec x = loadVec(b.position, v, lane);
        keepInShell<shell>(felt[group], x, velocity, predicted);
        storeVec(b.position, v, lane, x);
        storeVec(b.velocity, v, lane, velocity);
      }
      storeVec(b.predicted, v, lane, predicted);
    }
}

/// x ← x', velocity and predicted ← v'. The kick only ends the evaluation. A step of 0 moves nothing.
template <bool damped, ShellShape shell>
inline void driftXpbd(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double dt) {
  const double h = dt / p.substeps, kept = 1 / (1 + h * p.drag);
  for (int i = 0; i < p.substeps && dt > 0; ++i) {
    Spin spin;
    predictMotion(mesh, b, kept, h, spin);
    if (mesh.springWeights) solveEdges<damped, true>(mesh, b, p, h);
    else solveEdges<damped, false>(mesh, b, p, h);
    solveFluid(mesh, b, p, h);
    keepAngularMomentum(mesh, b, h, spin);
    if (i + 1 < p.substeps) endSubstep<shell>(mesh, b, p);
  }
  endSubstep<shell>(mesh, b, p);
}

/// Runs driftXpbd, with `keep` as the shell after each sub-step.
template <bool damped, auto keep>
inline void driftXpbdIn(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double dt) {
  KernelParameters one = p;
  one.substeps = 1;
  const int substeps = dt > 0 ? p.substeps : 1;
  for (int i = 0; i < substeps; ++i) {
    driftXpbd<damped, ShellShape::none>(mesh, b, one, dt / substeps);
    keep(mesh, b, p);
  }
}

}  // namespace morula::MORULA_ISA
