#pragma once
// The blocks of a page that say what runs look like and where they come from.
#include <string>

#include "check/beside_golden.h"
#include "document/document.h"
#include "page/page.h"
#include "report_data/run_facts.h"
#include "report_data/words.h"

namespace morula {

/// How runs differ from their goldens, and those of one scenario from the first of them; empty where there is nothing
/// to hold them against.
Document changesOf(const std::vector<RunFacts>& runs);
/// The organism at the end and the tree of its cells, of each run that was run again; of others the tree alone. The
/// first two organisms of one scenario lie over each other, seen by one camera, to be swiped and blinked between where
/// programs run.
PageSection pictureSection(const std::vector<RunFacts>& runs);
/// Cells and measures over time, all runs in one chart, at most the first 24; of one run also who touches whom and
/// which way cells divided.
PageSection chartSection(const std::vector<RunFacts>& runs);
/// Shows the origins of runs side by side, with their differences marked.
PageSection provenanceSection(const std::vector<RunFacts>& runs);
/// The scenarios as they were read, and with all defaults filled in.
PageSection parameterSection(const std::vector<RunFacts>& runs);
/// Tables and trees as links that hold them; what is larger than `maxBytes` is named, and the commands write all of it.
PageSection downloadSection(const std::vector<RunFacts>& runs, std::size_t maxBytes);

/// The three pictures, or the only one that there is, and what is to be known of them. Where programs run, golden and
/// now lie over each other, too, to be swiped and blinked between. `name`: of what.
Document goldenPictures(const BesideGolden& beside, const std::string& name);

/// Why the run cannot be made again in a page; "" where it can.
std::string whyNoRerun(const RunFacts& run);
/// The simulator and the scene in the page, what the run gave, and the place for the button.
PageSection rerunSection(const RunFacts& run);

/// `module`: the simulator, gzipped. reports/explorer/src/rerun/panel.ts reads these.
std::vector<PageBytes> rerunBytes(const RunFacts& run, const std::string& module);

/// All checks with their shares of the tolerances, those that failed first and with all that differs.
Document checksOf(const std::vector<CheckResult>& checks, const CellNames& names);

/// A share of a tolerance: in per cent, beyond ten times the tolerance as a multiple; "" where there is none.
std::string shareText(const std::optional<double>& share);

/// The lines of `change`, which changeInWords (golden/change.h) has made.
Table changeTable(const std::string& change, const CellNames& names);

}  // namespace morula
