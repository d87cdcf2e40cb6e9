#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "accuracy/accuracy.h"
#include "base/number_text.h"

namespace morula {

namespace {

std::string stepText(double timeStep);

/// A share of the steps that the scene chooses, or a time.
std::string stepText(const Setting& setting) {
  if (!setting.automatic || setting.autoShare == 1) return stepText(setting.timeStep);
  const double parts = 1 / setting.autoShare;
  return parts == std::floor(parts) ? fmt::format("auto/{:g}", parts)
                                    : "auto*" + numberText(setting.autoShare);
}

std::string stepText(double timeStep) {
  const double parts = 1 / timeStep;
  return parts > 1 && parts == static_cast<double>(static_cast<std::int64_t>(parts))
             ? fmt::format("1/{:.0f}", parts)
             : numberText(timeStep, 6);
}

std::string column(const std::optional<double>& a) {
  return a ? fmt::format(" {:>9.2e}", *a) : fmt::format(" {:>9}", "-");
}

/// `before`: why the row above failed, if it did.
std::string line(const AccuracyRow& row, const std::string& before) {
  std::string text = fmt::format("  {:<11}", stepText(row.setting));
  if (!row.failure.empty())
    return text + (row.failure == before ? "failed likewise\n" : "failed: " + row.failure + "\n");
  if (!row.error) return text + fmt::format("other cells live from {} on\n", numberText(*row.partedAt));
  const ErrorParts& p = row.parts;
  text += fmt::format("{:>9.2e}{}", p.sum(), p.mesh ? ' ' : '+');
  text += column(p.time ? p.time : p.model) + (row.resolved ? ' ' : '~') + column(p.mesh).substr(1) +
          column(p.precision);
  text += fmt::format(" {:>9.2e} {:>9.2e} {:>9.2e} {:>9.2e} {:>10.4f} {:>12}", row.errors.centroid,
                      row.errors.volume, row.errors.surface, row.birthTimes, row.cpuSeconds,
                      row.forceEvaluations);
  if (row.partedAt) text += fmt::format("  * up to {}: then other cells live", numberText(*row.partedAt));
  if (row.cut) text += fmt::format("  * divides across another plane at {}", numberText(row.cut->time));
  return text + "\n";
}

std::string ownText(const AccuracyReport& report) {
  const AccuracyRow& own = report.own;
  std::string text = "as it is   ";
  if (!own.failure.empty()) return text + "failed: " + own.failure + "\n";
  if (!own.error) return text + "other cells live from " + numberText(*own.partedAt) + " on\n";
  const ErrorParts& p = own.parts;
  text += fmt::format("error {}{:.2g}: time {}{}, mesh {}, precision {:.2g}\n", p.mesh ? "" : "at least ",
                      p.sum(), p.time ? fmt::format("{:.2g}", *p.time) : "not known", own.resolved ? "" : "~",
                      p.mesh ? fmt::format("{:.2g}", *p.mesh) : "not known", p.precision.value_or(0));
  text += fmt::format("           in {:.4f} s, {} evaluations, time step {}{}\n", own.cpuSeconds,
                      own.forceEvaluations, stepText(own.setting), own.setting.automatic ? " at least" : "");
  if (own.partedAt)
    return text + fmt::format("           up to {}: then other cells live\n", numberText(*own.partedAt));
  if (report.rows.empty()) return text;
  return text +
         (report.rival
              ? fmt::format("           the cheapest tried that is as exact on this mesh: {}, {:.4f} s, "
                            "{:.2f} times as fast\n",
                            report.rival->series, report.rival->cpuSeconds, report.rival->speed)
              : "           nothing else that was tried is as exact on this mesh\n");
}

std::string measuresText(const MeshMeasures& m) {
  return fmt::format("position {:.2g}, volume {:.2g}, surface {:.2g}, pressure {:.2g}, contact area {:.2g}",
                     m.centroid, m.volume, m.surface, m.pressure, m.contactArea);
}

std::string meshText(const MeshError& mesh) {
  if (mesh.none) return "mesh       no error: spheres have no mesh\n";
  if (!mesh.unknown.empty()) return "mesh       error not known: " + mesh.unknown + "\n";
  const LevelError& own = *mesh.find(mesh.own);
  std::string text = fmt::format("mesh       icosphere {}, up to {}: {}\n", mesh.own, numberText(mesh.until),
                                 measuresText(own.worst));
  text += fmt::format("           at time {}: {}\n", numberText(mesh.until), measuresText(own.atEnd));
  text += "           by icospheres";
  for (const LevelError& level : mesh.levels)
    text += fmt::format("{} {} ({:.2g})", &level == mesh.levels.data() ? "" : ",", level.level,
                        level.worst.largest());
  text += mesh.orderIsObserved ? mesh.order > 0
                                     ? fmt::format("; order observed in the edge's length {:.2g}", mesh.order)
                                     : "; from mesh to mesh it hardly falls: it may be larger"
                               : fmt::format("; order {:g} assumed: there are only two", mesh.order);
  text += fmt::format("; time steps add {:.2g}; {:.1f} s of CPU time\n", mesh.timeError, mesh.cpuSeconds);
  if (mesh.atStart > 0)
    text +=
        fmt::format("           of the surface's {:.2g} at time 0 already: faces are flat\n", mesh.atStart);
  if (mesh.partedAt)
    text +=
        fmt::format("           from {} on other cells live on another mesh\n", numberText(*mesh.partedAt));
  if (!mesh.limit.empty()) text += "           no finer one took part: " + mesh.limit + "\n";
  return text;
}

std::string orderText(const SeriesOrder& o) {
  if (!o.observed) return fmt::format("  {:<34} too few errors to fit\n", o.series);
  // Through two points a line goes without a rest.
  const std::string spread = o.observed->points > 2 ? fmt::format(" ± {:.2f}", o.observed->slopeError) : "";
  return fmt::format("  {:<34} {:5.2f}{} from {} time steps; {:g} where all is smooth\n", o.series,
                     o.observed->slope, spread, o.observed->points, o.theory);
}

std::string referenceText(const AccuracyReference& r) {
  return fmt::format(
      "reference  {}, time step {}: its own error {:.2g} by Richardson, observed order {:.2g}\n"
      "witness    {}, time step {}: {:.2g} away, its own error {:.2g}: {}\n",
      nameOf(r.setting.integrator), stepText(r.setting.timeStep), r.left.error, r.left.order,
      nameOf(r.witness.integrator), stepText(r.witness.timeStep), r.distance, r.witnessLeft.error,
      r.agrees ? "they agree" : "THEY DO NOT AGREE");
}

}  // namespace

std::string describe(const AccuracyReport& report) {
  const double until = report.times.back();
  const bool whole = report.end && until >= *report.end * (1 - 1e-6);
  std::string text =
      fmt::format("{}: compared up to time {}{}, at {} times{}\n", report.scenario, numberText(until, 6),
                  whole || !report.end ? "" : " of " + numberText(*report.end, 6), report.times.size(),
                  report.horizon && report.horizon->parted ? "; later is chaos: see the remark" : "");
  text += referenceText(report.reference) + meshText(report.mesh) + ownText(report);
  for (const std::string& remark : report.remarks) text += "remark     " + remark + "\n";
  if (report.rows.empty()) return text;
  text +=
      "\nerror: no more than the sum of its parts, + where the mesh's is not known. time, mesh: against the "
      "converged solution on the row's mesh, and of that mesh; the largest of centroids and surfaces [radii "
      "of the egg] and volumes [relative], of all cells and times. Another contact law or cell model is "
      "stated with its time step, under time\n"
      "centroid, volume, surface: against the reference on the scenario's mesh; births: latest birth against "
      "the reference's [cycle lengths]\n";
  std::string series, failure;
  for (const AccuracyRow& row : report.rows) {
    if (row.series != series) {
      series = row.series, failure.clear();
      text += fmt::format(
          "\n{}{}\n  time step      error       time       mesh precision  centroid    volume   surface    "
          "births  "
          "  CPU [s]  evaluations\n",
          series, series == report.usual ? " (the scenario's own)" : "");
    }
    text += line(row, failure);
    failure = row.failure;
  }
  text += "\norder, from the slope of the error on the scenario's mesh over the time step\n";
  for (const SeriesOrder& o : report.orders) text += orderText(o);
  text +=
      "\nspeed at equal error on the scenario's mesh, between neighbouring runs; speed 1: its own settings\n";
  double error = 0;
  for (const SpeedAtError& s : report.speeds) {
    if (s.error != error) text += fmt::format("  error {:g}\n", error = s.error);
    text += fmt::format("    {:<34} {:.4f} s, {:.0f} evaluations{}\n", s.series, s.cpuSeconds,
                        s.forceEvaluations, s.speed ? fmt::format(", speed {:.2f}", *s.speed) : "");
  }
  if (!report.bulletSpeeds.empty())
    text += "\nbeside Bullet: the least CPU time for an error, of all settings that were tried\n";
  for (const BulletSpeed& s : report.bulletSpeeds)
    text += fmt::format(
        "  error {:g}: {:.4f} s ({}), Bullet {:.4f} s ({}): {:.1f} times, {:.1f} with its slowest setting\n",
        s.error, s.ourSeconds, s.ours, s.bulletSeconds, s.bullets, s.bulletSeconds / s.ourSeconds,
        s.bulletMostSeconds / s.ourSeconds);
  if (report.speeds.empty()) text += "  no error lies between two runs of a series\n";
  return text;
}

}  // namespace morula
