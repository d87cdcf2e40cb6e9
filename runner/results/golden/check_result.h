#pragma once
// The result of a check: one row of `check_result`, one entry of `morula check --json`.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/record.h"

namespace morula {

struct CheckResult {
  std::string check = {};     // "lineage", "bits", "values final.*.volume", …
  std::string kind = {};      // "golden", "bullet", "invariant", "sanity"
  std::string expected = {};  // of the worst or first difference; of the whole when passed
  std::string actual = {};
  std::string tolerance = "exact";  // or "rel 1e-9 scale 1"
  bool passed = true;
  // The place, as far as it applies:
  // "" when passed; INPUT_CHANGED, SETUP, COMPUTATION, LINEAGE, NONDETERMINISM, … (golden/README.md)
  std::string failureClass = {};
  std::optional<std::uint64_t> firstStep = {};  // the first step at which it differs
  std::optional<std::string> cell = {};         // its path; "" is the egg
  std::string field = {};                       // "pressure"
  // [1] of the tolerance used: 0 equal, 1 at its edge, perhaps ∞; absent if exact
  std::optional<double> share = {};
  std::string message = {};  // for people: all that differs, several lines; "" when passed
  friend bool operator==(const CheckResult&, const CheckResult&) = default;
};

template <IsA<CheckResult> T>
void listFields(T& r, auto&& field) {
  auto& [check, kind, expected, actual, tolerance, passed, failureClass, firstStep, cell, at, share, message] = r;
  field({.name = "check", .anyCharacters = true}, check);
  field({.name = "kind", .oneOf = "golden bullet invariant sanity"}, kind);
  field({.name = "expected", .anyCharacters = true}, expected);
  field({.name = "actual", .anyCharacters = true}, actual);
  field({.name = "tolerance", .anyCharacters = true}, tolerance);
  field({"passed"}, passed);
  field({.name = "class", .meaning = "'' when passed", .anyCharacters = true}, failureClass);
  field({"first_step"}, firstStep);
  field({.name = "cell", .anyCharacters = true}, cell);
  field({.name = "field", .anyCharacters = true}, at);
  field({"share_of_tolerance"}, share);
  field({.name = "message", .anyCharacters = true}, message);
}

/// `result` as one that passed, or as one that failed: of this class, and with `message` for people.
inline CheckResult judged(CheckResult result, bool passed, const std::string& message,
                          const std::string& failureClass = "COMPUTATION") {
  result.passed = passed;
  if (passed) return result;
  result.failureClass = failureClass;
  result.message = message;
  return result;
}

/// False of a picture that was not drawn, or by another renderer, and of tables that an old golden does not hold.
inline bool wasCompared(const CheckResult& r) {
  return (r.check != "images" && r.check != "tables") || !r.actual.ends_with("not compared");
}

/// A check that failed as a whole, for it could not even compare.
inline CheckResult failedCheck(const std::string& check, const std::string& failureClass, const std::string& expected,
                               const std::string& actual, const std::string& message) {
  return judged({.check = check, .kind = "golden", .expected = expected, .actual = actual}, false, message,
                failureClass);
}

struct CheckReport {
  std::string scenario;  // "thesis/unique-four"
  std::vector<CheckResult> results;
  std::string change = {};  // for people: how the result differs from the golden, in words; "" if it does not
  std::string file = {};    // the scenario's, where its name alone does not lead there
  std::string state = {};   // the hash of the run's end; "" where there is none

  bool passed() const {
    for (const CheckResult& r : results)
      if (!r.passed) return false;
    return true;
  }
};

/// Describes a failed check in words: "the lineage differs". Unknown classes stand as they are.
std::string failedInWords(const CheckResult& failed);

/// Failed checks that have one reason: first the one that tells it, then those that only follow from it, as bits do
/// from a changed key.
using Cause = std::vector<const CheckResult*>;
/// In the order of their first checks.
std::vector<Cause> causesOf(const CheckReport& report);
/// Lists the results that follow from a cause, in a line: "bits; step_hashes from step 0 on; costs 518 → 502"; "" if
/// there are none.
std::string followingInWords(const Cause& cause);

/// Describes a report for people: the changes in words, one entry per cause with what differs, and one line per check
/// that passed, unless only differences are wanted.
std::string describe(const CheckReport& report, bool differingOnly = false);

}  // namespace morula
