#pragma once
// Which pairs of the neighbour list may act for a while. Without adhesion a pair adds exactly nothing (pair_law_kernel.h)
// unless
//
//   |a| < R_ij  and  min(g, g + τ ġ) < 0      with the gap g = a·h, ġ = u·h, u = v_i − v_j and the delay τ = C/K
//
// and two in three do not: they lie beside or behind each other, or are too far apart. Let a₀, h₀, u₀, g₀ and ġ₀ be those
// of a moment, and b = a₀ + t u₀ what a is a time t later if no v changes. While no y is farther than δ from where its v of
// then would have brought it, no n has turned by more than η, and no v has changed by more than w, all as lengths of
// vectors, and since no n, and so no h, is longer than ν,
//
//   |a| ≥ |b| − 2δ
//   g = b·h₀ + (a − b)·h₀ + a·(h − h₀)                   ≥ g₀ + t ġ₀ − 2νδ − R_ij η                     where |a| < R_ij
//   g + τ ġ = g + τ ġ₀ + τ (u − u₀)·h + τ u₀·(h − h₀)    ≥ g₀ + (t + τ) ġ₀ − 2ν (δ + τ w) − (R_ij + τ |u₀|) η
//
// So until 2ν (δ + τ w) + R η of one cell or the other, for the largest R of all, reaches the margin M_i or M_j of that cell,
// or t a horizon T, no pair acts with M = (M_i + M_j)/2 and
//
//   |b| > R_ij + M for all t ≤ T   or   min(g₀, g₀ + (T + τ) ġ₀) > M + τ |u₀| M/R
//
// What moves together stays apart, however fast. In single precision roundings of all this, here and in the law, are some
// 1e-6 of R + (T + τ) |u₀|, and of |b|: 1e-5 of them are added. η and w are sums over snapshots of the largest changes from
// one to the next, and δ of how far y is from where the last v would have brought it, and of w over time.
#include "contacts/near_kernel.h"  // hitTable
#include "contacts/rows_kernel.h"

namespace morula::MORULA_ISA {

/// Of `width` vertices.
MORULA_INLINE Lanes halfMargins(const ListsToThin& lists, const VertexNumber* vertex) {
  Real spread[width];
  for (int l = 0; l < width; ++l) spread[l] = lists.halfMargins[vertex[l]];
  return load(spread);
}

/// [ContactKernels::findActing]
inline void findActing(const ListsToThin& lists, const RowMemory* rows, std::int32_t* begin, std::int32_t* length,
                       VertexNumber* acting) {
  const Lanes perRadius = lists.perRadius, horizon = lists.horizon, delayPerRadius = lists.delayPerRadius,
              ahead = lists.ahead, room = lists.room, roomPerSpeed = lists.roomPerSpeed;
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
      const Lanes ownHalf = lists.halfMargins[own[0]];
      for (std::int32_t k = 0; k < count; k += width) {
        for (int l = 0; l < width; ++l) __builtin_prefetch(rows + list[k + 16 + l]);
        const Rows j = loadRows(rows, list + k);
        const Vec a = i.x - j.x, relative = i.v - j.v, apartNormals = j.n - i.n;  // 2h
        const Lanes curvature = 0.5 * (i.inverseRadiusSquared + j.inverseRadiusSquared);
        const Lanes gap = 0.5 * dot(a, apartNormals), opening = 0.5 * dot(relative, apartNormals);
        const Lanes margin = ownHalf + halfMargins(lists, list + k), speedSquare = dot(relative, relative);
        const Lanes most = room + margin + (roomPerSpeed + delayPerRadius * margin) * sqrt(speedSquare);
        const Lanes reach = (1 + relativeRoom) * (1.0 + perRadius * margin);
        const Lanes nearestAt = min(max(-dot(a, relative) / (speedSquare + tiny), Lanes(0.0)), horizon);
        const Vec nearest = a + nearestAt * relative;
        const unsigned idle = bits(curvature * dot(nearest, nearest) > reach * reach) |
                              bits((gap > most) & (gap + ahead * opening > most));  // what does not compare may act
        const unsigned acts = ~idle & ((1u << (count - k < width ? count - k : width)) - 1);
        for (int l = 0; l < width; ++l) acting[found + l] = list[k + hitTable.which[acts][l]];
        found += hitTable.count[acts];
      }
      length[row] = found - begin[row];
    }
}

}  // namespace morula::MORULA_ISA
