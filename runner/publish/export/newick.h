#pragma once
// The tree of cells in the Newick format, for programs that draw and compare trees.
#include <string>

#include "export/surfaces.h"

namespace morula {

/// One line, which ends in ';'. A branch is as long as the cell lived [time], up to the run's end; the egg's too.
/// Labels are names, or else paths ("egg"), in quotes where they hold more than letters, digits, '.' and '-'. Behind
/// each a comment in NHX: path, fate (divided, died, alive) and last substances:
/// "AB:1.5[&&NHX:path=AB:fate=died:state=a4 a5]". Start cells without a common mother hang on a root without label and
/// length. `comments`: false leaves the comments out, for programs that cannot read them.
std::string newickTree(const ExportedRun& run, bool comments = true);

}  // namespace morula
