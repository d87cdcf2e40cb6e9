#include "organism/veil_lists.h"

#include <algorithm>
#include <tuple>

#include "base/parallel.h"
#include "organism/drawn_samples.h"

namespace morula {
namespace {

bool isBefore(const VeilFragment& a, const VeilFragment& b) {
  if (a.depth != b.depth) return a.depth < b.depth;
  return std::tie(a.owner, a.light[0], a.light[1], a.light[2], a.opacity) <
         std::tie(b.owner, b.light[0], b.light[1], b.light[2], b.opacity);
}

struct List {
  VeilFragment *begin, *end;
  std::size_t size() const { return std::size_t(end - begin); }
};

List listAt(const VeilRows& veils, std::size_t sample) {
  return {veils.fragments + (sample ? veils.ends[sample - 1] : 0), veils.fragments + veils.ends[sample]};
}

}  // namespace

void sortVeils(const VeilRows& veils, int threads) {
  parallelFor(veils.rows, threads, [&](int row) {
    for (int x = 0; x < veils.width; ++x) {
      const List list = listAt(veils, std::size_t(row) * veils.width + x);
      // Insertion sort: the lists are short, and nearly sorted, because cells are drawn from the nearest on.
      for (VeilFragment* at = list.begin; at < list.end; ++at) {
        const VeilFragment fragment = *at;
        VeilFragment* to = at;
        for (; to > list.begin && isBefore(fragment, to[-1]); --to) *to = to[-1];
        *to = fragment;
      }
    }
  });
}

std::vector<float> composeVeils(const VeilRows& veils, int first, int last, int outlineReach, int threads) {
  const int width = veils.width;
  std::vector<float> result(std::size_t(4) * width * (last - first));
  parallelFor(last - first, threads, [&](int row) {
    const int y = first + row, below = std::max(y - outlineReach, 0),
              above = std::min(y + outlineReach, veils.rows - 1);
    for (int x = 0; x < width; ++x) {
      const auto at = [&](int column, int line) { return listAt(veils, std::size_t(line) * width + column); };
      const List list = at(x, y);
      if (list.size() == 0) continue;
      const List around[4] = {at(std::max(x - outlineReach, 0), y), at(std::min(x + outlineReach, width - 1), y),
                              at(x, below), at(x, above)};
      float* sum = &result[4 * (std::size_t(row) * width + x)];
      for (std::size_t i = 0; i < list.size(); ++i) {
        const VeilFragment& here = list.begin[i];
        const bool isEdge = std::any_of(around, around + 4, [&](const List& other) {
          return i >= other.size() || other.begin[i].owner != here.owner;
        });
        const float shade = isEdge ? outlineShade : 1, opacity = float(here.opacity) / 65535;
        const float cover = 1 + (opacity - 1) * shade;  // keeps outlines visible on faint cells
        const float through = 1 - sum[3], factor = through * shade * cover * (2.0f / 65535);
        for (int c = 0; c < 3; ++c) sum[c] += factor * float(here.light[c]);
        sum[3] += through * cover;
      }
    }
  });
  return result;
}

}  // namespace morula
