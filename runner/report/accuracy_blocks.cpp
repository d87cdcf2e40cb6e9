#include "report/accuracy_blocks.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/number_text.h"
#include "charts/chart.h"
#include "drawing/palette.h"
#include "report_data/words.h"

namespace morula {

namespace {

constexpr Colour meshInk{0xa8, 0xad, 0xb3}, ownInk{0x20, 0x24, 0x28};
constexpr std::size_t mostCommands = 4;
constexpr std::size_t mostPointLabels = 60;  // of points in the chart
constexpr std::size_t fewBullets =
    4;  // of Bullet's series in the chart; of more those that others beat are left out

/// Series of Bullet's of which no point is the best in both error and cost.
bool isBeaten(const std::string& series, const std::vector<AccuracyEntry>& rows) {
  const auto counts = [](const AccuracyEntry& e) { return !e.isOurs() && e.onMesh && e.failure.empty(); };
  for (const AccuracyEntry& e : rows) {
    if (e.series != series || !counts(e)) continue;
    const bool beaten = std::any_of(rows.begin(), rows.end(), [&](const AccuracyEntry& o) {
      return counts(o) && o.series != series && *o.onMesh <= *e.onMesh && o.cpuSeconds <= e.cpuSeconds;
    });
    if (!beaten) return false;
  }
  return true;
}

std::vector<std::string> leftOut(const AccuracyRead& read) {
  std::vector<std::string> bullets, out;
  for (const AccuracyEntry& e : read.rows)
    if (!e.isOurs() && (bullets.empty() || bullets.back() != e.series)) bullets.push_back(e.series);
  if (bullets.size() <= fewBullets) return out;
  for (const std::string& series : bullets)
    if (isBeaten(series, read.rows)) out.push_back(series);
  return out;
}

Chart chartOf(const AccuracyRead& read, const std::vector<std::string>& out) {
  Chart chart;
  chart.title = "Error against cost: " + read.scenario;
  chart.caption = "up to time " + numberText(read.until, 6) + "; points: time steps" +
                  (read.reference.error ? "; reference good to " + numberText(*read.reference.error, 1) : "");
  chart.xLabel = "CPU time [s]", chart.yLabel = "error on the scenario's mesh [egg radii, relative volume]";
  chart.xScale = Axis::Scale::decades;
  std::vector<std::string> series;
  Range cost;
  for (const AccuracyEntry& e : read.rows) {
    if (!e.onMesh || !(*e.onMesh > 0) || !(e.cpuSeconds > 0) || !e.resolved || !e.failure.empty()) continue;
    if (std::find(out.begin(), out.end(), e.series) != out.end()) continue;
    if (series.empty() || series.back() != e.series) series.push_back(e.series);
    const Colour colour = seriesColour(series.size() - 1);
    cost.see(e.cpuSeconds);
    if (e.partedAt) {
      chart.marks.push_back({{e.cpuSeconds, *e.onMesh},
                             colour,
                             e.series + ", " + stepText(e.timeStep) + " until " + numberText(*e.partedAt)});
      continue;
    }
    if (chart.lines.empty() || chart.lines.back().label != e.series)
      chart.lines.push_back({e.series, colour, {}, series.size() > fewSeries, {}});
    chart.lines.back().points.push_back({e.cpuSeconds, *e.onMesh});
    chart.lines.back().pointLabels.push_back(stepText(e.timeStep));
  }
  // Of very many points only the ends of lines have room for words.
  std::size_t points = 0;
  for (const ChartLine& line : chart.lines) points += line.points.size();
  if (points > mostPointLabels)
    for (ChartLine& line : chart.lines)
      for (std::size_t k = 1; k + 1 < line.pointLabels.size(); ++k) line.pointLabels[k].clear();
  if (read.mesh.error && *read.mesh.error > 0 && cost.low < cost.high)
    chart.lines.push_back({"the mesh itself",
                           meshInk,
                           {{cost.low, *read.mesh.error}, {cost.high, *read.mesh.error}},
                           true,
                           {}});
  if (read.own.resolved && read.own.onMesh && *read.own.onMesh > 0 && read.own.cpuSeconds > 0)
    chart.marks.push_back({{read.own.cpuSeconds, *read.own.onMesh}, ownInk, "as it is"});
  return chart;
}

std::string setCommand(const AccuracyRead& read, const AccuracyEntry& e) {
  std::string command = "./morula run " + (read.file.empty() ? "SCENARIO" : shellWord(read.file));
  for (const std::string& change : e.set) command += " --set " + shellWord(change);
  return command;
}

/// The whole error of a row, with a word where it is more than `error` or not known.
Words wholeText(const AccuracyEntry& e, double error) {
  if (!e.whole) return "";
  if (!e.mesh && !e.model) return "at least " + numberText(*e.whole, 3) + ": the mesh's is not known";
  return numberText(*e.whole, 3) + " " + (*e.whole > error ? Words("! more", Look::warning) : Words("✓", Look::good));
}

/// "velocity-verlet, time step 1/256".
std::string nameOf(const AccuracyEntry& e) { return e.series + ", time step " + stepText(e.timeStep); }

Table besideTable(const AccuracyRead& read) {
  const std::vector<Field<AccuracyRead::BulletSpeed>> fields{
      {"Error", [](const auto& s) { return number(s.error, 3); }},
      {"Ours at best", [](const auto& s) { return s.series; }},
      {"CPU time [s]", [](const auto& s) { return number(s.ours, 3); }},
      {"Bullet at its best", [](const auto& s) { return s.bulletSeries; }},
      {"CPU time [s]", [](const auto& s) { return number(s.bullets, 3); }},
      {"times as long", [](const auto& s) { return number(s.bullets / s.ours, 3); }},
      {"with its slowest setting", [](const auto& s) { return number(s.slowest / s.ours, 3); }},
  };
  return tableOf("At equal error, beside Bullet", fields, read.besideBullet);
}

Table failureTable(const AccuracyRead& read) {
  Table table{"What failed", {"Settings", "Time steps", "Why"}};
  std::vector<std::pair<std::string, std::string>> told;  // series, reason
  for (const AccuracyEntry& e : read.rows) {
    if (e.failure.empty()) continue;
    if (!told.empty() && told.back() == std::pair(e.series, e.failure)) {
      table.rows.back()[1].words += ", " + stepText(e.timeStep);
      continue;
    }
    told.push_back({e.series, e.failure});
    table.rows.push_back({e.series, stepText(e.timeStep), e.failure});
  }
  return table;
}

std::string noteOf(const AccuracyEntry& e, double referenceError) {
  std::string note;
  if (e.partedAt) note = "other cells live from " + numberText(*e.partedAt) + " on";
  if (e.cutElsewhere) note += (note.empty() ? "" : "; ") + std::string("divides across another plane");
  if (!e.resolved && e.onMesh)
    note += (note.empty() ? "" : "; ") + std::string("~ below ten times the reference's own error, ") +
            numberText(referenceError, 2);
  return note;
}

}  // namespace

std::string stepText(double timeStep) {
  const double parts = 1 / timeStep;
  return parts > 1 && parts < 1e9 && parts == std::floor(parts) ? "1/" + numberText(parts, 10)
                                                                : numberText(timeStep, 6);
}

Section accuracyChartSection(const AccuracyRead& read) {
  const auto out = leftOut(read);
  const std::string caption =
      "CPU time is of the machine that ran it. Errors on the scenario's own mesh; grey: what that mesh itself adds." +
      (out.empty()
           ? ""
           : " " + counted(out.size(), "setting") +
                 " of Bullet's that others of its own beat in error and time are in the table alone.");
  return {"accuracy",
          "Error against cost",
          Document().add(svgPicture(drawChart(chartOf(read, out)), "error against CPU time, a line for each series of settings",
                                    caption, Picture::Size::large))};
}

Section cheapestSection(const AccuracyRead& read) {
  Section section{"cheapest", "Cheapest settings for an error", {}};
  Table table{section.title,
              {"Error at most", "Settings of ours", "CPU time [s]", "Error on the scenario's mesh", "Whole error, with the mesh's"}};
  const bool bullet =
      std::any_of(read.rows.begin(), read.rows.end(), [](const auto& e) { return !e.isOurs(); });
  for (int decade = 1; decade <= 12; ++decade) {
    const double error = std::pow(10.0, -decade);
    const AccuracyEntry *ours = cheapestFor(read, error, true), *theirs = cheapestFor(read, error, false);
    if (!ours && !theirs) continue;
    std::vector<Cell> row{number(error, 3)};
    if (ours) {
      row.insert(row.end(), {nameOf(*ours), number(ours->cpuSeconds, 3), number(ours->onMesh, 3), wholeText(*ours, error)});
      const std::string command = setCommand(read, *ours);
      if (section.commands.size() < mostCommands &&
          std::find(section.commands.begin(), section.commands.end(), command) == section.commands.end())
        section.commands.push_back(command);
    } else row.insert(row.end(), {"none of those tried", "", "", ""});
    if (bullet && theirs)
      row.insert(row.end(), {nameOf(*theirs), number(theirs->cpuSeconds, 3),
                             ours ? number(theirs->cpuSeconds / ours->cpuSeconds, 3) : Cell()});
    else if (bullet) row.insert(row.end(), {"none of those tried", "", ""});
    table.rows.push_back(std::move(row));
  }
  if (bullet) table.columns.insert(table.columns.end(), {"Bullet's best", "CPU time [s]", "times as long"});
  if (table.rows.empty())
    section.body.say(warning() + "None of the settings tried holds an error of 0.1.");
  else
    section.body
        .say("Of the runs made: each row's error, with the reference's own added, is at most that. The mesh's error is the same "
             "for all time steps and stands apart.")
        .add(std::move(table));
  if (!read.besideBullet.empty())
    section.body.heading("At equal error, beside Bullet")
        .say("Between neighbouring runs of a series, the least CPU time of all settings tried.")
        .add(besideTable(read));
  return section;
}

Section settingsSection(const AccuracyRead& read) {
  using Row = AccuracyEntry;
  std::vector<Row> rows;
  std::ranges::copy_if(read.rows, std::back_inserter(rows), [](const Row& e) { return e.failure.empty(); });
  const auto note = [&](const Row& e) { return noteOf(e, read.referenceError()); };
  std::vector<Field<Row>> fields{
      {"Settings", [](const Row& e) { return e.series; }},
      {"Time step", [](const Row& e) { return stepText(e.timeStep); }},
      {"Error", [](const Row& e) { return (e.whole && !e.mesh && !e.model ? "≥\u00a0" : "") + number(e.whole, 3).words; }},
      {"time", [](const Row& e) { return (e.resolved || !e.onMesh ? "" : "~\u00a0") + number(e.time, 3).words; }},
      {"mesh", [](const Row& e) { return number(e.mesh, 3); }},
      {"precision", [](const Row& e) { return number(e.precision, 3); }},
      {"model", [](const Row& e) { return number(e.model, 3); }},
      {"on mesh", [](const Row& e) { return number(e.onMesh, 3); }},
      {"CPU time [s]", [](const Row& e) { return number(e.cpuSeconds, 3); }},
      {"Forces", [](const Row& e) { return e.evaluations; }},
  };
  if (std::ranges::any_of(rows, [&](const Row& e) { return !note(e).empty(); })) fields.push_back({"", note});
  Section section{"rows", "Settings", {}};
  section.body
      .say("An error is at most the sum of its parts: of the time step, the mesh, the precision and the model; ≥ where the mesh's "
           "is not known. Another contact law, cell model or engine is stated with its time step, under model. On mesh: against "
           "the reference, on the scenario's mesh. Forces: how often they were evaluated.")
      .add(tableOf("Settings", fields, rows));
  if (Table failed = failureTable(read); !failed.rows.empty()) section.body.heading("What failed").add(std::move(failed));
  return section;
}

Section referenceSection(const AccuracyRead& read) {
  const auto& r = read.reference;
  const auto orUnknown = [](const std::optional<double>& a) { return a ? numberText(*a, 3) : "not known"; };
  Section section{"reference", "What errors are held against", {}};
  section.body.add(Table{"Reference",
                         {},
                         {{"Reference", r.integrator + ", time step " + stepText(r.timeStep)},
                          {"Its own error, by Richardson", orUnknown(r.error)},
                          {"Order observed", r.order > 0 ? numberText(r.order, 3) : "none: it does not converge"},
                          {"Witness", r.witness + ", time step " + stepText(r.witnessTimeStep)},
                          {"Distance of the two", orUnknown(r.witnessDistance)},
                          {"The witness' own error", orUnknown(r.witnessError)},
                          {"They agree", mark(r.agrees, "yes", "no")}}});
  const auto& m = read.mesh;
  const std::vector<Field<AccuracyMeshLevel>> ofMeshes{
      {"Icosphere",
       [&](const auto& l) { return std::to_string(l.icosphere) + (m.icosphere == l.icosphere ? " (the scenario's)" : ""); }},
      {"Error", [](const auto& l) { return number(l.error, 3); }},
      {"Position", [](const auto& l) { return number(l.position, 3); }},
      {"Volume", [](const auto& l) { return number(l.volume, 3); }},
      {"Surface", [](const auto& l) { return number(l.surface, 3); }},
      {"Pressure", [](const auto& l) { return number(l.pressure, 3); }},
      {"Contact area", [](const auto& l) { return number(l.contactArea, 3); }},
  };
  if (!m.levels.empty())
    section.body.heading("Meshes")
        .add(tableOf("Meshes", ofMeshes, m.levels))
        .note((m.order > 0 ? "Order " + numberText(m.order, 3) +
                                 (m.orderIsObserved ? ", observed" : ", assumed: there are only two meshes")
                           : "Errors do not fall from mesh to mesh, so nothing is extrapolated") +
              std::string("."));
  const std::vector<Field<AccuracyRead::Order>> ofOrders{
      {"Settings", [](const auto& o) { return o.series; }},
      {"Observed",
       [](const auto& o) {
         return !o.observed    ? "too few errors to fit"
                : o.points > 2 ? numberText(*o.observed, 3) + " ± " + numberText(o.standardError, 2)
                               : numberText(*o.observed, 3);
       }},
      {"Points", [](const auto& o) { return o.points; }},
      {"Where all is smooth", [](const auto& o) { return number(o.theory, 3); }},
  };
  if (!read.orders.empty())
    section.body.heading("Orders")
        .say("How fast errors fall with the time step: contact, shell and friction lower it.")
        .add(tableOf("Orders", ofOrders, read.orders));
  return section;
}

}  // namespace morula
