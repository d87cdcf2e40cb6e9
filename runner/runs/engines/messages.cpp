#include "engines/messages.h"

#include "system/json_record.h"

namespace morula {

// What is told of each, in the order in which it is told. Members that are named and not told are not needed by the other side.

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
  field({"damping"}, physics.membrane.damping);
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

/// `cpuSeconds` is of the process that asks.
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

}  // namespace morula
