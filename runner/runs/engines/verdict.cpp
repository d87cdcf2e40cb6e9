// From a run to a verdict, and to words that fit into a table.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

#include "engines/engine_comparison.h"

namespace morula {
namespace {

/// "0.98765432109" as "0.9877": a table is for people; all digits stand in the JSON of the check.
std::string inFewDigits(const std::string& text) {
  const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    if (!digit(text[i]) || (i > 0 && std::isalnum(static_cast<unsigned char>(text[i - 1])))) {
      out += text[i++];
      continue;
    }
    double value = 0;
    const auto [end, problem] = std::from_chars(text.data() + i, text.data() + text.size(), value);
    const std::string number(text.data() + i, end);
    // What is out of range may be a hash that begins like a number.
    out += problem == std::errc() && number.size() > 6 ? fmt::format("{:.4g}", value) : number;
    i += number.size();
  }
  return out;
}

/// "energy 0.61 > 0.6", "end-volume 0.4 to 1.02 of [0.7, 1.02]".
std::string inShort(const CheckResult& r) {
  const auto after = [](const std::string& text, std::size_t length) { return text.substr(length); };
  std::string text = r.check + ' ' + r.actual + ", not " + r.expected;
  if (r.expected.starts_with("at most ")) text = r.check + ' ' + r.actual + " > " + after(r.expected, 8);
  else if (r.expected.starts_with("at least ")) text = r.check + ' ' + r.actual + " < " + after(r.expected, 9);
  else if (const auto to = r.expected.find(" to "); r.expected.starts_with("from ") && to != text.npos)
    text = r.check + ' ' + after(r.actual, 5) + " of [" + r.expected.substr(5, to - 5) + ", " +
           after(r.expected, to + 4) + ']';
  return inFewDigits(text) + (r.firstStep ? " at step " + std::to_string(*r.firstStep) : "");
}

/// Nothing, or all that does not hold.
std::optional<Verdict> brokenOf(const std::vector<CheckResult>& results) {
  std::optional<Verdict> verdict;
  for (const CheckResult& r : results) {
    if (r.passed) continue;
    if (!verdict) verdict = Verdict{Verdict::Kind::breaks, "breaks: " + inShort(r), r.firstStep};
    else verdict->text += "; " + inShort(r);
  }
  return verdict;
}

/// A run that was cut short because a cell is no cell any more.
Verdict noCell(const ExternalRun& run) {
  const auto place = std::find_if(run.results.begin(), run.results.end(),
                                  [](const CheckResult& r) { return r.check == "extent" && !r.passed; });
  return {Verdict::Kind::breaks,
          fmt::format("breaks: {} at step {}", place == run.results.end() ? "inside out" : "no number", run.step),
          run.step};
}

/// Up to the remedy, which is for the author of the scenario.
std::string firstPart(const std::string& why) { return why.substr(0, std::min(why.find(';'), why.find('\n'))); }

}  // namespace

const char* name(Verdict::Kind kind) {
  constexpr const char* names[] = {"holds", "breaks", "stops", "goes-on", "no-answer", "not-asked"};
  return names[static_cast<int>(kind)];
}

Verdict judge(const CheckParameters& check, const ExternalRun& run) {
  using End = ExternalRun::End;
  const bool mustStop = !check.fails.empty();
  if (run.end == End::silent)
    return {Verdict::Kind::noAnswer, fmt::format("{}, at step {}", run.why, run.step), run.step};
  if (run.end == End::stopped || run.end == End::refused) {
    if (mustStop) return {Verdict::Kind::holds, "stops, as it must", run.step};
    return {Verdict::Kind::stops, "stops: " + inFewDigits(firstPart(run.why)), run.step};
  }
  if (run.end == End::broken) return noCell(run);
  if (mustStop)
    return {Verdict::Kind::goesOn,
            fmt::format("goes on: volume {:.4g} to {:.4g} of that at rest", run.volumes.least, run.volumes.most),
            {}};
  return brokenOf(run.results).value_or(Verdict{Verdict::Kind::holds, "holds", {}});
}

Verdict judge(const CheckParameters& check, const CheckReport& report) {
  return brokenOf(report.results)
      .value_or(Verdict{Verdict::Kind::holds, check.fails.empty() ? "holds" : "stops, as it must", {}});
}

}  // namespace morula
