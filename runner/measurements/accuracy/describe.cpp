// The findings of accuracy, for people at a terminal.
#include <fmt/format.h>

#include "accuracy/accuracy.h"
#include "base/number_text.h"

namespace morula {
namespace {

/// A table of names and texts; the name "" repeats the one above.
struct Facts {
  Table table{"What is compared", {}};
  void say(const char* what, const std::string& text) { table.rows.push_back({what, text}); }
};

void tellReference(const AccuracyReference& r, Facts& facts) {
  facts.say("reference",
            fmt::format("{}, time step {}: its own error {:.2g} by Richardson, observed order {:.2g}",
                        nameOf(r.setting.integrator), stepText(r.setting.timeStep), r.left.error, r.left.order));
  facts.say("witness",
            fmt::format("{}, time step {}: {:.2g} away, its own error {:.2g}: {}", nameOf(r.witness.integrator),
                        stepText(r.witness.timeStep), r.distance, r.witnessLeft.error,
                        r.agrees ? "they agree" : "WITNESS AND REFERENCE DO NOT AGREE"));
}

std::string measuresText(const StateError& e) {
  std::string text;
  for (const ErrorQuantity& q : errorQuantities)
    text += fmt::format("{}{} {:.2g}", text.empty() ? "" : ", ", nameOf(q), e.*q.of);
  return text;
}

void tellMesh(const MeshError& mesh, Facts& facts) {
  const auto say = [&](const std::string& text) { facts.say("", text); };
  if (mesh.none) return facts.say("mesh", "no error: spheres have no mesh");
  if (!mesh.unknown.empty()) return facts.say("mesh", "error not known: " + mesh.unknown);
  const LevelError& own = *mesh.find(mesh.own);
  const std::string until = numberText(mesh.until);
  facts.say("mesh", fmt::format("icosphere {}, up to {}: {}", mesh.own, until, measuresText(own.worst)));
  say(fmt::format("at time {}: {}", until, measuresText(own.atEnd)));
  std::string levels;
  for (const LevelError& level : mesh.levels)
    levels += fmt::format("{} {} ({:.2g})", levels.empty() ? "" : ",", level.level, level.worst.largest());
  const std::string order = !mesh.orderIsObserved ? fmt::format(
                                                        "order {:g} assumed, because there are only two "
                                                        "meshes",
                                                        mesh.order)
                            : mesh.order > 0 ? fmt::format("order observed in the edge's length {:.2g}", mesh.order)
                                             : "the error hardly falls from mesh to mesh, so it may be larger";
  say(fmt::format("by icospheres{}; {}; time steps add {:.2g}; {:.1f} s of CPU time", levels, order, mesh.timeError,
                  mesh.cpuSeconds));
  if (mesh.atStart > 0)
    say(fmt::format("the surface's error is {:.2g} at time 0 already, because faces are flat", mesh.atStart));
  if (mesh.partedAt) say(fmt::format("other cells live on another mesh from {} on", numberText(*mesh.partedAt)));
  if (!mesh.limit.empty()) say("finer ones: " + mesh.limit);
}

void tellOwn(const AccuracyReport& report, Facts& facts) {
  const AccuracyRow& own = report.own;
  const auto say = [&](const std::string& text) { facts.say("", text); };
  if (!own.failure.empty()) return facts.say("as it is", "failed: " + own.failure);
  if (!own.error) return facts.say("as it is", "other cells live from " + numberText(*own.partedAt) + " on");
  const ErrorParts& p = own.parts;
  const auto orUnknown = [](const std::optional<double>& a) { return a ? fmt::format("{:.2g}", *a) : "not known"; };
  facts.say("as it is",
            fmt::format("error {}{:.2g}: time {}{}, mesh {}, precision {:.2g}", p.mesh ? "" : "at least ", p.sum(),
                        orUnknown(p.time), own.resolved ? "" : "~", orUnknown(p.mesh), p.precision.value_or(0)));
  say(fmt::format("on its mesh, up to {}: {}", numberText(own.until), measuresText(own.errors)));
  say(fmt::format("in {:.4f} s, {} evaluations, time step {}{}", own.cpuSeconds, own.forceEvaluations,
                  stepText(own.setting), own.setting.automatic ? " at least" : ""));
  if (own.partedAt)
    say(fmt::format("compared up to {}, because other cells live afterwards", numberText(*own.partedAt)));
  else if (report.rival)
    say(fmt::format("the cheapest settings tried that are as exact on this mesh: {}, {:.4f} s, {:.2f} times as fast",
                    report.rival->series, report.rival->cpuSeconds, report.rival->speed));
  else if (!report.rows.empty() && own.cpuSeconds > 0) say("no other settings tried are as exact on this mesh");
}

Table speedTable(const std::vector<SpeedAtError>& speeds) {
  using Row = SpeedAtError;
  const std::vector<FieldOf<Row>> fields{
      {"error", [](const Row& s) { return number(s.error, 6); }},
      {"settings", [](const Row& s) { return s.series; }},
      {"CPU [s]", [](const Row& s) { return Cell(s.cpuSeconds, fmt::format("{:.4f}", s.cpuSeconds)); }},
      {"evaluations", [](const Row& s) { return Cell(s.forceEvaluations, fmt::format("{:.0f}", s.forceEvaluations)); }},
      {"speed", [](const Row& s) { return s.speed ? Cell(*s.speed, fmt::format("{:.2f}", *s.speed)) : exact({}); }},
  };
  return tableOf("Speed at equal error", fields, speeds);
}

}  // namespace

Document describe(const AccuracyReport& report) {
  const double until = report.times.back();
  const bool whole = report.end && until >= *report.end * (1 - 1e-6);
  Facts facts;
  tellReference(report.reference, facts);
  tellMesh(report.mesh, facts);
  tellOwn(report, facts);
  for (const std::string& remark : report.remarks) facts.say("remark", remark);
  Document text;
  text.say(fmt::format("{}: compared up to time {}{}, at {} times{}", report.scenario, numberText(until, 6),
                       whole || !report.end ? "" : " of " + numberText(*report.end, 6), report.times.size(),
                       report.horizon && report.horizon->parted ? "; chaos follows, see the remark" : ""))
      .add(std::move(facts.table))
      .heading("errors of the scenario as it is, at rest and at worst")
      .add(describeStated(report.stated));
  if (report.rows.empty()) return text;
  text.heading("settings").add(settingTables(report));
  text.heading("order: slope of the error on the scenario's mesh over the time step").add(orderTable(report));
  text.heading("speed at equal error on the scenario's mesh, between neighbouring runs; speed 1: its own settings");
  if (report.speeds.empty()) text.say("no error lies between two runs of a series");
  else text.add(speedTable(report.speeds));
  if (!report.bulletSpeeds.empty())
    text.heading("beside Bullet: the least CPU time for an error, of all settings that were tried")
        .add(bulletTable(report));
  return text;
}

}  // namespace morula
