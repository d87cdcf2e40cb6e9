#include "store/run_state.h"

#include "files/text.h"

namespace morula {

RunState stateOf(const StoredRun& run, const std::vector<CheckResult>& checks) {
  if (run.status == RunStatus::failed) return {ResultState::failed, firstLine(run.failure)};
  if (run.status != RunStatus::done)
    return {ResultState::unfinished,
            run.status == RunStatus::killed ? "a signal stopped the run" : "the run is still running, or was killed"};
  if (std::string why = whyInsane(checks); !why.empty()) return {ResultState::insane, std::move(why)};
  for (const CheckResult& r : checks)
    if (!r.passed) return {ResultState::differs, r.check + ": " + firstLine(r.message)};
  return {};
}

RunState stateOf(Store& store, const StoredRun& run) { return stateOf(run, store.checks(run.id)); }

std::string remarkOn(const StoredRun& run, const RunState& state) {
  if (isAcceptable(state.state)) return "";
  const std::string who =
      "run " + run.id + " (" + run.record.scenario + ", seed " + std::to_string(run.record.seed) + ")";
  const std::string verb = state.state == ResultState::failed || state.state == ResultState::differs ? " " : " is ";
  return who + verb + nameOf(state.state) + ": " + state.why;
}

std::string remarkOn(Store& store, const StoredRun& run) { return remarkOn(run, stateOf(store, run)); }

Json toJson(const RunState& state) {
  return {{"state", nameOf(state.state)}, {"why", state.why.empty() ? Json() : Json(state.why)}};
}

}  // namespace morula
