// The findings of accuracy, as tables for a terminal and for pages.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "accuracy/accuracy.h"
#include "base/number_text.h"

namespace morula {
namespace {

std::string noteOf(const AccuracyRow& row, double referenceError) {
  std::vector<std::string> notes;
  if (row.partedAt) notes.push_back("other cells live from " + numberText(*row.partedAt) + " on");
  if (row.cut) notes.push_back("divides across another plane at " + numberText(row.cut->time));
  if (!row.resolved && row.error)
    notes.push_back("~ below ten times the reference's own error, " + numberText(referenceError, 2));
  return fmt::format("{}", fmt::join(notes, "; "));
}

Table failureTable(const std::vector<AccuracyRow>& rows) {
  Table table{"What failed", {"Settings", "Time steps", "Why"}};
  const AccuracyRow* last = nullptr;
  for (const AccuracyRow& row : rows) {
    if (row.failure.empty()) continue;
    if (last && last->series == row.series && last->failure == row.failure)
      table.rows.back()[1].words += ", " + stepText(row.setting);
    else table.rows.push_back({row.series, stepText(row.setting), row.failure});
    last = &row;
  }
  return table;
}

}  // namespace

std::string stepText(double timeStep) {
  const double parts = 1 / timeStep;
  return parts > 1 && parts < 1e9 && parts == std::floor(parts) ? "1/" + numberText(parts, 10)
                                                                : numberText(timeStep, 6);
}

std::string stepText(const Setting& setting) {
  if (!setting.automatic || setting.autoShare == 1) return stepText(setting.timeStep);
  const double parts = 1 / setting.autoShare;
  return parts == std::floor(parts) ? fmt::format("auto/{:g}", parts) : "auto*" + numberText(setting.autoShare);
}

Document settingTables(const AccuracyReport& report) {
  using Row = AccuracyRow;
  std::vector<Row> rows;
  std::ranges::copy_if(report.rows, std::back_inserter(rows), [](const Row& row) { return row.failure.empty(); });
  const auto whole = [](const Row& row) { return row.error ? std::optional(row.parts.sum()) : std::nullopt; };
  const auto ifKnown = [](const Row& row, double value) {
    return number(row.error ? std::optional(value) : std::nullopt, 3);
  };
  const auto note = [&](const Row& row) { return noteOf(row, report.reference.left.error); };
  std::vector<FieldOf<Row>> fields{
      {"Settings",
       [&](const Row& row) { return row.series + (row.series == report.usual ? " (the scenario's own)" : ""); }},
      {"Time step", [](const Row& row) { return stepText(row.setting); }},
      {"Error",
       [=](const Row& row) {
         return (row.error && !row.parts.mesh && !row.parts.model ? "≥\u00a0" : "") + number(whole(row), 3).words;
       }},
      {"time",
       [](const Row& row) { return (row.resolved || !row.error ? "" : "~\u00a0") + number(row.parts.time, 3).words; }},
      {"mesh", [](const Row& row) { return number(row.parts.mesh, 3); }},
      {"precision", [](const Row& row) { return number(row.parts.precision, 3); }},
      {"model", [](const Row& row) { return number(row.parts.model, 3); }},
      {"on mesh", [](const Row& row) { return number(row.error, 3); }},
  };
  for (const ErrorQuantity& q : errorQuantities)
    fields.push_back({nameOf(q), [=](const Row& row) { return ifKnown(row, row.errors.*q.of); }});
  fields.push_back({"births", [=](const Row& row) { return ifKnown(row, row.birthTimes); }});
  fields.push_back({"CPU time [s]", [](const Row& row) { return number(row.cpuSeconds, 3); }});
  fields.push_back({"Forces", [](const Row& row) { return row.forceEvaluations; }});
  if (std::ranges::any_of(rows, [&](const Row& row) { return !note(row).empty(); })) fields.push_back({"", note});
  Document body;
  body.say(
          "An error is at most the sum of its parts: of the time step, the mesh, the precision and the model; ≥ where "
          "the mesh's is not known. Another contact law, cell model or engine is stated with its time step, under "
          "model. On mesh: against the reference, on the scenario's mesh; the largest of positions and surfaces [radii "
          "of the egg] and volumes [relative], of all cells and times. Pressure and contact area: over the largest; "
          "neighbours: the share of the pairs that touch in one alone. Births: the latest against the reference's "
          "[cycle lengths]. Forces: how often they were evaluated.")
      .add(tableOf("Settings", fields, rows));
  if (Table failed = failureTable(report.rows); !failed.rows.empty())
    body.heading("What failed").add(std::move(failed));
  return body;
}

Table orderTable(const AccuracyReport& report) {
  using Row = SeriesOrder;
  const std::vector<FieldOf<Row>> fields{
      {"Settings", [](const Row& o) { return o.series; }},
      {"Observed",
       [](const Row& o) {
         // A line through two points leaves no residual.
         return !o.observed ? "too few errors to fit"
                : o.observed->points > 2
                    ? numberText(o.observed->slope, 3) + " ± " + numberText(o.observed->slopeError, 2)
                    : numberText(o.observed->slope, 3);
       }},
      {"Points", [](const Row& o) { return o.observed ? o.observed->points : 0; }},
      {"Order in smooth motion", [](const Row& o) { return number(o.theory, 3); }},
  };
  return tableOf("Orders", fields, report.orders);
}

Table bulletTable(const AccuracyReport& report) {
  using Row = BulletSpeed;
  const std::vector<FieldOf<Row>> fields{
      {"Error", [](const Row& s) { return number(s.error, 3); }},
      {"Morula's best", [](const Row& s) { return s.ours; }},
      {"CPU time [s]", [](const Row& s) { return number(s.ourSeconds, 3); }},
      {"Bullet's best", [](const Row& s) { return s.bullets; }},
      {"CPU time [s]", [](const Row& s) { return number(s.bulletSeconds, 3); }},
      {"times as long", [](const Row& s) { return number(s.bulletSeconds / s.ourSeconds, 3); }},
      {"with its slowest setting", [](const Row& s) { return number(s.bulletMostSeconds / s.ourSeconds, 3); }},
  };
  return tableOf("At equal error, beside Bullet", fields, report.bulletSpeeds);
}

}  // namespace morula
