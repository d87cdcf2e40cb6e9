#pragma once
// The result of a check: one row of `check_result`, one entry of `morula check --json`.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/choice.h"
#include "base/record.h"

namespace morula {

enum class CheckKind { golden, bullet, invariant, sanity, study, claim };
template <>
inline constexpr auto choices<CheckKind> =
    std::to_array<Choice<CheckKind>>({{CheckKind::golden, "golden", "the result against the golden"},
                                      {CheckKind::bullet, "bullet", "Bullet's result differs"},
                                      {CheckKind::invariant, "invariant", "an invariant does not hold"},
                                      {CheckKind::sanity, "sanity", "the end of the run is not sane"},
                                      {CheckKind::study, "study", "the state of a study's runs"},
                                      {CheckKind::claim, "claim", "the results contradict the claim"}});

/// The class of a failure [golden/README.md]; the meaning says what differs.
enum class FailureClass {
  none,
  inputChanged,
  setup,
  lineage,
  computation,
  chaos,
  image,
  cost,
  record,
  nondeterminism,
  unread,
  claim,
  // The states of a study's runs:
  unfinished,
  missing,
  differs,
  insane,
  stale,
  failed,
  changed
};
template <>
inline constexpr auto choices<FailureClass> = std::to_array<Choice<FailureClass>>(
    {{FailureClass::none, "", "nothing differs"},
     {FailureClass::inputChanged, "INPUT_CHANGED", "the scenario or its golden changed"},
     {FailureClass::setup, "SETUP", "the initial state differs"},
     {FailureClass::lineage, "LINEAGE", "the lineage differs"},
     {FailureClass::computation, "COMPUTATION", "computed values differ"},
     {FailureClass::chaos, "CHAOS", "an error of one unit in the last place has grown"},
     {FailureClass::image, "IMAGE", "the picture differs"},
     {FailureClass::cost, "COST", "the cost differs"},
     {FailureClass::record, "RECORD", "recorded rows differ, but the state does not"},
     {FailureClass::nondeterminism, "NONDETERMINISM", "two runs give different bits"},
     {FailureClass::unread, "UNREAD", "the file cannot be read"},
     {FailureClass::claim, "CLAIM", "the results contradict the claim"},
     {FailureClass::unfinished, "UNFINISHED", "runs were killed, or are still running"},
     {FailureClass::missing, "MISSING", "runs are missing"},
     {FailureClass::differs, "DIFFERS", "results are not what was claimed"},
     {FailureClass::insane, "NOT_SANE", "runs ended in states that cannot be"},
     {FailureClass::stale, "STALE", "results were made from other inputs"},
     {FailureClass::failed, "FAILED", "runs failed"},
     {FailureClass::changed, "CHANGED", "rows do not match their digests"}});

struct CheckResult {
  std::string check = {};  // "lineage", "bits", "values final.*.volume", …
  CheckKind kind = {};
  std::string expected = {};  // the expected value at the worst or first difference; if passed, a summary
  std::string actual = {};
  std::string tolerance = "exact";  // or "rel 1e-9 scale 1"
  bool passed = true;
  // The place, as far as it applies:
  FailureClass failureClass = FailureClass::none;  // none when passed
  std::optional<std::uint64_t> firstStep = {};     // the first step at which run and golden differ
  std::optional<std::string> cell = {};            // its path; "" is the egg
  std::string field = {};                          // "pressure"
  // [1] The used share of the tolerance: 0 equal, 1 at its edge, perhaps ∞; absent if exact
  std::optional<double> share = {};
  std::string message = {};  // for people: all differences, in several lines; "" when passed
  friend bool operator==(const CheckResult&, const CheckResult&) = default;
};

template <IsA<CheckResult> T>
void listFields(T& r, auto&& field) {
  auto& [check, kind, expected, actual, tolerance, passed, failureClass, firstStep, cell, at, share, message] = r;
  field({.name = "check", .anyCharacters = true}, check);
  field({"kind"}, kind);
  field({.name = "expected", .anyCharacters = true}, expected);
  field({.name = "actual", .anyCharacters = true}, actual);
  field({.name = "tolerance", .anyCharacters = true}, tolerance);
  field({"passed"}, passed);
  field({"class", "'' when passed"}, failureClass);
  field({"first_step"}, firstStep);
  field({.name = "cell", .anyCharacters = true}, cell);
  field({.name = "field", .anyCharacters = true}, at);
  field({"share_of_tolerance"}, share);
  field({.name = "message", .anyCharacters = true}, message);
}

/// Returns `result` as passed, or as failed with this class and with `message` for people.
inline CheckResult judged(CheckResult result, bool passed, const std::string& message,
                          FailureClass failureClass = FailureClass::computation) {
  result.passed = passed;
  if (passed) return result;
  result.failureClass = failureClass;
  result.message = message;
  return result;
}

/// The beginning of `actual` where a golden holds nothing to compare a result with, or the run has not made it.
inline constexpr std::string_view notCompared = "not compared: ";

/// Returns false for a picture not drawn, or drawn by another renderer, and for tables that a golden lacks.
inline bool wasCompared(const CheckResult& r) { return !r.actual.starts_with(notCompared); }

/// Returns a failed check for a golden and a run that could not even be compared.
inline CheckResult failedCheck(const std::string& check, FailureClass failureClass, const std::string& expected,
                               const std::string& actual, const std::string& message) {
  return judged({.check = check, .kind = CheckKind::golden, .expected = expected, .actual = actual}, false, message,
                failureClass);
}

struct CheckReport {
  std::string scenario;  // "thesis/unique-four"
  std::vector<CheckResult> results;
  std::string change = {};  // for people: the differences from the golden, in words; "" if there are none
  std::string file = {};    // the scenario's file, if the name alone does not lead to it
  std::string state = {};   // the hash of the run's end state; "" if there is none

  bool passed() const {
    for (const CheckResult& r : results)
      if (!r.passed) return false;
    return true;
  }
};

/// Describes a failed check in words: "the lineage differs". An unknown class is returned unchanged.
std::string failedInWords(const CheckResult& failed);

/// Failed checks with a common cause: first the check that shows the cause, then those that only follow from it, as
/// changed bits follow from a changed key.
using Cause = std::vector<const CheckResult*>;
/// Returns the causes of all failed checks, in the order of their first checks.
std::vector<Cause> causesOf(const CheckReport& report);
/// Lists in one line the results that follow from a cause: "bits; step_hashes from step 0 on; costs 518 → 502"; "" if
/// there are none.
std::string followingInWords(const Cause& cause);

/// Describes a report for people: the changes in words, an entry with the differences of each cause, and a line for
/// each passed check. `differingOnly`: leaves out the passed checks.
std::string describe(const CheckReport& report, bool differingOnly = false);

}  // namespace morula
