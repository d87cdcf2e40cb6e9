#include "accuracy/table.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/number_text.h"

namespace morula {

namespace {

std::string stepText(double timeStep) {
  const double parts = 1 / timeStep;
  return parts > 1 && parts == static_cast<double>(static_cast<std::int64_t>(parts))
             ? fmt::format("1/{:.0f}", parts)
             : numberText(timeStep, 6);
}

/// `before`: why the row above failed, if it did.
std::string line(const AccuracyRow& row, const std::string& before) {
  std::string text = fmt::format("  {:<11}", stepText(row.setting.timeStep));
  if (!row.failure.empty())
    return text + (row.failure == before ? "failed likewise\n" : "failed: " + row.failure + "\n");
  if (!row.error) return text + fmt::format("other cells live from {} on\n", numberText(*row.partedAt));
  text += fmt::format("{:>9.2e}{} {:>9.2e} {:>9.2e} {:>9.2e} {:>9.2e} {:>10.4f} {:>12} {:>13}", *row.error,
                      row.resolved ? " " : "~", row.errors.centroid, row.errors.volume, row.errors.surface,
                      row.birthTimes, row.cpuSeconds, row.forceEvaluations, row.vertexSteps);
  if (row.partedAt) text += fmt::format("  * up to {}: then other cells live", numberText(*row.partedAt));
  return text + "\n";
}

std::string ownText(const AccuracyReport& report) {
  const AccuracyRow& own = report.own;
  std::string text = "as it is   ";
  if (!own.failure.empty()) return text + "failed: " + own.failure + "\n";
  if (!own.error) return text + "other cells live from " + numberText(*own.partedAt) + " on\n";
  text += fmt::format("error {:.2g}{} in {:.4f} s, {} evaluations, time step {}{}\n", *own.error,
                      own.resolved ? "" : "~", own.cpuSeconds, own.forceEvaluations,
                      stepText(own.setting.timeStep), own.setting.automatic ? " at least" : "");
  if (own.partedAt)
    return text + fmt::format("           up to {}: then other cells live\n", numberText(*own.partedAt));
  return text +
         (report.rival
              ? fmt::format("           the cheapest tried that is as exact: {}, {:.4f} s, {:.2f} times "
                            "as fast\n",
                            report.rival->series, report.rival->cpuSeconds, report.rival->speed)
              : "           nothing else that was tried is as exact\n");
}

std::string orderText(const SeriesOrder& o) {
  if (!o.observed) return fmt::format("  {:<34} too few errors to fit\n", o.series);
  return fmt::format("  {:<34} {:5.2f} ± {:.2f} from {} time steps; {:g} where all is smooth\n", o.series,
                     o.observed->slope, o.observed->slopeError, o.observed->points, o.theory);
}

std::string referenceText(const AccuracyReference& r) {
  return fmt::format(
      "reference  {}, time step {}: its own error {:.2g} by Richardson, observed order {:.2g}\n"
      "witness    {}, time step {}: {:.2g} away, its own error {:.2g}: {}\n",
      name(r.setting.integrator), stepText(r.setting.timeStep), r.left.error, r.left.order,
      name(r.witness.integrator), stepText(r.witness.timeStep), r.distance, r.witnessLeft.error,
      r.agrees ? "they agree" : "THEY DO NOT AGREE");
}

}  // namespace

std::string describe(const AccuracyReport& report) {
  std::string text = fmt::format("{}: errors up to time {}, at {} times\n", report.scenario,
                                 numberText(report.times.back(), 6), report.times.size());
  text += referenceText(report.reference) + ownText(report);
  for (const std::string& remark : report.remarks) text += "remark     " + remark + "\n";
  text +=
      "\nerror: the largest of centroids and surfaces [radii of the egg] and volumes [relative], of all "
      "cells and "
      "times\n"
      "births: latest birth against the reference's [cycle lengths]\n";
  std::string series, failure;
  for (const AccuracyRow& row : report.rows) {
    if (row.series != series) {
      series = row.series, failure.clear();
      text += fmt::format(
          "\n{}{}\n  time step      error   centroid    volume   surface    births  CPU [s]   "
          "evaluations  vertex-steps\n",
          series, series == report.usual ? " (the scenario's own)" : "");
    }
    text += line(row, failure);
    failure = row.failure;
  }
  text += "\norder, from the slope of the error over the time step\n";
  for (const SeriesOrder& o : report.orders) text += orderText(o);
  text += "\nspeed at equal error, between neighbouring runs; speed 1: the scenario's own settings\n";
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
