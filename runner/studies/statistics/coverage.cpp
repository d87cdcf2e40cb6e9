#include "statistics/coverage.h"

#include <array>

namespace morula {
namespace {

constexpr std::array table{
    Coverage{2, 95, 91, 89, 65},  Coverage{3, 95, 88, 84, 29},  Coverage{5, 95, 89, 83, 41},
    Coverage{10, 95, 91, 86, 65}, Coverage{20, 95, 94, 90, 87}, Coverage{50, 95, 95, 93, 99},
};

}  // namespace

std::optional<Coverage> coverageOf(std::size_t n) {
  std::optional<Coverage> found;
  for (const Coverage& row : table)
    if (row.n <= n) found = row;
  return found;
}

}  // namespace morula
