#pragma once
// Chooses the pairs of the neighbour list that may act for a while. Without adhesion a pair adds exactly nothing
// (pair_law_kernel.h) unless
//
//   |a| < R_ij  and  min(g, g + τ ġ) < 0      with the gap g = a·h, ġ = u·h, u = v_i − v_j and the delay τ = C/K
//
// Two pairs in three do not act: they lie beside or behind each other, or are too far apart. Let a₀, h₀, u₀, g₀ and ġ₀
// be the values of a moment, and b = a₀ + t u₀ the value of a at a time t later if no v changes. Assume that since then
// no y has strayed by more than δ from where its v would have brought it, no n has turned by more than η, and no v has
// changed by more than w, as lengths of vectors. No n, and so no h, is longer than ν. Then
//
//   |a| ≥ |b| − 2δ
//   g = b·h₀ + (a − b)·h₀ + a·(h − h₀)                   ≥ g₀ + t ġ₀ − 2νδ − R_ij η                    where |a| < R_ij
//   g + τ ġ = g + τ ġ₀ + τ (u − u₀)·h + τ u₀·(h − h₀)    ≥ g₀ + (t + τ) ġ₀ − 2ν (δ + τ w) − (R_ij + τ |u₀|) η
//
// with means of both vertices' δ, η and w. The pair does not act until 2ν (δ + τ w) + R η of either vertex, for the
// largest R of all, reaches a margin M, or t a horizon T, if
//
//   |a₀|² + 2T min(a₀·u₀, 0) > (R_ij + M)²   or   min(g₀, g₀ + (T + τ) ġ₀) > M + τ |u₀| M/R
//
// since |b|² is at least the first left side. Vertices that move together stay apart, however fast. In single
// precision, roundings of the choice, the law and the counts are some 1e-6 of R + (T + τ) |u₀| and of |b|, so 1e-5 of
// them are added. For each vertex η and w are sums of the changes from one snapshot to the next. δ is the sum of how
// far y is from where the last v would have brought it, and of w over time. Upper bounds stand for lengths (atMost).
//
// A vertex that reaches the margin is checked again against its whole list, and so are the vertices that may act on it
// then: both sides get the same answer, to the bit. Other lists may still name the vertex, which adds nothing.
#include "contacts/near_kernel.h"  // hitTable
#include "contacts/rows_kernel.h"

namespace morula::MORULA_ISA {

/// [ContactKernels::findActing]
inline void findActing(const ListsToThin& lists, const RowMemory* rows, std::int32_t* begin, std::int32_t* length,
                       VertexNumber* acting) {
  const Lanes reachSquare = lists.reach * lists.reach, twiceHorizon = 2 * lists.horizon, ahead = lists.ahead,
              room = lists.room, roomPerSpeed = lists.roomPerSpeed;
  std::int32_t found = 0;
  for (std::int32_t r = 0; r < lists.count; ++r) {
    const std::int32_t row = lists.rows[r], count = lists.length[row];
    const VertexNumber* list = lists.neighbours + lists.begin[row];
    begin[row] = found;
    if (r + 2 < lists.count) {
      const VertexNumber* soon = lists.neighbours + lists.begin[lists.rows[r + 1]];
      for (std::int32_t k = 0; k < lists.length[lists.rows[r + 1]]; ++k) __builtin_prefetch(rows + soon[k]);
      __builtin_prefetch(lists.neighbours + lists.begin[lists.rows[r + 2]]);
    }
    const Rows i = loadRowInAllLanes(rows + lists.firstVertex + row);
    for (std::int32_t k = 0; k < count; k += width) {
      const Rows j = loadRows(rows, list + k);
      const Vec a = i.x - j.x, relative = i.v - j.v, apartNormals = j.n - i.n;  // 2h
      const Lanes curvature = 0.5 * (i.inverseRadiusSquared + j.inverseRadiusSquared);
      const Lanes gap = 0.5 * dot(a, apartNormals), opening = 0.5 * dot(relative, apartNormals);
      const Lanes most = room + roomPerSpeed * atMost(relative);
      const Lanes nearest = dot(a, a) + twiceHorizon * min(dot(a, relative), Lanes(0.0));
      const unsigned idle = bits(curvature * nearest > reachSquare) |
                            bits((gap > most) & (gap + ahead * opening > most));  // a NaN may act
      const unsigned acts = ~idle & ((1u << (count - k < width ? count - k : width)) - 1);
      for (int l = 0; l < width; ++l) acting[found + l] = list[k + hitTable.which[acts][l]];
      found += hitTable.count[acts];
    }
    length[row] = found - begin[row];
  }
}

}  // namespace morula::MORULA_ISA
