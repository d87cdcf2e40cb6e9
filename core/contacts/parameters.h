#pragma once
// The parameters of contacts, as a scenario gives them.
#include <optional>
#include <string>
#include <vector>

#include "base/choice.h"
#include "base/members.h"
#include "physics/damping.h"

namespace morula {

enum class ContactLaw {
  pair,    // the gradient of an energy of each pair of vertices: both momenta are kept
  thesis,  // stiffness ∝ 1/Δt²; kept for comparison
};
template <>
inline constexpr auto choices<ContactLaw> = std::to_array<Choice<ContactLaw>>({
    {ContactLaw::pair, "pair", "gradient of an energy: closed scenes keep theirs, and come to rest"},
    {ContactLaw::thesis, "thesis", "implicit planes with [Nilsson 2008, eq. 4.8]"},
});

/// How strongly cells with one of two substances stick to cells with the other.
struct AdhesionPair {
  std::string a, b;     // a substance, or its beginning and '*'; a and b may be exchanged
  double strength = 0;  // as AdhesionParameters::strength
};
MORULA_MEMBERS(AdhesionPair, first, second, strength)

/// Differential adhesion [Steinberg 1963].
struct AdhesionParameters {
  // W [force/length], energy per area: what it costs to part two flat surfaces, per area of contact, whatever the mesh
  // and the cells' size. Applies to cells that no pair names. Higher: larger contacts, and crumpled ones from about a
  // fifth of the membrane's stiffness on.
  double strength = 0;
  std::vector<AdhesionPair> pairs;  // the first that fits two cells counts
};
MORULA_MEMBERS(AdhesionParameters, strength, pairs)

// Constants of the pair law, for kernels and measures; the formulas are in pair_law_kernel.h and surface_kernel.h.
constexpr double retreat = 0.125, surfaceDepth = 0.65;                       // λ, γ
constexpr double foldedNormal = 2;                                           // ε
constexpr double normalScaleSquared = 1 + foldedNormal * foldedNormal / 27;  // ν²
constexpr double minFacing = 0.5;                                            // m₀
constexpr double attractionReach = 1.5;                                      // α
constexpr double maxHeld = 1.1;  // c, the max energy of a vertex over W a/2, to which adhesion saturates (adhesion.h)
constexpr double hardening1 = 6, hardening2 = 200;  // β₁, β₂
// B of two vertices face to face where the energy is about to fall again, and κ D² at that depth. Surfaces farther in
// each other pass through.
constexpr double deepestHeld = 0.37, deepestBulk = 0.54;
// [1] Max share of a reach by which a cell's centre may move in a step. Two cells that meet then approach by 0.38 of
// it: no pair of vertices face to face skips the depths from 0.61, where a run ends (deepestHeld), to 1.
constexpr double maxFlight = 0.19;

struct ContactParameters {
  ContactLaw law = ContactLaw::pair;
  double stiffness = 30;    // K [force/length] of one vertex pair; not the thesis' law
  Damping damping;          // C against approach, of the lightest vertex' mass; not the thesis' law
  double viscosity = 0;     // [1] max force against sliding, per normal force; not the thesis' law
  double slipSpeed = 0.01;  // [length/time] below it viscosity fades out linearly
  double radius = 1;        // influence radius of a vertex, in mean rest lengths of its cell's edges
  std::optional<AdhesionParameters> adhesion = {};  // absent: cells that touch do not stick; not the thesis' law
};
MORULA_MEMBERS(ContactParameters, law, stiffness, damping, viscosity, slipSpeed, radius, adhesion)

}  // namespace morula
