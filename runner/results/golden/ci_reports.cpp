#include "golden/ci_reports.h"

#include <cstdlib>
#include <map>

#include "document/table.h"
#include "files/content.h"
#include "files/printable.h"
#include "files/text.h"
#include "files/write_file.h"
#include "golden/change.h"
#include "system/console.h"
#include "system/installation.h"

namespace morula {
namespace {

/// Returns the text with characters replaced as `how` says.
std::string escaped(const std::string& text, const std::map<char, std::string>& how) {
  std::string all;
  for (const char c : text) all += how.contains(c) ? how.at(c) : std::string(1, c);
  return all;
}

/// Escapes a text for XML. Characters that XML cannot hold even when escaped are made visible.
std::string xml(const std::string& text) {
  return escaped(printable(text), {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\n', "&#10;"}});
}

/// Escapes characters that a workflow command would take for its own punctuation.
std::string command(const std::string& text, bool property) {
  const std::string all = escaped(text, {{'%', "%25"}, {'\r', "%0D"}, {'\n', "%0A"}});
  return property ? escaped(all, {{':', "%3A"}, {',', "%2C"}}) : all;
}

/// A message "golden/a.golden:12: differs", split into file, line and the rest. `line` is "" if the message names none.
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

/// Returns a cause in one line: "the lineage differs: physics.drag: 1 → 1.5; AB: born at time 1 → 1.5; …". `rest`: the
/// message without its place.
std::string inOneLine(const CheckReport& report, const CheckResult& first, const std::string& rest) {
  const bool isTold = first.kind == CheckKind::golden && first.check != "tolerances" && !report.change.empty();
  return failedInWords(first) + ": " + (isTold ? changeSentence(report.change) : rest);
}

std::string annotation(const CheckReport& report, const Cause& cause) {
  const Place place = placeOf(cause[0]->message);
  std::string line = "::error ";
  if (!place.file.empty()) line += "file=" + command(place.file, true) + ',';
  if (!place.line.empty()) line += "line=" + place.line + ',';
  line += "title=" + command(nameOf(cause[0]->failureClass) + (": " + report.scenario), true);
  return line + "::" +
         command(inOneLine(report, *cause[0], (cause[0]->check == "golden" ? "" : cause[0]->check + ": ") + place.rest),
                 false) +
         '\n';
}

/// Returns the commands to type next; "" if the file is not known.
std::string nextInWords(const CheckReport& report) {
  if (report.file.empty()) return {};
  const std::string file = ' ' + shellWord(report.file);
  return markdownCode(programWord() + " explain" + file) + " shows where the difference began; " +
         markdownCode(programWord() + " review" + file) +
         " shows all differences, and with `--accept --why \"…\"` accepts the result";
}

std::string failureOf(const CheckReport& report, const Cause& cause) {
  const CheckResult& first = *cause[0];
  std::string text = (first.kind == CheckKind::golden ? report.change : "") + first.message;
  if (cause.size() > 1) text += "\nconsequences: " + followingInWords(cause);
  if (const std::string next = nextInWords(report); !next.empty()) text += '\n' + next;
  return "      <failure type=\"" + xml(nameOf(first.failureClass)) + "\" message=\"" +
         xml(inOneLine(report, first, firstLine(first.message))) + "\">" + xml(text) + "</failure>\n";
}

/// Returns a table with a row for each line of the change, then the checks that follow.
Table detailsOf(const CheckReport& report, const Cause& cause) {
  const CheckResult& first = *cause[0];
  Table table{"What differs", {nameOf(first.failureClass), failedInWords(first)}};
  if (first.kind == CheckKind::golden)
    for (const ChangeLine& line : linesOfChange(report.change))
      table.rows.push_back({line.heading, markdownText(line.text)});
  if (first.check != "scenario" || report.change.empty())  // the changed keys are in the table already
    table.rows.push_back({"check", markdownText(first.check + ": " + firstLine(first.message))});
  if (cause.size() > 1) table.rows.push_back({"follow", followingInWords(cause)});
  return table;
}

}  // namespace

std::string junitXml(const std::vector<CheckReport>& reports) {
  std::size_t all = 0, failed = 0;
  std::string suites;
  for (const CheckReport& report : reports) {
    std::map<const CheckResult*, std::string> told;  // the XML of failed checks
    const auto causes = causesOf(report);
    std::size_t skipped = 0;
    for (const Cause& cause : causes) {
      told[cause[0]] = failureOf(report, cause);
      skipped += cause.size() - 1;
      for (std::size_t i = 1; i < cause.size(); ++i)
        told[cause[i]] = "      <skipped message=\"this difference follows from " + xml(cause[0]->check) + "\"/>\n";
    }
    all += report.results.size(), failed += causes.size();
    suites += "  <testsuite name=\"" + xml(report.scenario) + "\" tests=\"" + std::to_string(report.results.size()) +
              "\" failures=\"" + std::to_string(causes.size()) + "\" skipped=\"" + std::to_string(skipped) + "\">\n";
    for (const CheckResult& r : report.results) {
      suites += "    <testcase classname=\"" + xml(report.scenario) + "\" name=\"" + xml(r.check) + '"';
      suites += r.passed ? "/>\n" : ">\n" + told.at(&r) + "    </testcase>\n";
    }
    suites += "  </testsuite>\n";
  }
  return std::string(junitBeginning) + " tests=\"" + std::to_string(all) + "\" failures=\"" + std::to_string(failed) +
         "\">\n" + suites + "</testsuites>\n";
}

std::string annotations(const std::vector<CheckReport>& reports, std::size_t most) {
  std::string text;
  std::size_t count = 0;
  for (const CheckReport& report : reports)
    for (const Cause& cause : causesOf(report))
      if (++count <= most) text += annotation(report, cause);
  if (count > most) text += "::error title=morula check::" + std::to_string(count - most) + " more; see the log\n";
  return text;
}

std::string summaryPage(const std::vector<CheckReport>& reports) {
  Table scenarios{"Scenarios", {"scenario", "checks", ""}};
  std::string details;
  for (const CheckReport& report : reports) {
    const auto causes = causesOf(report);
    std::string words;
    for (const Cause& cause : causes)
      if (const std::string what = failedInWords(*cause[0]); words.find(what) == words.npos)
        words += (words.empty() ? "" : "; ") + what;
    scenarios.rows.push_back(
        {markdownText(report.scenario), report.results.size(), causes.empty() ? Words("pass") : bold(words)});
    if (!causes.empty()) details += "\n#### " + markdownText(printableLine(report.scenario)) + "\n";
    for (const Cause& cause : causes) details += "\n" + markdownOf(detailsOf(report, cause));
    if (const std::string next = nextInWords(report); !causes.empty() && !next.empty())
      details += "\n" + printableLine(next) + "\n";
  }
  return std::string(summaryBeginning) + "\n" + markdownOf(scenarios) + details;
}

void tellWorkflow(const std::vector<CheckReport>& reports, bool json) {
  const char *inWorkflow = std::getenv("GITHUB_ACTIONS"), *page = std::getenv("GITHUB_STEP_SUMMARY");
  if (!inWorkflow || std::string(inWorkflow) != "true") return;
  if (!json) print(annotations(reports));
  if (page) appendToFile(page, summaryPage(reports));
}

}  // namespace morula
