#include "engines/external_run.h"

#include <cmath>
#include <istream>
#include <limits>
#include <ostream>
#include <sstream>

#include "base/error.h"
#include "check/invariants.h"
#include "engines/bullet_run.h"
#include "engines/external_run_json.h"
#include "simulation/measures.h"
#include "system/child_process.h"
#include "system/console.h"

namespace morula {

namespace {

/// Of every run that its cells be cells: volumes above 0 and places that are numbers. Bullet goes on with
/// anything.
CheckParameters leastDemands() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CheckParameters check;
  check.volume = Bounds{std::numeric_limits<double>::denorm_min(), infinity};
  check.extent = infinity;
  return check;
}

struct OwnSteps {
  World state;
  const World& world() const { return state; }
  void step() { morula::step(state); }
};

/// `run` has world() and step().
template <class Run>
void goThrough(Run& run, const Scenario& scenario, OtherRun& answer, std::ostream& out) {
  Invariants demands(scenario.check), least(leastDemands());
  Recorder recorder({scenario.record.every, {}});
  const auto observe = [&] {
    demands.observe(run.world());
    least.observe(run.world());
    recorder.observe(run.world());
    return least.holdSoFar();
  };
  bool holds = observe();
  while (holds && !finished(run.world())) {
    run.step();
    answer.step = run.world().clock.step;
    holds = observe();
    out << "step " << answer.step << std::endl;  // so that a process that dies has said how far it came
  }
  answer.results = holds ? demands.results(run.world()) : least.watched();
  answer.end = holds ? OtherRun::End::done : OtherRun::End::broken;
  answer.volumes = least.volumes();
  answer.samples = recorder.samples();
  if (!holds) return;
  if (answer.samples.empty() || answer.samples.back().world.time != run.world().clock.time)
    answer.samples.push_back({measureWorld(run.world()), measureCells(run.world()), {}});
  for (const CellPath& path : run.world().cells.path)
    answer.shapes.push_back(cellVertices(run.world(), path));
}

OtherRun runHere(const Json& question, std::ostream& out) {
  OtherRun answer;
  try {
    std::vector<NamedFile> files;
    for (const Json& f : question.at("files")) files.push_back({f.at("role"), f.at("path"), f.at("content")});
    const Scenario scenario = readScenario(question.at("scenario"), question.at("file"), "", {}, files);
    const auto engine = static_cast<Engine>(question.at("engine").get<int>());
    if (engine == Engine::thesis) {
      OwnSteps run{makeScenarioWorld(scenario, {})};
      goThrough(run, scenario, answer, out);
    } else {
      const auto baseline = static_cast<Baseline>(static_cast<int>(engine) - static_cast<int>(Engine::b1));
      BulletRun run(scenario, baseline, question.at("margin"),
                    static_cast<Integrator>(question.at("integrator").get<int>()));
      goThrough(run, scenario, answer, out);
    }
  } catch (const NumericalError& error) {
    answer.end = OtherRun::End::stopped;
    answer.why = error.what();
  } catch (const InputError& error) {
    answer.end = OtherRun::End::refused;
    answer.why = error.what();
  }
  return answer;
}

/// The number behind the last "step " of a text that may be cut anywhere.
std::uint64_t lastStep(const std::string& said) {
  const auto end = said.rfind('\n');
  if (end == said.npos) return 0;
  const auto at = said.rfind("step ", end);
  return at == said.npos ? 0 : std::strtoull(said.c_str() + at + 5, nullptr, 10);
}

}  // namespace

const char* name(Engine engine) {
  constexpr const char* names[] = {"thesis", "b1", "b2", "b3"};
  return names[static_cast<int>(engine)];
}

Engine engineOf(Baseline baseline) {
  return static_cast<Engine>(static_cast<int>(baseline) + static_cast<int>(Engine::b1));
}

void serveOtherRun(std::istream& in, std::ostream& out) {
  const Json question = Json::parse(in, nullptr, false);
  if (question.is_discarded()) throw InputError("the question to another engine is no JSON");
  const OtherRun answer = runHere(question, out);
  out << "answer " << jsonText(toJson(answer)) << '\n' << std::flush;
}

OtherRun runElsewhere(const Scenario& scenario, const OtherQuestion& question, const std::string& program) {
  Json files = Json::array();
  for (const NamedFile& f : scenario.files)
    files.push_back({{"role", f.role}, {"path", f.path}, {"content", f.content}});
  const Json text{{"scenario", scenario.resolved},
                  {"file", scenario.file},
                  {"files", files},
                  {"engine", static_cast<int>(question.engine)},
                  {"margin", question.margin},
                  {"integrator", static_cast<int>(question.integrator)}};
  const ChildEnd end =
      runChild({program, "other-worker"}, {.input = jsonText(text), .cpuSeconds = question.cpuSeconds});
  OtherRun silent;
  silent.step = lastStep(end.said);
  if (end.outOfTime())
    silent.why = "no answer within " + std::to_string(question.cpuSeconds) + " s of CPU time";
  else if (!end.well()) silent.why = "its process " + end.text();
  else silent.why = "its answer is cut";
  const auto at = end.said.rfind("answer {");
  if (!end.well() || at == end.said.npos) return silent;
  try {
    return otherRunFrom(Json::parse(end.said.substr(at + 7)));
  } catch (const Json::exception&) { return silent; }
}

}  // namespace morula
