// Verdicts on runs of other engines, in words that fit into a table.
#include "engines/engine_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <charconv>
#include <mutex>
#include <thread>

#include "base/error.h"
#include "document/table.h"
#include "engines/bullet_scene.h"
#include "engines/engine_worker.h"
#include "files/text.h"
#include "golden/accept.h"
#include "scenario/bullet_fit.h"
#include "system/child_process.h"

namespace morula {
namespace {

Verdict notAsked(const std::string& why) { return {Verdict::Kind::notAsked, why, {}}; }

/// Returns "path: wrong" of "file:1:2: path: wrong; right".
std::string withoutPlace(const std::string& why, const Scenario& scenario) {
  const std::string wrong = why.substr(0, why.find(';'));
  const auto colon = wrong.starts_with(scenario.file) ? wrong.find(": ") : wrong.npos;
  return colon == wrong.npos ? wrong : wrong.substr(colon + 2);
}

Verdict askThesis(const Scenario& scenario, const ExternalQuestion& question) {
  const auto& contact = scenario.scene.mechanics->contact;
  if (!contact) return notAsked("as ours: nothing touches");
  if (contact->law == ContactLaw::thesis) return notAsked("is ours");
  const Scenario changed =
      loadScenario(scenario.file, {{"physics.contact.law", "thesis", "--beside thesis"}}, scenario.allowOutside);
  return judge(scenario.check, runExternally(changed, question, ownProgram()));
}

Verdict askBullet(const Scenario& scenario, const ExternalQuestion& question, Baseline baseline) {
  if (!bulletIsAvailable()) return notAsked("not asked: this build has no Bullet");
  for (const auto& one : scenario::bulletIncompatibilities(scenario, baseline))
    if (one.lacks) return notAsked("cannot be asked: " + one.wrong);
  if (baseline == Baseline::b3 && (scenario.scene.mechanics->contact || scenario.scene.mechanics->physics.shell))
    return notAsked("cannot be asked: b3 knows neither contact nor shell");
  const ExternalRun run = runExternally(scenario, question, ownProgram());
  if (run.end == ExternalRun::End::refused) return notAsked("cannot be asked: " + withoutPlace(run.why, scenario));
  return judge(scenario.check, run);
}

Verdict ask(const Scenario& scenario, Engine engine, const ComparisonOptions& options) {
  if (!scenario.scene.mechanics) return notAsked("cannot be asked: cells without bodies");
  const ExternalQuestion question{.engine = engine, .cpuSeconds = options.cpuSeconds};
  try {
    if (engine == Engine::thesis) return askThesis(scenario, question);
    return askBullet(scenario, question, baselineOf(engine));
  } catch (const InputError& error) {
    return notAsked(std::string("cannot be asked: ") + error.what());
  } catch (const std::exception& error) {  // any error ends this question alone
    return {Verdict::Kind::noAnswer, std::string("no answer: ") + error.what(), {}};
  }
}

const char* title(Engine engine) { return choices<Engine>[static_cast<std::size_t>(engine)].meaning; }

/// Returns "needle" of "hard/needle".
std::string shortName(const std::string& scenario) { return scenario.substr(scenario.rfind('/') + 1); }

/// Returns "0.9877" for "0.98765432109": a table is for people; the check's JSON has all digits.
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
    // A number out of range may be a hash that begins like a number.
    out += problem == std::errc() && number.size() > 6 ? fmt::format("{:.4g}", value) : number;
    i += number.size();
  }
  return out;
}

/// Returns "energy 0.61 > 0.6", "end-volume 0.4 to 1.02 of [0.7, 1.02]".
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

/// Returns a verdict with all failed checks; absent if all pass.
std::optional<Verdict> brokenOf(const std::vector<CheckResult>& results) {
  std::optional<Verdict> verdict;
  for (const CheckResult& r : results) {
    if (r.passed) continue;
    if (!verdict) verdict = Verdict{Verdict::Kind::breaks, "breaks: " + inShort(r), r.firstStep};
    else verdict->text += "; " + inShort(r);
  }
  return verdict;
}

/// Returns the verdict on a run that was stopped early because a cell was no cell any more.
Verdict noCell(const ExternalRun& run) {
  const auto place = std::find_if(run.results.begin(), run.results.end(),
                                  [](const CheckResult& r) { return r.check == "extent" && !r.passed; });
  return {Verdict::Kind::breaks,
          fmt::format("breaks: {} at step {}", place == run.results.end() ? "inside out" : "no number", run.step),
          run.step};
}

/// Returns a message up to its remedy, which is for the author of the scenario.
std::string firstPart(const std::string& why) { return why.substr(0, std::min(why.find(';'), why.find('\n'))); }

}  // namespace

std::vector<Engine> parseEngines(const std::string& text) {
  std::vector<Engine> engines;
  for (const std::string& word : partsOf(text, ',')) {
    const std::size_t before = engines.size();
    for (const Engine engine : valuesOf<Engine>())
      if (word == nameOf(engine) || (word == "bullet" && (engine == Engine::b1 || engine == Engine::b2)))
        engines.push_back(engine);
    if (engines.size() == before)
      throw InputError("'" + word + "' is no engine; needs some of thesis, bullet, b1, b2, b3, as thesis,bullet");
  }
  return engines;
}

std::vector<ComparisonRow> compareEngines(const std::vector<Scenario>& scenarios, const std::vector<Verdict>& own,
                                          const ComparisonOptions& options) {
  std::vector<ComparisonRow> rows;
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    rows.push_back({goldenName(scenarios[i].file), {own[i]}});
    rows.back().verdicts.resize(1 + options.engines.size());
  }
  // Each question is another process, and each answer has its own place, so the order does not matter.
  std::atomic<std::size_t> next = 0;
  std::mutex console;  // one line at a time
  const std::size_t count = scenarios.size() * options.engines.size();
  const auto work = [&] {
    for (std::size_t i; (i = next++) < count;) {
      const std::size_t row = i / options.engines.size(), column = i % options.engines.size();
      Verdict& verdict = rows[row].verdicts[1 + column] = ask(scenarios[row], options.engines[column], options);
      const std::lock_guard<std::mutex> alone(console);
      tell(rows[row].scenario + ", " + title(options.engines[column]) + ": " + verdict.text, options.quiet);
    }
  };
  std::vector<std::jthread> workers;
  for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i) workers.emplace_back(work);
  workers.clear();  // waits for them
  return rows;
}

std::string comparisonTable(const std::vector<ComparisonRow>& rows, const std::vector<Engine>& engines) {
  Table table{"Engines side by side", {"case", "ours"}};
  for (const Engine engine : engines) table.columns.push_back(title(engine));
  for (const ComparisonRow& row : rows) {
    table.rows.push_back({"`" + shortName(row.scenario) + "`"});
    for (const Verdict& verdict : row.verdicts) table.rows.back().push_back(verdict.text);
  }
  return markdownOf(table);
}

Json toJson(const std::vector<ComparisonRow>& rows, const std::vector<Engine>& engines) {
  Json list = Json::array();
  for (const ComparisonRow& row : rows)
    for (std::size_t i = 0; i < row.verdicts.size(); ++i)
      list.push_back({{"scenario", row.scenario},
                      {"engine", i == 0 ? "morula" : nameOf(engines[i - 1])},
                      {"verdict", name(row.verdicts[i].kind)},
                      {"text", row.verdicts[i].text},
                      {"step", orNull(row.verdicts[i].step)}});
  return list;
}

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
