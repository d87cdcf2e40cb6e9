#pragma once
// Which pairs of the neighbour list may act for a while. Without adhesion a pair adds exactly nothing (pair_law_kernel.h)
// unless
//
//   |a| < R_ij  and  min(g, g + τ ġ) < 0      with the gap g = a·h, ġ = u·h, u = v_i − v_j and the delay τ = C/K
//
// and two in three do not: they lie beside or behind each other, or are too far apart. Let a₀, h₀, u₀, g₀ and ġ₀ be those
// of a moment. While no y has moved farther than δ since then, no n has turned by more than η, and no v has changed by
// more than w, all as lengths of vectors, and since no n, and so no h, is longer than ν,
//
//   |a| ≥ |a₀| − 2δ
//   g = g₀ + (a − a₀)·h₀ + a·(h − h₀)                ≥ g₀ − 2νδ − R_ij η                              where |a| < R_ij
//   g + τ ġ = g + τ ġ₀ + τ (u − u₀)·h + τ u₀·(h − h₀)  ≥ g₀ + τ ġ₀ − 2ν (δ + τ w) − (R_ij + τ |u₀|) η
//
// So until 2ν (δ + τ w) + R η reaches a margin M, for the largest R of all cells, no pair acts with
//
//   |a₀| > R_ij + M   or   min(g₀, g₀ + τ ġ₀) > M + τ |u₀| M/R
//
// In single precision roundings of all this, here and in the law, are some 1e-6 of R + τ |u₀|, and of |a₀|: 1e-5 of them
// are added. δ, η and w are sums over snapshots of the largest changes from one to the next.
#include "contacts/rows_kernel.h"

namespace morula::MORULA_ISA {

/// [ContactKernels::findActing]
inline void findActing(const ListsToThin& lists, const RowMemory* rows, std::int32_t* begin, std::int32_t* length,
                       VertexNumber* acting) {
  const Lanes margin = lists.margin, perSpeed = lists.perSpeed, delay = lists.delay, reachSquared = lists.reachSquared;
  std::int32_t found = 0;
  for (int lane = 0; lane < lists.liveLanes; ++lane)
    for (int v = 0; v < lists.vertices; ++v) {
      const int row = v * blockLanes + lane;
      const VertexNumber* list = lists.neighbours + lists.begin[row];
      const std::int32_t count = lists.length[row];
      if (count == 0) continue;
      begin[row] = found;
      VertexNumber own[width];
      for (VertexNumber& g : own) g = lists.firstVertex + row;
      const Rows i = loadRows(rows, own);
      for (std::int32_t k = 0; k < count; k += width) {
        for (int l = 0; l < width; ++l) __builtin_prefetch(rows + list[k + 16 + l]);
        const Rows j = loadRows(rows, list + k);
        const Vec a = i.x - j.x, relative = i.v - j.v, apartNormals = j.n - i.n;  // 2h
        const Lanes curvature = 0.5 * (i.inverseRadiusSquared + j.inverseRadiusSquared);
        const Lanes gap = 0.5 * dot(a, apartNormals), opening = 0.5 * dot(relative, apartNormals);
        const Lanes most = margin + perSpeed * sqrt(dot(relative, relative));
        // What does not compare may act.
        const unsigned idle =
            bits(curvature * dot(a, a) > reachSquared) | bits((gap > most) & (gap + delay * opening > most));
        const std::int32_t left = count - k;
        unsigned acts = ~idle & ((1u << (left < width ? left : width)) - 1);
        for (; acts; acts &= acts - 1) acting[found++] = list[k + __builtin_ctz(acts)];
      }
      length[row] = found - begin[row];
    }
}

}  // namespace morula::MORULA_ISA
