#pragma once
// The tree of cells in the Newick format, for programs that draw and compare trees.
#include <string>

#include "export/surfaces.h"

namespace morula {

/// Returns the tree in one line that ends in ';'. A branch is as long as the cell lived [time], at most to the run's
/// end; so is the egg's. Labels are names, or else paths ("egg"), in quotes if they hold more than letters, digits, '.'
/// and '-'. An NHX comment follows each label, with path, fate (divided, died, alive) and last substances:
/// "AB:1.5[&&NHX:path=AB:fate=died:state=a4 a5]". Start cells without a common mother have a root without label and
/// length. `comments`: false leaves the comments out, for programs that cannot read them.
std::string newickTree(const ExportedRun& run, bool comments = true);

}  // namespace morula
