#include "connections/connections.h"

#include <algorithm>

#include "base/error.h"

namespace morula {
namespace {

using Pair = std::pair<CellPath, CellPath>;

Pair ordered(const CellPath& a, const CellPath& b) { return a < b ? Pair{a, b} : Pair{b, a}; }

/// Returns the place of the pair in the active list, or where the pair would go.
auto place(const Connections& c, const Pair& pair) {
  return std::lower_bound(c.active.begin(), c.active.end(), pair, [&](std::size_t i, const Pair& p) {
    return Pair{c.history[i].a, c.history[i].b} < p;
  });
}

std::uint64_t countOf(const Connections& c, const CellPath& cell) {
  return std::ranges::count_if(c.active,
                               [&](std::size_t i) { return c.history[i].a == cell || c.history[i].b == cell; });
}

}  // namespace

bool areConnected(const Connections& c, const CellPath& a, const CellPath& b) {
  const Pair pair = ordered(a, b);
  const auto at = place(c, pair);
  return at != c.active.end() && c.history[*at].a == pair.first && c.history[*at].b == pair.second;
}

void connect(Connections& c, const CellPath& a, const CellPath& b, double time) {
  MORULA_CHECK(a != b, "a cell cannot be connected to itself");
  if (areConnected(c, a, b)) return;
  if (const auto& most = c.parameters.most; most && (countOf(c, a) >= *most || countOf(c, b) >= *most)) return;
  const Pair pair = ordered(a, b);
  const auto at = place(c, pair) - c.active.begin();
  c.history.push_back({pair.first, pair.second, time});
  c.active.insert(c.active.begin() + at, c.history.size() - 1);
  c.isCurrent = false;
}

void release(Connections& c, const CellPath& a, const CellPath& b, double time, ReleaseCause cause) {
  if (!areConnected(c, a, b)) return;
  const auto at = place(c, ordered(a, b)) - c.active.begin();
  ConnectionRecord& record = c.history[c.active[at]];
  record.released = time;
  record.cause = cause;
  c.active.erase(c.active.begin() + at);
  c.isCurrent = false;
}

void releaseAll(Connections& c, const CellPath& cell, double time, ReleaseCause cause) {
  for (const CellPath& other : partners(c, cell)) release(c, cell, other, time, cause);
}

std::vector<CellPath> partners(const Connections& c, const CellPath& cell) {
  std::vector<CellPath> others;
  for (std::size_t i : c.active) {
    if (c.history[i].a == cell) others.push_back(c.history[i].b);
    if (c.history[i].b == cell) others.push_back(c.history[i].a);
  }
  std::sort(others.begin(), others.end());
  return others;
}

}  // namespace morula
