#pragma once
// The blocks of a page that say where runs come from and what they look like.
#include "page/page.h"
#include "report/words.h"

namespace morula {

/// The organism at the end and the tree of its cells, of each run that was run again; of others the tree alone. Of two
/// runs or more the first two organisms lie over each other, to be swiped and blinked between where programs run.
PageBlock pictureBlock(const std::vector<RunFacts>& runs);
/// Cells and sampled measures of the organism over time, all runs in one chart; at most the first 24 runs.
PageBlock chartBlock(const std::vector<RunFacts>& runs);
/// Where the runs come from, side by side; what they differ in is marked.
PageBlock provenanceBlock(const std::vector<RunFacts>& runs);
/// The scenarios as they were read, and with all defaults filled in.
PageBlock parameterBlock(const std::vector<RunFacts>& runs);
/// Tables and trees as links that hold them; what is larger than `mostBytes` is named with the command that writes it.
PageBlock downloadBlock(const std::vector<RunFacts>& runs, std::size_t mostBytes);

}  // namespace morula
