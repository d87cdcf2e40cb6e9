#include "engines/engine_comparison.h"

#include <atomic>
#include <mutex>
#include <sstream>
#include <thread>

#include "base/error.h"
#include "document/table.h"
#include "engines/bullet_scene.h"
#include "engines/engine_worker.h"
#include "golden/accept.h"
#include "scenario/bullet_fit.h"
#include "system/child_process.h"

namespace morula {
namespace {

Verdict notAsked(const std::string& why) { return {Verdict::Kind::notAsked, why, {}}; }

/// "file:1:2: path: wrong; right" as "path: wrong".
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
  } catch (const std::exception& error) {  // whatever it is: it ends this question, not the others
    return {Verdict::Kind::noAnswer, std::string("no answer: ") + error.what(), {}};
  }
}

const char* title(Engine engine) {
  constexpr const char* titles[] = {"thesis' contact law", "Bullet, B1", "Bullet, B2", "Bullet, B3"};
  return titles[static_cast<int>(engine)];
}

/// "needle" of "hard/needle".
std::string shortName(const std::string& scenario) { return scenario.substr(scenario.rfind('/') + 1); }

}  // namespace

std::vector<Engine> parseEngines(const std::string& text) {
  std::vector<Engine> engines;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    const std::size_t before = engines.size();
    for (const Engine engine : {Engine::thesis, Engine::b1, Engine::b2, Engine::b3})
      if (word == name(engine) || (word == "bullet" && (engine == Engine::b1 || engine == Engine::b2)))
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
  // Each question is another process and each answer has its own place, so who is first does not matter.
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
  std::vector<std::thread> workers(std::max(1u, std::thread::hardware_concurrency()));
  for (std::thread& worker : workers) worker = std::thread(work);
  for (std::thread& worker : workers) worker.join();
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
                      {"engine", i == 0 ? "morula" : name(engines[i - 1])},
                      {"verdict", name(row.verdicts[i].kind)},
                      {"text", row.verdicts[i].text},
                      {"step", orNull(row.verdicts[i].step)}});
  return list;
}

}  // namespace morula
