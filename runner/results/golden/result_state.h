#pragma once
// The list of the states of a result. Every verb that judges or shows results takes the names and exit codes of states
// from this list. The table of verbs and states is in golden/README.md.
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/choice.h"
#include "golden/check_result.h"
#include "system/exit_codes.h"
#include "system/json.h"

namespace morula {

/// The states, from the best to the worst. The state of several results is their worst one (worstOf).
enum class ResultState { fine, unchecked, unfinished, missing, differs, insane, stale, failed, unread, changed };
template <>
inline constexpr auto choices<ResultState> = std::to_array<Choice<ResultState>>(
    {{ResultState::fine, "fine", "the run came to its end, is sane, and passes all comparisons"},
     {ResultState::unchecked, "unchecked", "the run has nothing to be compared with"},
     {ResultState::unfinished, "unfinished", "the run was killed, or is still running"},
     {ResultState::missing, "missing", "a result is expected, but does not exist"},
     {ResultState::differs, "differs", "the result differs from the accepted one, or contradicts a claim"},
     {ResultState::insane, "not sane", "the run ended in a state that is not possible"},
     {ResultState::stale, "stale", "the result was made from other inputs than the present ones"},
     {ResultState::failed, "failed", "the run could not continue"},
     {ResultState::unread, "unread", "the file could not be read"},
     {ResultState::changed, "changed", "the rows of the result do not match their digest"}});

/// Returns true for a result that is fine or unchecked. Verbs report unchecked results, but not as errors.
inline bool isAcceptable(ResultState state) { return state <= ResultState::unchecked; }

ResultState worstOf(std::span<const ResultState> states);

/// Returns the exit code of a verb that judges several results or a stored one.
cli::ExitCode exitCodeOf(ResultState state);
/// Returns the exit code of the verb `run`: 4, the code of a NumericalError, for a failed run; else as exitCodeOf.
cli::ExitCode exitCodeOfRun(ResultState state);

/// Returns the worst state of the failed checks: differs, insane, failed or unread. Returns fine if all checks passed,
/// and unchecked if there are none.
ResultState stateOf(const CheckReport& report);
ResultState stateOf(const std::vector<CheckResult>& checks);

/// Returns a failed sanity check in one line: "overlap 0.31, allowed at most 0.2, cell AB".
std::string shortReason(const CheckResult& insane);
/// Returns all failed sanity checks, separated by "; "; "" if all passed.
std::string whyInsane(const std::vector<CheckResult>& checks);

/// The max numbers of failed and insane runs in a study.
struct AllowedRuns {
  std::size_t failed = 0, insane = 0;
  friend bool operator==(const AllowedRuns&, const AllowedRuns&) = default;
};

/// The number of results in each state.
class StateCounts {
 public:
  void add(ResultState state, std::size_t count = 1) { counts_[static_cast<std::size_t>(state)] += count; }
  std::size_t of(ResultState state) const { return counts_[static_cast<std::size_t>(state)]; }
  std::size_t all() const;
  /// Returns the worst state. Failed and insane results count only if there are more than `allowed`.
  ResultState worst(const AllowedRuns& allowed = {}) const;
  /// Returns the states that occur: "18 fine, 1 not sane, 1 failed".
  std::string text() const;
  /// Returns all states: {"fine": 18, "not_sane": 1, …}.
  Json json() const;

 private:
  std::array<std::size_t, choices<ResultState>.size()> counts_{};
};

/// Returns the checks of a study for continuous integration: one for each state that is not acceptable and that occurs
/// in `counts` or has a max above 0 in `allowed`. `why`: for each state, a text for people that names its runs.
std::vector<CheckResult> checksOf(const StateCounts& counts, const AllowedRuns& allowed,
                                  const std::array<std::string, choices<ResultState>.size()>& why);

}  // namespace morula
