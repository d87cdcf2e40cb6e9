#include "golden/result_state.h"

#include <algorithm>

#include "base/cell_path.h"
#include "base/error.h"
#include "base/number_text.h"
#include "files/text.h"
#include "golden/read_number.h"

namespace morula {
namespace {

/// Returns how many results may be in the state.
std::size_t allowedOf(ResultState state, const AllowedRuns& allowed) {
  return state == ResultState::failed ? allowed.failed : state == ResultState::insane ? allowed.insane : 0;
}

/// Returns the failure class of a state of a study's runs.
FailureClass classOf(ResultState state) {
  switch (state) {
    case ResultState::fine:
    case ResultState::unchecked: return FailureClass::none;
    case ResultState::unfinished: return FailureClass::unfinished;
    case ResultState::missing: return FailureClass::missing;
    case ResultState::differs: return FailureClass::differs;
    case ResultState::insane: return FailureClass::insane;
    case ResultState::stale: return FailureClass::stale;
    case ResultState::failed: return FailureClass::failed;
    case ResultState::unread: return FailureClass::unread;
    case ResultState::changed: return FailureClass::changed;
  }
  MORULA_CHECK(false, "every state has a failure class");
}

/// Returns true for a golden or a scenario that could not be read.
bool isUnusable(const CheckResult& r) {
  return (r.check == "golden" && r.failureClass == FailureClass::inputChanged) ||
         r.failureClass == FailureClass::unread;
}

/// Returns a number in four digits; another text unchanged.
std::string inFourDigits(const std::string& text) {
  const auto number = readReal(text);
  return number ? numberText(*number) : text;
}

}  // namespace

ResultState worstOf(std::span<const ResultState> states) {
  return states.empty() ? ResultState::fine : std::ranges::max(states);
}

cli::ExitCode exitCodeOf(ResultState state) {
  switch (state) {
    case ResultState::fine:
    case ResultState::unchecked: return cli::fine;
    case ResultState::unfinished:
    case ResultState::missing: return cli::incomplete;
    case ResultState::differs:
    case ResultState::insane:
    case ResultState::stale:
    case ResultState::failed: return cli::differs;
    case ResultState::unread: return cli::input;
    case ResultState::changed: return cli::file;
  }
  MORULA_CHECK(false, "every state has an exit code");
}

cli::ExitCode exitCodeOfRun(ResultState state) {
  return state == ResultState::failed ? cli::numerical : exitCodeOf(state);
}

ResultState stateOf(const std::vector<CheckResult>& checks) {
  ResultState worst = checks.empty() ? ResultState::unchecked : ResultState::fine;
  for (const CheckResult& r : checks)
    if (!r.passed)
      worst = std::max(worst, r.kind == CheckKind::sanity ? ResultState::insane
                              : r.check == "run"          ? ResultState::failed
                              : isUnusable(r)             ? ResultState::unread
                                                          : ResultState::differs);
  return worst;
}

ResultState stateOf(const CheckReport& report) { return stateOf(report.results); }

std::string shortReason(const CheckResult& r) {
  return r.field + ' ' + inFourDigits(r.actual) + ", allowed " + r.expected +
         (r.cell ? ", cell " + (r.cell->empty() ? "egg" : *r.cell) : "");
}

std::string whyInsane(const std::vector<CheckResult>& checks) {
  std::vector<std::string> reasons;
  for (const CheckResult& r : checks)
    if (r.kind == CheckKind::sanity && !r.passed) reasons.push_back(shortReason(r));
  return join(reasons, "; ");
}

std::size_t StateCounts::all() const {
  std::size_t sum = 0;
  for (const std::size_t count : counts_) sum += count;
  return sum;
}

ResultState StateCounts::worst(const AllowedRuns& allowed) const {
  ResultState worst = ResultState::fine;
  for (const ResultState state : valuesOf<ResultState>())
    if (of(state) > allowedOf(state, allowed)) worst = std::max(worst, state);
  return worst;
}

std::string StateCounts::text() const {
  std::vector<std::string> parts;
  for (const ResultState state : valuesOf<ResultState>())
    if (of(state) > 0) parts.push_back(std::to_string(of(state)) + ' ' + nameOf(state));
  return join(parts);
}

Json StateCounts::json() const {
  Json json = Json::object();
  for (const ResultState state : valuesOf<ResultState>()) {
    std::string key = nameOf(state);
    std::ranges::replace(key, ' ', '_');
    json[key] = of(state);
  }
  return json;
}

std::vector<CheckResult> checksOf(const StateCounts& counts, const AllowedRuns& allowed,
                                  const std::array<std::string, choices<ResultState>.size()>& why) {
  std::vector<CheckResult> checks;
  for (const ResultState state : valuesOf<ResultState>()) {
    const std::size_t most = allowedOf(state, allowed), count = counts.of(state);
    if (isAcceptable(state) || (count == 0 && most == 0)) continue;
    checks.push_back(judged({.check = std::string("runs ") + nameOf(state),
                             .kind = CheckKind::study,
                             .expected = "at most " + std::to_string(most),
                             .actual = std::to_string(count)},
                            count <= most, why[static_cast<std::size_t>(state)], classOf(state)));
  }
  return checks;
}

}  // namespace morula
