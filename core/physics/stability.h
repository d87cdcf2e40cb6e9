#pragma once
// The largest stable time step of one cell, by mode. Measured limits are 0.94 to 1.15 of these.
#include <limits>

#include "physics/bodies.h"

namespace morula {

struct StabilityLimits {
  double spring = 0;    // [time] all springs of a vertex against its mass, or its goal's pull
  double pressure = 0;  // [time] breathing: the whole membrane against the enclosed fluid
  double bending = std::numeric_limits<double>::infinity();  // [time] the sharpest mode of bending; infinite without
};

/// Spring mode, 6 k_s/m_p with damping (with weighted springs the largest sum of a ring's weights for 6), and
/// pressure mode:
///   k_s Δt² + 2s k_d Δt − 4 m_p/6 = 0       s = 2 for velocity Verlet, 1 for the thesis' and symplectic Euler
///   Δt = 2/ω,  ω² = u (k_p/V²) A²/m         V from the last evaluation, A the area of the sphere that holds it,
///                                           m the cell's mass, u = n Σ |∂V/∂x_v|²/A² of the mesh at rest, 1 at
///                                           least: more where few of the n vertices bear much of the surface
/// Bending mode, undamped: Δt = 2/ω, ω² = κ λ/m_p, λ the largest eigenvalue of W A⁻¹ W (bending_kernel.h).
///
/// Runge–Kutta: where its amplification reaches 1, for an undamped mode Δt = √8/ω.
///
/// Explicit Euler amplifies undamped modes at any step: its limit is γ/ω² (less where a mode is overdamped). Springs
/// damp only along the edges, so a membrane under tension oscillates undamped across them unless there is drag: without
/// drag both limits are 0. With drag they are the limits of modes damped by k_d and drag, and by drag alone for
/// breathing and for oscillations across edges with k_s (1 − L0/L) of the sphere that holds V.
///
/// XPBD has no limits: both are infinite.
///
/// Shape matching: `spring` is the limit of a vertex against a goal that rests, ω² = k, damped by κ + drag: no mode is
/// stiffer. Linear deformations have (1 − β) k, and the smaller limit of the two counts. There is no pressure. Spheres
/// have no inner modes: both limits are infinite.
StabilityLimits measureLimits(const Bodies& bodies, int slot);

constexpr double usualPairs = 10;

/// Returns the limit [time] of a penalty contact K, C between vertices of mass m, each pressed by `pairs` pairs with
/// both sides in motion: ω² = `pairs` K/m. A freshly cut face, with twice the usual density of vertices, has 10 pairs
/// where the weights of a vertex sum up to 5:
///   K Δt² + 2s C Δt − 4 m/pairs = 0
/// `drag` [1/time] is explicit Euler's only damping along surfaces; without it the limit is 0. XPBD takes contact
/// forces once per time step: s = 1, whatever its sub-steps.
double contactLimit(Integrator integrator, double stiffness, double damping, double vertexMass, double drag = 0,
                    double pairs = usualPairs);

/// Returns the limit [time] of drag alone, without a spring: 2/(s·drag) except for Runge–Kutta. Infinite without drag,
/// and with XPBD.
double dragLimit(Integrator integrator, double drag);

}  // namespace morula
