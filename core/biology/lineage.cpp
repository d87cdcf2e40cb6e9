#include "biology/lineage.h"

#include <algorithm>
#include <numeric>

namespace morula {

const char* name(Fate fate) {
  constexpr const char* names[] = {"alive", "divided", "died"};
  return names[static_cast<int>(fate)];
}

std::vector<std::uint32_t> orderByPath(const Lineage& lineage) {
  std::vector<std::uint32_t> order(lineage.entries.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return lineage.entries[i].path; });
  return order;
}

const LineageEntry* find(const Lineage& lineage, std::span<const std::uint32_t> order, const CellPath& path) {
  const auto place =
      std::ranges::lower_bound(order, path, {}, [&](std::uint32_t i) { return lineage.entries[i].path; });
  if (place == order.end() || lineage.entries[*place].path != path) return nullptr;
  return &lineage.entries[*place];
}

std::vector<std::uint32_t> leaves(const Lineage& lineage) {
  std::vector<std::uint32_t> order = orderByPath(lineage);
  std::erase_if(order, [&](std::uint32_t i) { return lineage.entries[i].fate == Fate::divided; });
  return order;
}

}  // namespace morula
