#pragma once
// A page that runs again: the simulator and the scene in it, what the run gave, and the place for the button.
#include "document/document.h"
#include "page/page.h"
#include "report_data/run_facts.h"

namespace morula {

/// Why the run cannot be made again in a page; "" where it can.
std::string whyNoRerun(const RunFacts& run);

PageSection rerunSection(const RunFacts& run);

/// `module`: the simulator, gzipped. reports/explorer/src/rerun/panel.ts reads these.
std::vector<PageBytes> rerunBytes(const RunFacts& run, const std::string& module);

}  // namespace morula
