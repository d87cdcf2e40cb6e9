#include "bench/work.h"

#include <algorithm>

namespace morula {
namespace {

constexpr double vectorBytes = 24, rowBytes = 64, changeBytes = 8, indexBytes = 4;

/// The operations of inner forces per vertex.
struct InternalWork {
  double springs = 0, rings = 0, pressure = 0;
};

InternalWork count(const MeshTemplate& mesh, const PhysicsParameters& p) {
  const double vertices = mesh.vertexCount(), edges = mesh.edgeCount();
  // Per edge: d 3, |d|² 5, Δl 2, k_s Δl 1, over l 1; and with damping Δw 3, Δw·d 5, over l 1, k_d 1, sum 1.
  double perEdge = 12;
  if (p.membrane.damping.acts()) perEdge += 11;
  InternalWork work;
  // Per ring of n neighbours (n even): n differences 3n, forces c d 6n − 3, n/2 differences and products
  // d × (d' − d") summed (3 + 9 + 3) n/2 − 3; and once G·(x − x_0) with its sum 9.
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const double n = mesh.ringStart[v + 1] - mesh.ringStart[v];
    work.rings += 3 * n / vertices;
    work.springs += (6 * n - 3) / vertices;
    work.pressure += (7.5 * n - 3 + 9) / vertices;
  }
  work.springs += perEdge * edges / vertices;
  work.pressure += 6;  // F + P/6 G
  return work;
}

}  // namespace

const Instructions& instructionsOf(Isa isa) {
  static constexpr Instructions scalar{429, 148, 843, 90, 146, 481, 4150, 1090}, narrow{241, 114, 529, 75, 103, 262, 3310, 886},
      avx2{114.5, 41.7, 265, 46, 56, 124, 2020, 560}, avx512{57, 22.6, 183, 26, 31, 63, 1640, 473};
  static constexpr PerIsa<Instructions> counted{&scalar, &narrow, &avx2, &avx512};
  return counted[isa];
}

Work internalWork(const MeshTemplate& mesh, const PhysicsParameters& p) {
  const InternalWork work = count(mesh, p);
  const double drag = p.drag > 0 ? 6 : 0;
  // Reads x, writes the force.
  return {work.springs + work.rings + work.pressure + drag, mesh.edgeCount() / double(mesh.vertexCount()),
          2 * vectorBytes, 2 * vectorBytes};
}

double springShare(const MeshTemplate& mesh, const PhysicsParameters& p) {
  const InternalWork work = count(mesh, p);
  // A root and a division per edge take as long as about eight operations each way.
  const double roots = 16 * mesh.edgeCount() / double(mesh.vertexCount());
  const double springs = work.springs + roots + work.rings / 2;
  return springs / (springs + work.pressure + work.rings / 2);
}

Work contactWork(const MeshTemplate& mesh, double slots, bool viscosity) {
  const double n = static_cast<double>(mesh.ring.size()) / mesh.vertexCount();  // steps of a ring
  // Per vertex [core/contacts/surface_kernel.h]
  //   snapshot: the ring's sum 3n − 3, √(G² + ε² R⁴) 6, n 3, y 3 + 3 + 3 + 6, moved since the search 3 + 5 + 2
  //   changes since the choice: v 3 + 7, n 3 + 7, y 6 + 3 + 7, their sum 9, its max 1
  //   f and t: 1 − n²/ν² 7, 1/√… 2, q 6, n·q 5, t 10
  //   to the vertices: per step of the ring λ/n f 6, chord × t 3 + 9, sum 3; once λ 3 + 3, (1 − λ) f 3 + 3, sum 3
  const double perVertex = (3 * n - 3 + 6 + 3 + 15 + 10) + 46 + 30 + (21 * n + 15);
  // Per slot [core/contacts/pair_law_kernel.h]: a, relative v and 2h 9, a² 5, κ 2, κa² 2, D 5, ḋ 5, over 4 2, u 3, m 6,
  // D² 2, B and K D² 3, the deepest 1, push 6, whether s is 1 1, E_D 3, E_q 7, f 3 + 1 + 3 + 3 + 3, q 6. Viscosity: slip
  // 5 + 4 + 1, grip 3, along a 5 + 3, sum 6.
  const double perSlot = 81 + (viscosity ? 27 : 0);
  // The snapshot reads x and the searched x, reads and writes a row and changes. The second pass reads a row, indices
  // and x, reads and writes the force.
  return {perVertex + perSlot * slots, 1.5 + (viscosity ? slots : 0),
          5 * vectorBytes + 3 * rowBytes + 2 * changeBytes + indexBytes * slots,
          3 * vectorBytes + rowBytes + changeBytes + indexBytes * slots};
}

Work integrationWork(bool shell) {
  // Per component: drift 5, kick 3. The shell: which side, twice, 2 · 8.
  // x, v and a in and out.
  return {3 * (5 + 3.0) + (shell ? 16 : 0), 0, 6 * vectorBytes, 3 * vectorBytes};
}

Work stepWork(const Work& internal, const Work* contact, const Work& integration) {
  // Integration has just fetched the memory that internal forces use.
  Work all = integration;
  all.operations += internal.operations;
  all.roots += internal.roots;
  all.instructions += internal.instructions;
  if (!contact) return all;
  all.operations += contact->operations;
  all.roots += contact->roots;
  all.instructions += contact->instructions;
  // x has been fetched already. The second pass ends the step: v and a once more, of which contact counts a.
  all.bytes += contact->bytes - vectorBytes + 2 * vectorBytes;
  all.touched += contact->touched - 2 * vectorBytes;
  return all;
}

Bound WorkLimit::bound() const { return static_cast<Bound>(std::ranges::max_element(seconds) - seconds.begin()); }

WorkLimit findLimit(const Work& work, const MachineLimits& limits, Isa isa, double vertices) {
  const auto& arithmetic = limits.arithmetic.at(isa);
  return {{work.operations / arithmetic.operations, work.roots / arithmetic.roots,
           work.bytes / limits.bandwidthFor(work.touched * vertices), work.instructions / arithmetic.instructions}};
}

}  // namespace morula
