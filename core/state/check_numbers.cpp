
#include "state/check_numbers.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "state/state_fields.h"

namespace morula {

void checkNumbers(const World& world, std::size_t cell, const char* field, std::span<const double> values) {
  if (std::ranges::all_of(values, [](double x) { return std::isfinite(x); })) return;
  throw NumericalError(world.cells.path[cell].text(), world.clock.step, "its " + std::string(field) + " is not finite",
                       "speeds, masses or forces are too large for numbers: lower cells: velocity, "
                       "physics.cell.mass or stiffnesses");
}

void checkNumbers(const World& world) {
  for (std::size_t cell = 0; cell < world.cells.path.size(); ++cell)
    visitBody(*world.bodies, world.bodies->slots[cell], [&](const Field& field, const auto& value) {
      if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>)
        checkNumbers(world, cell, field.name, {&value, 1});
      else checkNumbers(world, cell, field.name, value);
    });
}

}  // namespace morula
