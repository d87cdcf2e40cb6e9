#pragma once
// The explorer's data: JSON, and the frames' bytes beside it. reports/explorer/src/data.ts reads them.
#include <string>
#include <vector>

#include "document/document.h"
#include "loop/simulate.h"
#include "page/page.h"
#include "report_data/frames.h"
#include "system/json.h"

namespace morula {

/// One run as it can be explored.
struct ExplorerRun {
  std::string title;
  const Scenario* scenario;
  const std::vector<LineageEntry>* lineage;      // in the order that frames count cells
  std::function<std::string(StateId)> describe;  // a state's substances
  double end = 0;                                // [time]
  const Frames* frames = nullptr;                // null: nothing but the tree
};

/// Cells of a tree that the explorer shows at most; of larger ones those that were born first.
inline constexpr std::size_t maxTreeCells = 20000;

/// The colours of quantities, kinds and clones, as `scale`, `series` and `clones`.
void addPalette(Json& data);

/// The page's `data`. Frames of run number i are in the bytes `frames-i`.
Json explorerData(const std::vector<ExplorerRun>& runs);
std::vector<PageBytes> explorerBytes(const std::vector<ExplorerRun>& runs);

/// How many frames are in the page of those that were taken: "24 runs: 30 to 41 of 100 frames fit into the page"; "" if
/// all.
std::string thinnedText(const std::vector<ExplorerRun>& runs);

/// Tells below the explorer what was left out; empty if nothing was.
Document leftOutOf(const std::vector<ExplorerRun>& runs);

}  // namespace morula
