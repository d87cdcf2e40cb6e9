#pragma once
// The state of a stored run (golden/result_state.h), and the sentence of verbs that only show it.
#include <string>
#include <vector>

#include "golden/result_state.h"
#include "store/records.h"
#include "store/store.h"
#include "system/json.h"

namespace morula {

struct RunState {
  ResultState state = ResultState::fine;
  std::string why = {};  // "overlap 0.31, allowed at most 0.2, cell AB"; the failure; "" where nothing is to be told
};

/// `checks`: those of the run. A run that was compared with nothing is fine if it is sane: that is told by `run` and
/// `check`.
RunState stateOf(const StoredRun& run, const std::vector<CheckResult>& checks);
RunState stateOf(Store& store, const StoredRun& run);

/// "run 0123456789abcdef (pair, seed 7) is not sane: overlap 0.31, …"; "" for a run that is fine.
std::string remarkOn(const StoredRun& run, const RunState& state);
std::string remarkOn(Store& store, const StoredRun& run);

/// Returns the state for `--json` of verbs that show runs: {"state": "not sane", "why": "…"}.
Json toJson(const RunState& state);

}  // namespace morula
