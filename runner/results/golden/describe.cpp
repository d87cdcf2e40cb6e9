// Describes a check report for people.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/cell_path.h"
#include "files/text.h"
#include "golden/check_result.h"
#include "golden/read_number.h"

namespace morula {
namespace {

std::string shareInWords(double share) {
  return share < 10 ? numberText(100 * share, 2) + " % of the tolerance used"
                    : numberText(share, 2) + " times the tolerance";
}

std::string oneLine(const CheckResult& r) {
  std::string line = r.check;
  if (r.tolerance != "exact") line += ": " + r.tolerance;
  if (!wasCompared(r)) line += ": " + r.actual;
  else if (r.passed) line += " (" + r.expected + ')';
  else line += std::string(": ") + nameOf(r.failureClass) + ", " + failedInWords(r);
  if (r.share) line += ", " + shareInWords(*r.share);
  if (r.share && *r.share > 0 && r.passed) {
    line += " by " + r.field;
    if (r.cell) line += " of " + cellName(*r.cell);
  }
  return line;
}

/// Returns the reason of a failed check: checks with the same text have one cause.
std::string reasonOf(const CheckResult& r) {
  if (r.kind == CheckKind::bullet) return nameOf(r.kind);
  if (r.kind != CheckKind::golden || r.check == "tolerances") return nameOf(r.kind) + (' ' + r.check);
  return nameOf(r.failureClass == FailureClass::chaos ? FailureClass::computation : r.failureClass);
}

/// Returns a check's rank as a cause: a changed scenario first, then the lineage, then the earliest step.
std::pair<int, std::uint64_t> rankOf(const CheckResult& r) {
  return {r.check == "scenario"  ? 0
          : r.check == "lineage" ? 1
                                 : 2,
          r.firstStep.value_or(std::numeric_limits<std::uint64_t>::max())};
}

/// Returns "values * from step 64 on: volume of cell AB 1.04 → 1.07".
std::string followingInWords(const CheckResult& r) {
  std::string text = r.check;
  if (r.firstStep) text += " from step " + std::to_string(*r.firstStep) + " on";
  const auto expected = readReal(r.expected), actual = readReal(r.actual);
  if (!expected || !actual || r.field == "hash") return text;
  if (r.field != "count") text += ": " + r.field + (r.cell ? " of " + cellName(*r.cell) : "");
  const bool isSmall = numberText(*expected, 3) == numberText(*actual, 3);
  const auto number = [&](double x) { return isSmall || x == std::round(x) ? exactText(x) : numberText(x, 3); };
  return text + ' ' + number(*expected) + " → " + number(*actual);
}

}  // namespace

std::string failedInWords(const CheckResult& failed) {
  if (failed.failureClass == FailureClass::unread) return meaningOf(failed.failureClass);
  if (failed.check == "orphan") return "this golden has no scenario";
  if (failed.check == "golden")
    return failed.failureClass == FailureClass::setup ? "the scenario has no golden" : "the golden cannot be used";
  if (failed.check == "run") return "the run failed";
  if (failed.kind == CheckKind::study) return failed.check;
  if (failed.kind != CheckKind::golden) return meaningOf(failed.kind);
  if (failed.check == "scenario") return "the scenario changed";
  return meaningOf(failed.failureClass);
}

std::vector<Cause> causesOf(const CheckReport& report) {
  std::vector<Cause> causes;
  std::map<std::string, std::size_t> places;
  for (const CheckResult& r : report.results) {
    if (r.passed) continue;
    const auto [place, isNew] = places.emplace(reasonOf(r), causes.size());
    if (isNew) causes.emplace_back();
    causes[place->second].push_back(&r);
  }
  for (Cause& cause : causes) {
    auto first = cause.begin();  // among equal ranks the last: values tell more than hashes
    for (auto i = cause.begin(); i != cause.end(); ++i)
      if (rankOf(**i) <= rankOf(**first)) first = i;
    std::rotate(cause.begin(), first, first + 1);
  }
  return causes;
}

std::string followingInWords(const Cause& cause) {
  std::string text;
  for (std::size_t i = 1; i < cause.size(); ++i) text += (i > 1 ? "; " : "") + followingInWords(*cause[i]);
  return text;
}

std::string describe(const CheckReport& report, bool differingOnly) {
  std::size_t failed = 0;
  for (const CheckResult& r : report.results) failed += r.passed ? 0 : 1;
  const std::string all = std::to_string(std::ranges::count_if(report.results, wasCompared));
  std::string text =
      report.scenario + ": " +
      (failed ? std::to_string(failed) + " of " + all + " checks differ" : "all " + all + " checks pass") + '\n';
  text += report.change;
  for (const Cause& cause : causesOf(report)) {
    text += "  FAIL  " + oneLine(*cause[0]) + '\n';
    for (const std::string& line : linesOf(cause[0]->message)) text += "        " + line + '\n';
    if (cause.size() > 1) text += "        consequences: " + followingInWords(cause) + '\n';
  }
  for (const CheckResult& r : report.results)
    if (r.passed && !(differingOnly && failed)) text += (wasCompared(r) ? "  ok    " : "  --    ") + oneLine(r) + '\n';
  return text;
}

}  // namespace morula
