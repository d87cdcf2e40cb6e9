#pragma once
// Adhesion of cells that touch: how strongly each pair of vertices of the neighbour list sticks together. Both laws'
// kernels read that number beside the list, one after the other: no look-up and no branch per pair.
//
// W is the work that parts two flat surfaces, per area. Surfaces with n_i and n_j vertices per area and a gap g, each
// pair with the energy −s T/6 (1 − r²/A²)³ of pair_law_kernel.h, A = αR, hold
//
//   n_i n_j s T/6 ∫ (1 − (ρ² + g²)/A²)³ 2πρ dρ = n_i n_j s T πA²/24 (1 − g²/A²)⁴ = W (1 − g²/A²)⁴
//   ⇒  T = (24/π) W a_i a_j/(A² s),   a = 1/n the area of a vertex at rest, s of flat meshes face to face
//
// and attract each other most at g = 0.38 A. So W does not depend on the mesh nor on the cells' sizes. Surfaces that
// are stretched hold less, and compressed ones more: W a_i n_i a_j n_j. The sum over pairs grows with the square of the
// density of vertices, so that where membranes crumple there would be no end to it. The energy of vertex i saturates in
// its density ρ, as in the embedded-atom method [Daw & Baskes 1984]:
//
//   e_i = Σ_j T/12 z w³                           half of its pairs' energy [energy]
//   ρ_i = Σ_j T₁/(6 a_i) z w³                     1 in flat surfaces that touch; T₁ = T for W = 1
//   E_i = −e_i s(ρ_i),  s = φ(ρ)/ρ                of pairs with one W: E_i = −½ W a_i φ(ρ_i)
//   φ   = ρ up to 1, the density of flat surfaces that touch; then with x = (ρ − 1)/(3 (c − 1)), c = 1.1,
//         1 + (c − 1) (1 − (1 − x)³), and c from x = 1 on: E_i ≥ −½ c max(W) a_i whatever the arrangement
//
// With q_i = e_i s'(ρ_i)/a_i the derivative by z w³ of a pair is that of the sum over pairs with
//
//   T_eff = T (s_i + s_j)/2 + T₁ (q_i + q_j)      in place of T
//
// so the pass over the pairs that finds forces stays as it is, and one before it finds s and q (crowding_kernel.h).
#include <vector>

#include "base/aligned.h"
#include "physics/bodies.h"

namespace morula {

struct Contacts;

/// The kinds of cells: cells of one kind stick to others alike. Without given kinds all cells are of kind 0, and stick
/// with AdhesionParameters::strength.
struct AdhesionKinds {
  std::vector<int> ofSlot;   // [slot]
  int count = 1;             // number of kinds
  std::vector<double> work;  // [kind · count + kind] W [force/length], symmetric
  // [slot] Each cell's factor; two cells stick with the mean of their factors. Empty: all are 1.
  std::vector<double> factor = {};
};

/// The strengths of all pairs. They follow from the cells' kinds, their influence radii and the neighbour list.
struct Adhesion {
  AdhesionKinds kinds;
  std::vector<AlignedVector<double>> ofPairs;  // [block][as BlockLists::indices] T [energy]; of spheres S [force]
  std::vector<AlignedVector<double>> perWork;  // [as ofPairs] T₁ [length²]; empty for spheres
  bool isCurrent = false;                      // ofPairs and perWork fit the list
  AlignedVector<double> saturation;            // [vertex][2] ½ s and q of the last snapshots; not for spheres
  // Computed anew for each set of cells
  std::vector<int> blockOfLine;        // [line]
  std::vector<double> areaOverSquare;  // [mesh level] area of a vertex at rest over its influence radius squared
};

// Spheres attract each other over a gap of an eighth of the sum of their radii.
constexpr double sphereAdhesionReach = 1.125;

/// Returns W [force/length] of the cells in two slots. Requires adhesion.
double workOfAdhesion(const Contacts& contacts, int i, int j);

/// Returns a [length²] of a vertex, or 1/A² [1/length²] of vertices of two slots. After resetAdhesion; not for spheres.
double restAreaOfVertex(const Contacts& contacts, const Bodies& bodies, int slot);
double inverseReachSquared(const Contacts& contacts, int i, int j);

/// Must be called when the set of cells has changed. Does nothing without adhesion.
void resetAdhesion(Contacts& contacts, const Bodies& bodies);

/// Must be called when cells have changed their kinds, and after resetAdhesion.
void setAdhesionKinds(Contacts& contacts, AdhesionKinds kinds);

/// Fills Adhesion::ofPairs and perWork for the present list.
void findPairStrengths(Contacts& contacts, const Bodies& bodies, int threads);

/// Fills Adhesion::saturation for the last snapshots: before contact forces. Does nothing without adhesion.
void findCrowding(Contacts& contacts, const Bodies& bodies, int threads);

/// Returns s of a density ρ.
double saturationAt(double density);

/// Returns the steepest change [force/length] of these cells' adhesion with the distance of two vertices, times α², as
/// α² as many vertices are within A as within R; or of two spheres. It counts against the time step as a contact's
/// stiffness does. 0 without adhesion.
double adhesionStiffness(const Contacts& contacts, const Bodies& bodies);

}  // namespace morula
