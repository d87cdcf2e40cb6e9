#include "engines/engine_worker.h"

#include <algorithm>
#include <istream>
#include <ostream>

#include "base/error.h"
#include "engines/bullet_world.h"
#include "system/child_process.h"
#include "system/clock.h"
#include "system/json_record.h"

namespace morula {

// The fields that are exchanged, in their order. Named fields that are not exchanged are not needed by the other side.

template <IsA<Body> T>
void listFields(T& body, auto&& field) {
  auto& [position, velocity, mass, restScale, pressureConstant, meshLevel] = body;
  field({"mass"}, mass);
  field({"rest_scale"}, restScale);
  field({"pressure_constant"}, pressureConstant);
  field({"position"}, position);
  field({"velocity"}, velocity);
}

template <IsA<ShellParameters> T>
void listFields(T& shell, auto&& field) {
  auto& [semiAxes, mesh, holds] = shell;
  field({"x"}, semiAxes[0]);
  field({"y"}, semiAxes[1]);
  field({"z"}, semiAxes[2]);
  field({"holds"}, holds);
}

template <IsA<BulletRequest> T>
void listFields(T& request, auto&& field) {
  auto& [scene, steps, reports] = request;
  auto& [baseline, mesh, physics, cells, timeStep, contact, margin, iterations] = scene;
  field({"baseline"}, baseline);
  field({"steps"}, steps);
  field({"reports"}, reports);
  field({"time_step"}, timeStep);
  field({"contact"}, contact);
  field({"margin"}, margin);
  field({"iterations"}, iterations);
  field({"integrator"}, physics.integrator);
  field({"stiffness"}, physics.membrane.stiffness);
  field({"damping"}, physics.membrane.damping.constant);
  field({"damping_ratio"}, physics.membrane.damping.ratio);
  field({"springs"}, physics.membrane.springs);
  field({"outside"}, physics.pressure.outside);
  field({"drag"}, physics.drag);
  field({"shell"}, physics.shell);
  field({"vertices"}, mesh.vertices);
  field({"faces"}, mesh.faces);
  field({"bodies"}, cells);
}

template <IsA<BulletResult> T>
void listFields(T& result, auto&& field) {
  auto& [cells, stepSeconds, reports] = result;
  field({"bodies"}, cells);
  field({"step_seconds"}, stepSeconds);
  field({"reports"}, reports);
}

template <IsA<NamedFile> T>
void listFields(T& file, auto&& field) {
  auto& [role, path, content] = file;
  field({"role"}, role);
  field({"path"}, path);
  field({"content"}, content);
}

/// `cpuSeconds` limits the process, and is used by the asking side.
template <IsA<ExternalQuestion> T>
void listFields(T& question, auto&& field) {
  auto& [engine, margin, integrator, cpuSeconds, frameTimes] = question;
  field({"engine"}, engine);
  field({"margin"}, margin);
  field({"integrator"}, integrator);
  field({"frame_times"}, frameTimes);
}

template <IsA<ExternalFrame> T>
void listFields(T& frame, auto&& field) {
  auto& [time, step, shapes] = frame;
  field({"time"}, time);
  field({"step"}, step);
  field({"shapes"}, shapes);
}

template <IsA<CellMeasures> T>
void listFields(T& cell, auto&& field) {
  field({"path"}, cell.path);
  field({"measures"}, measuresIn(cell, [](const CellMeasure&) { return true; }));
}

template <IsA<Sample> T>
void listFields(T& sample, auto&& field) {
  auto& [world, cells, contacts, more, surfaces] = sample;
  field({"time"}, world.time);
  field({"cells"}, cells);
}

template <IsA<Bounds> T>
void listFields(T& bounds, auto&& field) {
  auto& [least, most] = bounds;
  field({"least"}, least);
  field({"most"}, most);
}

template <IsA<ExternalRun> T>
void listFields(T& run, auto&& field) {
  auto& [end, why, step, results, volumes, shapes, samples, frames] = run;
  field({"end"}, end);
  field({"why"}, why);
  field({"step"}, step);
  field({"volumes"}, volumes);
  field({"results"}, results);
  field({"shapes"}, shapes);
  field({"samples"}, samples);
  field({"frames"}, frames);
}

Json toJson(const BulletRequest& request) { return toJson<BulletRequest>(request); }
BulletRequest bulletRequestFrom(const Json& json) { return fromJson<BulletRequest>(json); }

Json toJson(const BulletResult& result) { return toJson<BulletResult>(result); }
BulletResult bulletResultFrom(const Json& json) { return fromJson<BulletResult>(json); }

Json toJson(const Scenario& scenario, const ExternalQuestion& question) {
  Json json = toJson(question);
  json["scenario"] = scenario.resolved, json["file"] = scenario.file, json["files"] = memberJson(scenario.files);
  return json;
}

Scenario scenarioFrom(const Json& json) {
  std::vector<NamedFile> files;
  readMember(json.at("files"), files);
  return readScenario(json.at("scenario").get<std::string>(), json.at("file").get<std::string>(), "", {}, files);
}

ExternalQuestion externalQuestionFrom(const Json& json) { return fromJson<ExternalQuestion>(json); }

Json toJson(const ExternalRun& run) { return toJson<ExternalRun>(run); }
ExternalRun externalRunFrom(const Json& json) { return fromJson<ExternalRun>(json); }

namespace {

/// Returns the command that makes a Morula program answer a question.
std::vector<std::string> workerOf(const std::string& program) { return {program, "internal", "engine-worker"}; }

BulletResult runRequest(const BulletRequest& request) {
  const auto world = makeBulletWorld(request.scene);
  BulletResult result;
  for (int i = 1; i <= request.steps; ++i) {
    result.stepSeconds.push_back(timeOf(ClockKind::process, [&] { world->step(); }));
    if (std::binary_search(request.reports.begin(), request.reports.end(), i)) result.reports.push_back(world->cells());
  }
  result.cells = world->cells();
  return result;
}

Json answerTo(const Json& question, std::ostream& out) {
  if (!question.contains("scenario")) return toJson(runRequest(bulletRequestFrom(question)));
  return toJson(runHere(question, [&](std::uint64_t step) {
    out << jsonText({{"step", step}}) << std::endl;  // the last step is known if the process dies
  }));
}

/// Returns the last line that arrived whole; null if there is none.
Json lastMessage(const std::string& said) {
  for (auto end = said.rfind('\n'); end != said.npos && end > 0;) {
    const auto before = said.rfind('\n', end - 1);
    const auto begin = before == said.npos ? 0 : before + 1;
    Json message = tryParseJson(std::string_view(said).substr(begin, end - begin));
    if (message.is_object()) return message;
    end = before;
  }
  return {};
}

}  // namespace

void serveEngine(std::istream& in, std::ostream& out) {
  try {
    out << jsonText({{"answer", answerTo(parseJson(std::string(std::istreambuf_iterator<char>(in), {})), out)}})
        << std::endl;
  } catch (const Json::exception& error) {
    throw InputError(std::string("the request to another engine cannot be read: ") + error.what());
  }
}

BulletResult runInBullet(const BulletRequest& request, const std::string& program) {
  const ChildEnd end = runChild(workerOf(program), {.input = jsonText(toJson(request))});
  if (!end.well()) throw FileError("Bullet's process " + program + " " + end.text());
  try {
    return bulletResultFrom(lastMessage(end.said).at("answer"));
  } catch (const Json::exception& error) {
    throw InputError(std::string("Bullet's answer cannot be read: ") + error.what());
  }
}

ExternalRun runExternally(const Scenario& scenario, const ExternalQuestion& question, const std::string& program) {
  const ChildEnd end =
      runChild(workerOf(program), {.input = jsonText(toJson(scenario, question)), .cpuSeconds = question.cpuSeconds});
  const Json message = lastMessage(end.said);
  ExternalRun silent;
  if (message.is_object() && message.contains("step") && message["step"].is_number_unsigned())
    message["step"].get_to(silent.step);
  if (end.outOfTime())
    silent.why = "the engine gave no answer within " + std::to_string(question.cpuSeconds) + " s of CPU time";
  else if (!end.well()) silent.why = "the engine's process " + end.text();
  else silent.why = "the engine's answer is cut short";
  if (!end.well()) return silent;
  try {
    return externalRunFrom(message.at("answer"));
  } catch (const Json::exception&) { return silent; }
}

}  // namespace morula
