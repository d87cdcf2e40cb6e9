// A report for people.
#include "base/cell_path.h"
#include "files/text.h"
#include "golden/check_result.h"
#include "golden/number_text.h"

namespace morula {

namespace {

std::string inPercent(double share) {
  if (share == 0) return "0 %";
  char text[32];
  return std::string(
             text, std::to_chars(text, text + sizeof text, 100 * share, std::chars_format::general, 2).ptr) +
         " %";
}

std::string oneLine(const CheckResult& r) {
  std::string line = r.check;
  if (r.tolerance != "exact") line += ": " + r.tolerance;
  if (r.passed) line += " (" + r.expected + ')';
  else line += ": " + r.failureClass;
  if (r.share) line += ", " + inPercent(*r.share) + " of the tolerance used";
  if (r.share && *r.share > 0 && r.passed) {
    line += " by " + r.field;
    if (r.cell) line += " of " + cellName(*r.cell);
  }
  return line;
}

}  // namespace

std::string describe(const CheckReport& report) {
  std::size_t failed = 0;
  for (const CheckResult& r : report.results) failed += r.passed ? 0 : 1;
  const std::string all = std::to_string(report.results.size());
  std::string text =
      report.scenario + ": " +
      (failed ? std::to_string(failed) + " of " + all + " checks differ" : "all " + all + " checks pass") +
      '\n';
  text += report.change;
  for (const CheckResult& r : report.results) {
    text += (r.passed ? "  ok    " : "  FAIL  ") + oneLine(r) + '\n';
    for (const std::string& line : linesOf(r.message)) text += "        " + line + '\n';
  }
  return text;
}

}  // namespace morula
