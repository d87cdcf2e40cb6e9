#pragma once
// The state of a stored run (golden/result_state.h), and its sentence in verbs that only show the run.
#include <string>
#include <vector>

#include "golden/result_state.h"
#include "store/records.h"
#include "store/store.h"
#include "system/json.h"

namespace morula {

struct RunState {
  ResultState state = ResultState::fine;
  std::string why = {};  // the reason: "overlap 0.31, allowed at most 0.2, cell AB", or the failure; perhaps ""
};

/// Returns the state of a run. `checks`: the run's checks. A sane run that was compared with nothing counts as fine,
/// since `run` and `check` tell that it was not compared.
RunState stateOf(const StoredRun& run, const std::vector<CheckResult>& checks);
RunState stateOf(Store& store, const StoredRun& run);

/// Returns "run 0123456789abcdef (pair, seed 7) is not sane: overlap 0.31, …"; "" for an acceptable run.
std::string remarkOn(const StoredRun& run, const RunState& state);
std::string remarkOn(Store& store, const StoredRun& run);

/// Returns the state for `--json` of verbs that show runs: {"state": "not sane", "why": "…"}.
Json toJson(const RunState& state);

}  // namespace morula
