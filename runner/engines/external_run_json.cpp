#include "engines/external_run_json.h"

namespace morula {

namespace {

Json toJson(const Vector& v) { return Json{v.x, v.y, v.z}; }
Vector vectorFrom(const Json& j) { return {j.at(0), j.at(1), j.at(2)}; }

Json toJson(const CheckResult& r) {
  return {{"check", r.check},       {"kind", r.kind},           {"expected", r.expected},
          {"actual", r.actual},     {"tolerance", r.tolerance}, {"passed", r.passed},
          {"field", r.field},       {"class", r.failureClass},  {"first_step", orNull(r.firstStep)},
          {"cell", orNull(r.cell)}, {"message", r.message}};
}

CheckResult resultFrom(const Json& j) {
  CheckResult r;
  j.at("check").get_to(r.check), j.at("kind").get_to(r.kind), j.at("expected").get_to(r.expected);
  j.at("actual").get_to(r.actual), j.at("tolerance").get_to(r.tolerance), j.at("passed").get_to(r.passed);
  j.at("field").get_to(r.field), j.at("class").get_to(r.failureClass), j.at("message").get_to(r.message);
  if (!j.at("first_step").is_null()) r.firstStep = j.at("first_step").get<std::uint64_t>();
  if (!j.at("cell").is_null()) r.cell = j.at("cell").get<std::string>();
  return r;
}

Json toJson(const CellMeasures& c) {
  return {{"path", c.path.text()},
          {"volume", c.volume},
          {"area", c.area},
          {"pressure", c.pressure},
          {"centroid", toJson(c.centroid)},
          {"sphericity", c.sphericity}};
}

CellMeasures cellFrom(const Json& j) {
  CellMeasures c;
  c.path = CellPath::parse(j.at("path").get<std::string>());
  j.at("volume").get_to(c.volume), j.at("area").get_to(c.area), j.at("pressure").get_to(c.pressure);
  c.centroid = vectorFrom(j.at("centroid"));
  j.at("sphericity").get_to(c.sphericity);
  return c;
}

}  // namespace

Json toJson(const OtherRun& run) {
  Json results = Json::array(), shapes = Json::array(), samples = Json::array();
  for (const CheckResult& r : run.results) results.push_back(toJson(r));
  for (const auto& shape : run.shapes) {
    shapes.push_back(Json::array());
    for (const Point& p : shape) shapes.back().push_back(toJson(p));
  }
  for (const Sample& s : run.samples) {
    samples.push_back({{"time", s.world.time}, {"cells", Json::array()}});
    for (const CellMeasures& c : s.cells) samples.back()["cells"].push_back(toJson(c));
  }
  return {{"end", static_cast<int>(run.end)},
          {"why", run.why},
          {"step", run.step},
          {"volumes", {run.volumes.least, run.volumes.most}},
          {"results", results},
          {"shapes", shapes},
          {"samples", samples}};
}

OtherRun otherRunFrom(const Json& json) {
  OtherRun run;
  run.end = static_cast<OtherRun::End>(json.at("end").get<int>());
  json.at("why").get_to(run.why), json.at("step").get_to(run.step);
  if (run.end == OtherRun::End::done) run.volumes = {json.at("volumes").at(0), json.at("volumes").at(1)};
  for (const Json& r : json.at("results")) run.results.push_back(resultFrom(r));
  for (const Json& shape : json.at("shapes")) {
    run.shapes.emplace_back();
    for (const Json& p : shape) run.shapes.back().push_back(vectorFrom(p));
  }
  for (const Json& s : json.at("samples")) {
    run.samples.emplace_back().world.time = s.at("time");
    for (const Json& c : s.at("cells")) run.samples.back().cells.push_back(cellFrom(c));
  }
  return run;
}

}  // namespace morula
