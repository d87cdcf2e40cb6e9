#pragma once
// The tables of a world as it is now, with the columns of the database [observation/run_rows.h].
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "library/morula.h"
#include "observation/measures.h"

namespace morula {

/// Returns the table of this name, as Simulator::table. `nameOf`: names of cells; empty: none has a name. Throws
/// InputError for another name.
DataTable worldTable(const Observation& now, std::string_view name,
                     const std::function<std::optional<std::string>(const CellPath&)>& nameOf);

/// Returns a measure of all living cells, in their order; NaN where there is nothing to measure. `cells`: measureCells
/// of the observation. Throws InputError for the name of no measure of cells.
std::vector<double> worldColumn(const Observation& now, std::span<const CellMeasures> cells, std::string_view name);

}  // namespace morula
