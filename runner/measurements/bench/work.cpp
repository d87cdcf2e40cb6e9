#include "bench/work.h"

#include <algorithm>

namespace morula {
namespace {

constexpr double vectorBytes = 24, rowBytes = 64, indexBytes = 4;

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

Work contactWork(double pairs, bool viscosity) {
  // Per vertex, the snapshot: |G|² 5, G/|G| 3, way since the list was made 3 + 5.
  // Per pair [core/contacts/pair_law_kernel.h]: apart, relative and h 3 + 3 + 6, two projections 10, two
  // squares 5 + 2, 1/R² 2, fade 2, v·h 5, push 3, within reach 1, size 2, force and sum 3 + 3; and with
  // viscosity h² 5, slip 6, its square 5, force 4 + 3.
  const double perPair = 50 + (viscosity ? 23 : 0);
  // Reads x and the list's x, writes a row; then reads a row and a list, reads and writes the force.
  return {16 + perPair * pairs, 1 + (viscosity ? 1.5 * pairs : 0), 4 * vectorBytes + 2 * rowBytes + indexBytes * pairs,
          3 * vectorBytes + rowBytes + indexBytes * pairs};
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
  if (!contact) return all;
  all.operations += contact->operations;
  all.roots += contact->roots;
  // x has been fetched already. The second pass ends the step: v and a once more, of which contact counts a.
  all.bytes += contact->bytes - vectorBytes + 2 * vectorBytes;
  all.touched += contact->touched - 2 * vectorBytes;
  return all;
}

double minTime(const Work& work, const MachineLimits& limits, Isa isa, double vertices) {
  const auto& arithmetic = limits.arithmetic.at(isa);
  return std::max({work.operations / arithmetic.operations, work.roots / arithmetic.roots,
                   work.bytes / limits.bandwidthFor(work.touched * vertices)});
}

}  // namespace morula
