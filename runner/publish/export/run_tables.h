#pragma once
// The tables that stand beside files of surfaces, to which their numbers refer.
#include <string>

#include "export/surfaces.h"

namespace morula {

/// A row for each cell that ever was: cell (from 0, by path), path, name, born, ended, fate, state.
std::string cellTable(const ExportedRun& run);
/// A row for each state: state (from 0), substances, colour (#rrggbb).
std::string stateTable(const ExportedRun& run);

}  // namespace morula
