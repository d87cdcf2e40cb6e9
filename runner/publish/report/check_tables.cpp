#include <algorithm>

#include "base/number_text.h"
#include "files/text.h"
#include "golden/change.h"
#include "report/run_blocks.h"

namespace morula {
namespace {

/// Returns the first place at which a check failed, or the value that has used the most of its tolerance.
std::string placeOf(const CheckResult& r, const CellNames& names) {
  std::vector<std::string> parts;
  if (!r.passed && r.firstStep) parts.push_back("from step " + std::to_string(*r.firstStep) + " on");
  if (r.cell) parts.push_back(withNames(cellName(*r.cell), names.function()));
  if (!r.passed && r.field != "hash" && r.field != "count" && !r.field.empty()) parts.push_back(r.field);
  return join(parts);
}

std::vector<Cell> rowOf(const CheckResult& r, const CellNames& names) {
  const bool limit = r.tolerance == "exact" && (r.kind == CheckKind::sanity || r.kind == CheckKind::invariant);
  return {r.check,
          nameOf(r.kind),
          mark(r.passed, "passed", limit ? "failed" : "differs", r.passed ? "" : nameOf(r.failureClass)),
          limit ? "a limit" : r.tolerance,
          shareText(r.share),
          r.expected,
          r.actual,
          placeOf(r, names)};
}

}  // namespace

std::string shareText(const std::optional<double>& share) {
  if (!share) return "";
  if (*share == 0) return "0 %";
  if (*share < 1e-4) return "below\u00a00.01\u00a0%";
  return *share < 10 ? numberText(100 * *share, 3) + " %" : numberText(*share, 3) + " times";
}

Document checksOf(const std::vector<CheckResult>& checks, const CellNames& names) {
  Table table{"Checks", {"Check", "Kind", "Result", "Tolerance", "Share used", "Expected", "Found", "Where"}};
  Document messages;
  for (const bool passed : {false, true})
    for (const CheckResult& r : checks)
      if (r.passed == passed) table.rows.push_back(rowOf(r, names));
  for (const CheckResult& r : checks)
    if (!r.passed && !r.message.empty())
      messages.add(folded(r.check, Document().add(Verbatim{withNames(r.message, names.function())})));
  Document all;
  all.add(std::move(table));
  if (!messages.empty()) all.heading("All differences").add(std::move(messages));
  return all;
}

Table changeTable(const std::string& change, const CellNames& names) {
  Table table{"What changed", {}};
  for (const ChangeLine& line : linesOfChange(withNames(change, names.function())))
    if (line.heading.empty() && !table.rows.empty())
      table.rows.back()[1].words += Words("", Emphasis::lineBreak) + line.text;
    else table.rows.push_back({line.heading, line.text});
  return table;
}

}  // namespace morula
