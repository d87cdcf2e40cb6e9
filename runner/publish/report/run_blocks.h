#pragma once
// The blocks of a page on the looks and the origins of runs.
#include <string>

#include "check/beside_golden.h"
#include "document/document.h"
#include "page/page.h"
#include "report_data/run_facts.h"
#include "report_data/run_words.h"
#include "system/json.h"

namespace morula {

/// Tells the differences of runs from their goldens, and of runs of one scenario from the first; empty if there is
/// nothing to compare with.
Document changesOf(const std::vector<RunFacts>& runs);
/// Shows the organism at the end and the tree of cells of each run that was simulated again; of others only the tree.
/// The first two organisms of one scenario have one camera and lie over each other, to be swiped and blinked between
/// where programs run.
PageSection pictureSection(const std::vector<RunFacts>& runs);
/// Shows cells and measures over time, at most the first 24 runs in one chart; of one run also its contacts and the
/// directions of its divisions. Adds the lines of charts to `live`, by the ids of their pictures: x axis, y axis, lines
/// [label, colour, whether dashed, x, y].
PageSection chartSection(const std::vector<RunFacts>& runs, Json& live);
/// Shows the origins of runs side by side, with their differences marked.
PageSection provenanceSection(const std::vector<RunFacts>& runs);
/// Shows the scenarios as they were read, and with all defaults filled in.
PageSection parameterSection(const std::vector<RunFacts>& runs);
/// Shows tables and trees as links that hold them. A table over `maxBytes` is only named; the commands write all of it.
PageSection downloadSection(const std::vector<RunFacts>& runs, std::size_t maxBytes);

/// Shows the three pictures, or the only one, with remarks. Where programs run, the golden's and the present organism
/// also lie over each other, to be swiped and blinked between. `name`: of the subject.
Document goldenPictures(const BesideGolden& beside, const std::string& name);

/// Returns the reason why a page cannot repeat the run; "" if it can.
std::string whyNoRerun(const RunFacts& run);
/// The simulator and the scene in the page, what the run gave, and the place for the button.
PageSection rerunSection(const RunFacts& run);

/// Returns the bytes for the repetition, read by reports/explorer/src/rerun/panel.ts. `module`: the simulator, gzipped.
std::vector<PageBytes> rerunBytes(const RunFacts& run, const std::string& module);

/// Shows all checks with their shares of the tolerances; failed checks come first, with all differences.
Document checksOf(const std::vector<CheckResult>& checks, const CellNames& names);

/// Returns a share of a tolerance in per cent, beyond ten times the tolerance as a multiple; "" if absent.
std::string shareText(const std::optional<double>& share);

/// Returns the lines of `change`, a text of changeInWords (golden/change.h), as a table.
Table changeTable(const std::string& change, const CellNames& names);

}  // namespace morula
