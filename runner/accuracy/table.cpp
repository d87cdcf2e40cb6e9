// What accuracy has found, for people.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "accuracy/accuracy.h"
#include "base/number_text.h"

namespace morula {

namespace {

std::string stepText(double timeStep) {
  const double parts = 1 / timeStep;
  return parts > 1 && parts == static_cast<double>(static_cast<std::int64_t>(parts)) ? fmt::format("1/{:.0f}", parts)
                                                                                     : numberText(timeStep, 6);
}

/// A share of the steps that the scene chooses, or a time.
std::string stepText(const Setting& setting) {
  if (!setting.automatic || setting.autoShare == 1) return stepText(setting.timeStep);
  const double parts = 1 / setting.autoShare;
  return parts == std::floor(parts) ? fmt::format("auto/{:g}", parts) : "auto*" + numberText(setting.autoShare);
}

Cell error(const std::optional<double>& a, const char* mark = "") {
  return a ? Cell(*a, fmt::format("{:.2e}{}", *a, mark)) : exact({});
}

std::string noteOf(const AccuracyRow& row) {
  if (!row.failure.empty()) return "failed: " + row.failure;
  if (!row.error) return fmt::format("other cells live from {} on", numberText(*row.partedAt));
  std::string text;
  if (row.partedAt) text = fmt::format("* up to {}: then other cells live", numberText(*row.partedAt));
  if (row.cut)
    text += fmt::format("{}* divides across another plane at {}", text.empty() ? "" : "  ", numberText(row.cut->time));
  return text;
}

Table rowTable(const std::vector<AccuracyRow>& rows) {
  using Row = AccuracyRow;
  const auto ifKnown = [](const Row& row, double value) { return row.error ? error(value) : exact({}); };
  const std::vector<Field<Row>> fields{
      {"time step", [](const Row& row) { return stepText(row.setting); }},
      {"error", [](const Row& row) { return row.error ? error(row.parts.sum(), row.parts.mesh ? " " : "+") : exact({}); }},
      {"time", [](const Row& row) { return error(row.parts.time ? row.parts.time : row.parts.model, row.resolved ? " " : "~"); }},
      {"mesh", [](const Row& row) { return error(row.parts.mesh); }},
      {"precision", [](const Row& row) { return error(row.parts.precision); }},
      {"centroid", [=](const Row& row) { return ifKnown(row, row.errors.centroid); }},
      {"volume", [=](const Row& row) { return ifKnown(row, row.errors.volume); }},
      {"surface", [=](const Row& row) { return ifKnown(row, row.errors.surface); }},
      {"births", [=](const Row& row) { return ifKnown(row, row.birthTimes); }},
      {"CPU [s]", [](const Row& row) { return row.error ? Cell(row.cpuSeconds, fmt::format("{:.4f}", row.cpuSeconds)) : exact({}); }},
      {"evaluations", [](const Row& row) { return row.error ? Cell(row.forceEvaluations) : exact({}); }},
      {"", noteOf},
  };
  return tableOf("Settings", fields, rows);
}

std::vector<Cell> line(const char* what, const std::string& text) { return {what, text}; }

void tellReference(const AccuracyReference& r, Table& facts) {
  facts.rows.push_back(line("reference", fmt::format("{}, time step {}: its own error {:.2g} by Richardson, observed order {:.2g}",
                                                     nameOf(r.setting.integrator), stepText(r.setting.timeStep), r.left.error,
                                                     r.left.order)));
  facts.rows.push_back(line("witness", fmt::format("{}, time step {}: {:.2g} away, its own error {:.2g}: {}",
                                                   nameOf(r.witness.integrator), stepText(r.witness.timeStep), r.distance,
                                                   r.witnessLeft.error, r.agrees ? "they agree" : "THEY DO NOT AGREE")));
}

std::string measuresText(const MeshMeasures& m) {
  return fmt::format("position {:.2g}, volume {:.2g}, surface {:.2g}, pressure {:.2g}, contact area {:.2g}", m.centroid, m.volume,
                     m.surface, m.pressure, m.contactArea);
}

void tellMesh(const MeshError& mesh, Table& facts) {
  const auto say = [&](const std::string& text) { facts.rows.push_back(line("", text)); };
  if (mesh.none || !mesh.unknown.empty()) {
    facts.rows.push_back(line("mesh", mesh.none ? "no error: spheres have no mesh" : "error not known: " + mesh.unknown));
    return;
  }
  const LevelError& own = *mesh.find(mesh.own);
  facts.rows.push_back(
      line("mesh", fmt::format("icosphere {}, up to {}: {}", mesh.own, numberText(mesh.until), measuresText(own.worst))));
  say(fmt::format("at time {}: {}", numberText(mesh.until), measuresText(own.atEnd)));
  std::string levels;
  for (const LevelError& level : mesh.levels)
    levels += fmt::format("{} {} ({:.2g})", levels.empty() ? "" : ",", level.level, level.worst.largest());
  const std::string order = !mesh.orderIsObserved ? fmt::format("order {:g} assumed: there are only two", mesh.order)
                            : mesh.order > 0      ? fmt::format("order observed in the edge's length {:.2g}", mesh.order)
                                                  : "from mesh to mesh it hardly falls: it may be larger";
  say(fmt::format("by icospheres{}; {}; time steps add {:.2g}; {:.1f} s of CPU time", levels, order, mesh.timeError, mesh.cpuSeconds));
  if (mesh.atStart > 0) say(fmt::format("of the surface's {:.2g} at time 0 already: faces are flat", mesh.atStart));
  if (mesh.partedAt) say(fmt::format("from {} on other cells live on another mesh", numberText(*mesh.partedAt)));
  if (!mesh.limit.empty()) say("no finer one took part: " + mesh.limit);
}

void tellOwn(const AccuracyReport& report, Table& facts) {
  const AccuracyRow& own = report.own;
  const auto say = [&](const std::string& text) { facts.rows.push_back(line("", text)); };
  if (!own.failure.empty() || !own.error) {
    facts.rows.push_back(line("as it is", noteOf(own)));
    return;
  }
  const ErrorParts& p = own.parts;
  const auto orUnknown = [](const std::optional<double>& a) { return a ? fmt::format("{:.2g}", *a) : "not known"; };
  facts.rows.push_back(line("as it is", fmt::format("error {}{:.2g}: time {}{}, mesh {}, precision {:.2g}", p.mesh ? "" : "at least ",
                                                    p.sum(), orUnknown(p.time), own.resolved ? "" : "~", orUnknown(p.mesh),
                                                    p.precision.value_or(0))));
  say(fmt::format("in {:.4f} s, {} evaluations, time step {}{}", own.cpuSeconds, own.forceEvaluations, stepText(own.setting),
                  own.setting.automatic ? " at least" : ""));
  if (own.partedAt) say(fmt::format("up to {}: then other cells live", numberText(*own.partedAt)));
  else if (report.rival)
    say(fmt::format("the cheapest tried that is as exact on this mesh: {}, {:.4f} s, {:.2f} times as fast", report.rival->series,
                    report.rival->cpuSeconds, report.rival->speed));
  else if (!report.rows.empty()) say("nothing else that was tried is as exact on this mesh");
}

Table orderTable(const std::vector<SeriesOrder>& orders) {
  Table table{"Orders", {}};
  for (const SeriesOrder& o : orders) {
    // Through two points a line goes without a rest.
    const std::string spread = o.observed && o.observed->points > 2 ? fmt::format(" ± {:.2f}", o.observed->slopeError) : "";
    table.rows.push_back({o.series, !o.observed ? "too few errors to fit"
                                                : fmt::format("{:.2f}{} from {} time steps; {:g} where all is smooth",
                                                              o.observed->slope, spread, o.observed->points, o.theory)});
  }
  return table;
}

Table speedTable(const std::vector<SpeedAtError>& speeds) {
  using Row = SpeedAtError;
  const std::vector<Field<Row>> fields{
      {"error", [](const Row& s) { return number(s.error, 6); }},
      {"settings", [](const Row& s) { return s.series; }},
      {"CPU [s]", [](const Row& s) { return Cell(s.cpuSeconds, fmt::format("{:.4f}", s.cpuSeconds)); }},
      {"evaluations", [](const Row& s) { return Cell(s.forceEvaluations, fmt::format("{:.0f}", s.forceEvaluations)); }},
      {"speed", [](const Row& s) { return s.speed ? Cell(*s.speed, fmt::format("{:.2f}", *s.speed)) : exact({}); }},
  };
  return tableOf("Speed at equal error", fields, speeds);
}

Table bulletTable(const std::vector<BulletSpeed>& speeds) {
  using Row = BulletSpeed;
  const auto times = [](double a) { return Cell(a, fmt::format("{:.1f}", a)); };
  const std::vector<Field<Row>> fields{
      {"error", [](const Row& s) { return number(s.error, 6); }},
      {"ours", [](const Row& s) { return s.ours; }},
      {"CPU [s]", [](const Row& s) { return number(s.ourSeconds); }},
      {"Bullet", [](const Row& s) { return s.bullets; }},
      {"CPU [s]", [](const Row& s) { return number(s.bulletSeconds); }},
      {"times", [=](const Row& s) { return times(s.bulletSeconds / s.ourSeconds); }},
      {"with its slowest setting", [=](const Row& s) { return times(s.bulletMostSeconds / s.ourSeconds); }},
  };
  return tableOf("Beside Bullet", fields, speeds);
}

}  // namespace

Document describe(const AccuracyReport& report) {
  const double until = report.times.back();
  const bool whole = report.end && until >= *report.end * (1 - 1e-6);
  Table facts{"What is compared", {}};
  tellReference(report.reference, facts);
  tellMesh(report.mesh, facts);
  tellOwn(report, facts);
  for (const std::string& remark : report.remarks) facts.rows.push_back(line("remark", remark));
  Document text;
  text.say(fmt::format("{}: compared up to time {}{}, at {} times{}", report.scenario, numberText(until, 6),
                       whole || !report.end ? "" : " of " + numberText(*report.end, 6), report.times.size(),
                       report.horizon && report.horizon->parted ? "; later is chaos: see the remark" : ""))
      .add(std::move(facts));
  if (report.rows.empty()) return text;
  text.heading(
          "error: no more than the sum of its parts, + where the mesh's is not known. time, mesh: against the converged solution on "
          "the row's mesh, and of that mesh; the largest of centroids and surfaces [radii of the egg] and volumes [relative], of all "
          "cells and times. Another contact law or cell model is stated with its time step, under time")
      .say("centroid, volume, surface: against the reference on the scenario's mesh; births: latest birth against the reference's "
           "[cycle lengths]");
  for (auto first = report.rows.begin(); first != report.rows.end();) {
    const std::string& series = first->series;
    const auto last = std::find_if(first, report.rows.end(), [&](const AccuracyRow& row) { return row.series != series; });
    text.heading(series + (series == report.usual ? " (the scenario's own)" : "")).add(rowTable({first, last}));
    first = last;
  }
  text.heading("order, from the slope of the error on the scenario's mesh over the time step").add(orderTable(report.orders));
  text.heading("speed at equal error on the scenario's mesh, between neighbouring runs; speed 1: its own settings");
  if (report.speeds.empty()) text.say("no error lies between two runs of a series");
  else text.add(speedTable(report.speeds));
  if (!report.bulletSpeeds.empty())
    text.heading("beside Bullet: the least CPU time for an error, of all settings that were tried")
        .add(bulletTable(report.bulletSpeeds));
  return text;
}

}  // namespace morula
