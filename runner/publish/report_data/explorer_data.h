#pragma once
// The explorer's data: JSON and the frames' bytes, which reports/explorer/src/data.ts reads.
#include <string>
#include <vector>

#include "document/document.h"
#include "loop/simulate.h"
#include "page/page.h"
#include "report_data/frames.h"
#include "system/json.h"

namespace morula {

/// A run for the explorer.
struct ExplorerRun {
  std::string title;
  const Scenario* scenario;
  const std::vector<LineageEntry>* lineage;      // in the order of the numbers of cells in frames
  std::function<std::string(StateId)> describe;  // returns a state's substances
  double end = 0;                                // [time]
  const Frames* frames = nullptr;                // null: only the tree is shown
};

/// Max number of cells in the explorer's tree; of larger trees it shows the cells that were born first.
inline constexpr std::size_t maxTreeCells = 50'000;

/// Adds the colours of quantities, kinds and clones, as `scale`, `series` and `clones`.
void addPalette(Json& data);

/// Returns the page's `data`. Of run i, the bytes `frames-i` of explorerBytes are its frames and `cells-i` the JSON of its
/// cells, deflated, for trees of large organisms are long.
Json explorerData(const std::vector<ExplorerRun>& runs);
std::vector<PageBytes> explorerBytes(const std::vector<ExplorerRun>& runs);

/// Returns how many of the taken frames are on the page: "24 runs: 30 to 41 of 100 frames fit into the page"; "" if all
/// are.
std::string thinnedText(const std::vector<ExplorerRun>& runs);

/// Returns notes on omitted content, for below the explorer; empty if nothing was left out.
Document leftOutOf(const std::vector<ExplorerRun>& runs);

}  // namespace morula
