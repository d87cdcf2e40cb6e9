#include "bench/work.h"

#include <algorithm>

namespace morula {

namespace {

constexpr double vectorBytes = 24, rowBytes = 64, indexBytes = 4;

}  // namespace

Work internalWork(const MeshTemplate& mesh, const PhysicsParameters& p) {
  const double vertices = mesh.vertexCount(), edges = mesh.edgeCount();
  // Per edge: d 3, |d|² 5, Δl 2, k_s Δl 1, over l 1; and with damping Δw 3, Δw·d 5, over l 1, k_d 1, sum 1.
  double perEdge = 12;
  if (p.membrane.damping > 0) perEdge += 11;
  // Per ring of n neighbours (n even): n differences 3n, forces c d 6n − 3, n/2 differences and products
  // d × (d' − d") summed (3 + 9 + 3) n/2 − 3; and once G·(x − x_0) with its sum 9.
  double ring = 0;
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const double n = mesh.ringStart[v + 1] - mesh.ringStart[v];
    ring += 3 * n + (6 * n - 3) + (7.5 * n - 3) + 9;
  }
  // Per vertex: F + P/6 G 6, drag 6.
  const double perVertex = 6 + (p.drag > 0 ? 6 : 0);
  return {perEdge * edges / vertices + ring / vertices + perVertex, edges / vertices, 2 * vectorBytes};
}

Work contactWork(double pairs, bool friction) {
  // Per vertex, the snapshot: |G|² 5, G/|G| 3, way since the list was made 3 + 5.
  // Per pair [core/contacts/pair_law_kernel.h]: apart, relative and h 3 + 3 + 6, two projections 10, two
  // squares 5 + 2, 1/R² 2, fade 2, v·h 5, push 3, within reach 1, size 2, force and sum 3 + 3; and with
  // friction h² 5, slip 6, its square 5, force 4 + 3.
  const double perPair = 50 + (friction ? 23 : 0);
  return {16 + perPair * pairs, 1 + (friction ? 1.5 * pairs : 0),
          2 * vectorBytes + 2 * rowBytes + indexBytes * pairs + 2 * vectorBytes};
}

Work integrationWork(bool shell) {
  // Per component: drift 5, kick 3. The shell: which side, twice, 2 · 8.
  return {3 * (5 + 3.0) + (shell ? 16 : 0), 0, 9 * vectorBytes};
}

Work stepWork(const Work& internal, const Work& contact, const Work& integration, double pairs,
              bool touching) {
  Work all = internal + contact + integration;
  // In passes over blocks that stay in a cache: first x, v and a there and back, with contact the reference
  // read and a row written; then with contact the rows and lists read, v and a there and back.
  all.bytes =
      6 * vectorBytes + (touching ? vectorBytes + 2 * rowBytes + indexBytes * pairs + 4 * vectorBytes : 0);
  return all;
}

double footprint(double pairs, bool touching) {
  return 3 * vectorBytes + (touching ? vectorBytes + rowBytes + indexBytes * pairs : 0);
}

double leastTime(const Work& work, const MachineLimits& limits, Isa isa, double bytesInAll) {
  const auto& arithmetic = limits.arithmetic.at(isa);
  return std::max({work.operations / arithmetic.operations, work.roots / arithmetic.roots,
                   work.bytes / limits.bandwidthFor(bytesInAll)});
}

}  // namespace morula
