#include "golden/ci_reports.h"

#include <algorithm>

#include "document/table.h"
#include "files/content.h"
#include "files/printable.h"
#include "files/text.h"

namespace morula {

namespace {

std::size_t failures(const CheckReport& report) {
  return static_cast<std::size_t>(std::count_if(report.results.begin(), report.results.end(),
                                                [](const CheckResult& r) { return !r.passed; }));
}

/// What XML cannot hold, not even escaped, becomes visible.
std::string xml(const std::string& text) {
  std::string escaped;
  for (const char c : printable(text)) {
    if (c == '&') escaped += "&amp;";
    else if (c == '<') escaped += "&lt;";
    else if (c == '>') escaped += "&gt;";
    else if (c == '"') escaped += "&quot;";
    else if (c == '\n') escaped += "&#10;";
    else escaped += c;
  }
  return escaped;
}

/// What a workflow command would take for its own punctuation.
std::string command(const std::string& text, bool property) {
  std::string escaped;
  for (const char c : text) {
    if (c == '%') escaped += "%25";
    else if (c == '\r') escaped += "%0D";
    else if (c == '\n') escaped += "%0A";
    else if (property && c == ':') escaped += "%3A";
    else if (property && c == ',') escaped += "%2C";
    else escaped += c;
  }
  return escaped;
}

/// "golden/a.golden:12: differs": a file, a line and the rest. The line is "" where none is named.
struct Place {
  std::string file, line, rest;
};

Place placeOf(const std::string& message) {
  const std::string text = firstLine(message);
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos || text.find(' ') < colon) return {"", "", text};
  const std::size_t end = text.find(": ", colon);
  const std::string number = end == std::string::npos ? "" : text.substr(colon + 1, end - colon - 1);
  if (!number.empty() && number.find_first_not_of("0123456789") == std::string::npos)
    return {text.substr(0, colon), number, text.substr(end + 2)};
  return {text.substr(0, colon), "", text.substr(colon + 1 + (text.compare(colon, 2, ": ") == 0))};
}

std::string annotation(const CheckReport& report, const CheckResult& r) {
  const Place place = placeOf(r.message);
  std::string line = "::error ";
  if (!place.file.empty()) line += "file=" + command(place.file, true) + ',';
  if (!place.line.empty()) line += "line=" + place.line + ',';
  line += "title=" + command(r.failureClass + ": " + report.scenario, true);
  return line + "::" + command(r.check + ": " + place.rest, false) + '\n';
}

}  // namespace

std::string junitXml(const std::vector<CheckReport>& reports) {
  std::size_t all = 0, failed = 0;
  std::string suites;
  for (const CheckReport& report : reports) {
    all += report.results.size(), failed += failures(report);
    suites += "  <testsuite name=\"" + xml(report.scenario) + "\" tests=\"" +
              std::to_string(report.results.size()) + "\" failures=\"" + std::to_string(failures(report)) +
              "\">\n";
    for (const CheckResult& r : report.results) {
      suites += "    <testcase classname=\"" + xml(report.scenario) + "\" name=\"" + xml(r.check) + '"';
      if (r.passed) suites += "/>\n";
      else
        suites += ">\n      <failure type=\"" + xml(r.failureClass) + "\" message=\"" +
                  xml(firstLine(r.message)) + "\">" + xml(r.message) + "</failure>\n    </testcase>\n";
    }
    suites += "  </testsuite>\n";
  }
  return std::string(junitBeginning) + " tests=\"" + std::to_string(all) + "\" failures=\"" +
         std::to_string(failed) + "\">\n" + suites + "</testsuites>\n";
}

std::string annotations(const std::vector<CheckReport>& reports, std::size_t most) {
  std::string text;
  std::size_t count = 0;
  for (const CheckReport& report : reports)
    for (const CheckResult& r : report.results)
      if (!r.passed && ++count <= most) text += annotation(report, r);
  if (count > most)
    text +=
        "::error title=morula check::" + std::to_string(count - most) + " more checks differ; see the log\n";
  return text;
}

std::string summaryPage(const std::vector<CheckReport>& reports) {
  Table scenarios{"Scenarios", {"scenario", "checks", ""}},
      details{"What differs", {"scenario", "check", "class", "what differs first"}};
  for (const CheckReport& report : reports) {
    const std::size_t failed = failures(report);
    scenarios.rows.push_back(
        {report.scenario, report.results.size(), failed ? bold(std::to_string(failed) + " differ") : "pass"});
    for (const CheckResult& r : report.results)
      if (!r.passed) details.rows.push_back({report.scenario, r.check, r.failureClass, firstLine(r.message)});
  }
  return std::string(summaryBeginning) + "\n" + markdownOf(scenarios) +
         (details.rows.empty() ? "" : "\n" + markdownOf(details));
}

}  // namespace morula
