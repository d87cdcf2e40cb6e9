#pragma once
// Conditions that end a run (StopParameters::when).
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/choice.h"
#include "base/members.h"
#include "biology/cell_selection.h"

namespace morula {

enum class StopEvent { touch, part, born, cells, measure, rest };
template <>
inline constexpr auto choices<StopEvent> = std::to_array<Choice<StopEvent>>({
    {StopEvent::touch, "touch", "a cell of the first kind touches one of the second"},
    {StopEvent::part, "part", "cells of both kinds live, and none of the first touches one of the second"},
    {StopEvent::born, "born", "such a cell lives"},
    {StopEvent::cells, "cells", "so many cells live, of the cells in `of`"},
    {StopEvent::measure, "measure", "a measure is above or below a bound; of cells, that of any of them"},
    {StopEvent::rest, "rest",
     "all cells rest: after time 0, each cell's root mean square speed [length/time] is below "
     "this one"},
});

/// A condition ends a run. The run looks at it after each event, and each StopParameters::every.
struct StopWhen {
  StopEvent event = StopEvent::touch;
  std::vector<CellSelection> of{};         // two of touch and part, one of born, one or none (all cells) of cells
  double count = 0;                        // of cells
  std::string measure{};                   // as AskedMeasure::name
  std::optional<double> above{}, below{};  // bounds of the measure, in its unit, one at least; of rest a speed below
  double after = 0;                        // [time] the condition does not count before
};
MORULA_MEMBERS(StopWhen, event, of, count, measure, above, below, after)

/// Returns true for conditions that genes alone may not decide.
inline bool needsBodies(const StopWhen& when) {
  return when.event != StopEvent::born && when.event != StopEvent::cells;
}

}  // namespace morula
