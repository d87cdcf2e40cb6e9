#include "engines/messages.h"

#include <cmath>

#include "golden/check_json.h"
#include "values/measure_list.h"

namespace morula {

namespace {

double realFrom(const Json& j) { return j.is_null() ? NAN : j.get<double>(); }

std::vector<double> realsFrom(const Json& j) {
  std::vector<double> list;
  for (const Json& a : j) list.push_back(realFrom(a));
  return list;
}

Json flat(const std::vector<Vector>& vectors) {
  Json list = Json::array();
  for (const Vector& v : vectors)
    for (const double a : {v.x, v.y, v.z}) list.push_back(a);
  return list;
}

std::vector<Vector> vectorsFrom(const Json& j) {
  std::vector<Vector> vectors;
  for (std::size_t i = 0; i < j.size(); i += 3)
    vectors.push_back({realFrom(j.at(i)), realFrom(j.at(i + 1)), realFrom(j.at(i + 2))});
  return vectors;
}

template <class Value, class Read>
std::vector<Value> listFrom(const Json& j, const Read& read) {
  std::vector<Value> list;
  for (const Json& a : j) list.push_back(read(a));
  return list;
}

Json toJson(const Body& body) {
  return {{"mass", body.mass},
          {"rest_scale", body.restScale},
          {"pressure_constant", body.pressureConstant},
          {"position", flat(body.position)},
          {"velocity", flat(body.velocity)}};
}

Body bodyFrom(const Json& j) {
  Body body;
  body.mass = realFrom(j.at("mass")), body.restScale = realFrom(j.at("rest_scale"));
  body.pressureConstant = realFrom(j.at("pressure_constant"));
  body.position = vectorsFrom(j.at("position")), body.velocity = vectorsFrom(j.at("velocity"));
  return body;
}

std::vector<Body> bodiesFrom(const Json& j) { return listFrom<Body>(j, bodyFrom); }

Json toJson(const CellMeasures& c) {
  Json json{{"path", c.path.text()}};
  addMeasures(json, c);
  return json;
}

CellMeasures cellFrom(const Json& j) {
  CellMeasures c;
  c.path = CellPath::parse(j.at("path").get<std::string>());
  for (const CellMeasure& m : sampledMeasures<CellContext>())
    if (!j.at(m.name).is_null()) c[m.name] = j.at(m.name).get<double>();
  return c;
}

template <class Value>
Json listOf(const std::vector<Value>& values) {
  Json list = Json::array();
  for (const Value& v : values) list.push_back(toJson(v));
  return list;
}

}  // namespace

Json toJson(const BulletRequest& request) {
  const BulletScene& s = request.scene;
  Json json{{"baseline", static_cast<int>(s.baseline)},
            {"steps", request.steps},
            {"reports", request.reports},
            {"time_step", s.timeStep},
            {"contact", s.contact},
            {"margin", s.margin},
            {"iterations", s.iterations},
            {"integrator", static_cast<int>(s.physics.integrator)},
            {"stiffness", s.physics.membrane.stiffness},
            {"damping", s.physics.membrane.damping},
            {"outside", s.physics.pressure.outside},
            {"drag", s.physics.drag},
            {"vertices", flat(s.mesh.vertices)},
            {"faces", s.mesh.faces},
            {"bodies", listOf(s.cells)}};
  if (const auto& shell = s.physics.shell) {
    const auto& axes = shell->semiAxes;
    json["shell"] = {axes[0], axes[1], axes[2]};
  }
  return json;
}

BulletRequest bulletRequestFrom(const Json& j) {
  BulletRequest request;
  BulletScene& s = request.scene;
  s.baseline = static_cast<Baseline>(j.at("baseline").get<int>());
  j.at("steps").get_to(request.steps), j.at("reports").get_to(request.reports);
  j.at("time_step").get_to(s.timeStep), j.at("contact").get_to(s.contact);
  j.at("margin").get_to(s.margin), j.at("iterations").get_to(s.iterations);
  s.physics.integrator = static_cast<Integrator>(j.at("integrator").get<int>());
  j.at("stiffness").get_to(s.physics.membrane.stiffness);
  j.at("damping").get_to(s.physics.membrane.damping);
  j.at("outside").get_to(s.physics.pressure.outside);
  j.at("drag").get_to(s.physics.drag);
  if (j.contains("shell")) {
    auto& axes = s.physics.shell.emplace().semiAxes;
    for (std::size_t i = 0; i < 3; ++i) j["shell"].at(i).get_to(axes[i]);
  }
  s.mesh.vertices = vectorsFrom(j.at("vertices"));
  j.at("faces").get_to(s.mesh.faces);
  s.cells = bodiesFrom(j.at("bodies"));
  return request;
}

Json toJson(const BulletResult& result) {
  Json reports = Json::array();
  for (const auto& report : result.reports) reports.push_back(listOf(report));
  return {{"step_seconds", result.stepSeconds}, {"bodies", listOf(result.cells)}, {"reports", reports}};
}

BulletResult bulletResultFrom(const Json& j) {
  return {bodiesFrom(j.at("bodies")), realsFrom(j.at("step_seconds")),
          listFrom<std::vector<Body>>(j.at("reports"), bodiesFrom)};
}

Json toJson(const Scenario& scenario, const ExternalQuestion& question) {
  Json files = Json::array();
  for (const NamedFile& f : scenario.files)
    files.push_back({{"role", f.role}, {"path", f.path}, {"content", f.content}});
  return {{"scenario", scenario.resolved},
          {"file", scenario.file},
          {"files", files},
          {"engine", static_cast<int>(question.engine)},
          {"margin", question.margin},
          {"integrator", static_cast<int>(question.integrator)},
          {"frame_times", question.frameTimes}};
}

Scenario scenarioFrom(const Json& j) {
  std::vector<NamedFile> files;
  for (const Json& f : j.at("files"))
    files.push_back({f.at("role").text(), f.at("path").text(), f.at("content").text()});
  return readScenario(j.at("scenario").text(), j.at("file").text(), "", {}, files);
}

ExternalQuestion externalQuestionFrom(const Json& j) {
  return {.engine = static_cast<Engine>(j.at("engine").get<int>()),
          .margin = j.at("margin").get<double>(),
          .integrator = static_cast<Integrator>(j.at("integrator").get<int>()),
          .frameTimes = j.contains("frame_times") ? j["frame_times"].get<std::vector<double>>()
                                                  : std::vector<double>()};
}

namespace {

using Shapes = std::vector<std::vector<Point>>;

Json flatEach(const Shapes& shapes) {
  Json list = Json::array();
  for (const auto& shape : shapes) list.push_back(flat(shape));
  return list;
}

Shapes shapesFrom(const Json& j) { return listFrom<std::vector<Point>>(j, vectorsFrom); }

}  // namespace

Json toJson(const ExternalRun& run) {
  Json samples = Json::array(), frames = Json::array();
  for (const ExternalFrame& f : run.frames)
    frames.push_back({{"time", f.time}, {"step", f.step}, {"shapes", flatEach(f.shapes)}});
  for (const Sample& s : run.samples) samples.push_back({{"time", s.world.time}, {"cells", listOf(s.cells)}});
  return {{"end", static_cast<int>(run.end)},
          {"why", run.why},
          {"step", run.step},
          {"volumes", {run.volumes.least, run.volumes.most}},
          {"results", listOf(run.results)},
          {"shapes", flatEach(run.shapes)},
          {"samples", samples},
          {"frames", frames}};
}

ExternalRun externalRunFrom(const Json& j) {
  ExternalRun run;
  run.end = static_cast<ExternalRun::End>(j.at("end").get<int>());
  j.at("why").get_to(run.why), j.at("step").get_to(run.step);
  run.volumes = {realFrom(j.at("volumes").at(0)), realFrom(j.at("volumes").at(1))};
  run.results = listFrom<CheckResult>(j.at("results"), checkResultFrom);
  run.shapes = shapesFrom(j.at("shapes"));
  if (j.contains("frames"))
    run.frames = listFrom<ExternalFrame>(j["frames"], [](const Json& f) {
      return ExternalFrame{f.at("time").get<double>(), f.at("step").get<std::uint64_t>(),
                           shapesFrom(f.at("shapes"))};
    });
  for (const Json& s : j.at("samples")) {
    s.at("time").get_to(run.samples.emplace_back().world.time);
    run.samples.back().cells = listFrom<CellMeasures>(s.at("cells"), cellFrom);
  }
  return run;
}

}  // namespace morula
