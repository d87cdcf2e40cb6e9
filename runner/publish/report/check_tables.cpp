#include "report/check_tables.h"

#include <algorithm>

#include "base/number_text.h"
#include "files/text.h"

namespace morula {

namespace {

/// Where a check failed first, or what has used the most of its tolerance.
std::string placeOf(const CheckResult& r, const CellNames& names) {
  std::vector<std::string> parts;
  if (!r.passed && r.firstStep) parts.push_back("from step " + std::to_string(*r.firstStep) + " on");
  if (r.cell) parts.push_back(withNames(cellName(*r.cell), names.function()));
  if (!r.passed && r.field != "hash" && r.field != "count" && !r.field.empty()) parts.push_back(r.field);
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

std::vector<Cell> rowOf(const CheckResult& r, const CellNames& names) {
  const bool limit = r.tolerance == "exact" && (r.kind == "sanity" || r.kind == "invariant");
  return {r.check,
          r.kind,
          mark(r.passed, "passed", limit ? "failed" : "differs", r.passed ? "" : r.failureClass),
          limit ? "a limit" : r.tolerance,
          shareText(r.share),
          r.expected,
          r.actual,
          placeOf(r, names)};
}

struct ChangeLine {
  std::string heading, text;
};

/// "  moved     cell AB …": a heading of up to eight letters, then the text; a line without one belongs to that above.
std::vector<ChangeLine> linesOfChange(const std::string& change, const CellNames& names) {
  std::vector<ChangeLine> lines;
  for (const std::string& line : linesOf(withNames(change, names.function()))) {
    const auto begin = line.find_first_not_of(' ');
    if (begin == line.npos) continue;
    const auto gap = begin == 2 ? line.find("  ", begin) : line.npos;
    const auto text = begin == 2 ? line.find_first_not_of(' ', std::min(gap, line.size())) : begin;
    if (text == line.npos) lines.push_back({"", line.substr(begin)});
    else lines.push_back({begin == 2 ? line.substr(2, gap - 2) : "", line.substr(text)});
  }
  return lines;
}

std::string sentencePart(const ChangeLine& line) {
  if (line.heading == "changed") return line.text;
  if (line.heading == "lineage" && line.text == "the same") return "same lineage";
  std::string text = line.text;
  if (const auto at = text.find(" the farthest: "); line.heading == "moved" && at != text.npos)
    return text.replace(at, std::string(" the farthest: ").size(), " moved farthest, by ");
  return line.heading + ": " + text;
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
  if (!messages.empty()) all.heading("All that differs").add(std::move(messages));
  return all;
}

Table changeTable(const std::string& change, const CellNames& names) {
  Table table{"What changed", {}};
  for (const ChangeLine& line : linesOfChange(change, names))
    if (line.heading.empty() && !table.rows.empty())
      table.rows.back()[1].words += Words("", Emphasis::lineBreak) + line.text;
    else table.rows.push_back({line.heading, line.text});
  return table;
}

std::string changeSentence(const std::string& change, const CellNames& names) {
  std::string sentence;
  std::size_t more = 0;  // lines of the last heading that are left out
  const auto endHeading = [&] {
    if (more) sentence += " and " + std::to_string(more) + " more";
    more = 0;
  };
  for (const ChangeLine& line : linesOfChange(change, names)) {
    if (line.heading.empty()) {
      ++more;
      continue;
    }
    endHeading();
    sentence += (sentence.empty() ? "" : "; ") + sentencePart(line);
  }
  endHeading();
  return sentence;
}

}  // namespace morula
