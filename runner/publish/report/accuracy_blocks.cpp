#include "report/accuracy_blocks.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/number_text.h"
#include "charts/chart.h"
#include "drawing/palette.h"

namespace morula {

namespace {

constexpr Colour meshInk{0xa8, 0xad, 0xb3}, ownInk{0x20, 0x24, 0x28};
constexpr std::size_t mostCommands = 4;
constexpr std::size_t mostPointLabels = 60;  // of points in the chart
constexpr std::size_t fewBullets =
    4;  // of Bullet's series in the chart; of more those that others beat are left out

std::string number(const std::optional<double>& a, int digits = 3) { return a ? numberText(*a, digits) : ""; }

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
std::string wholeText(const AccuracyEntry& e, double error) {
  if (!e.whole) return "";
  if (!e.mesh && !e.model) return "at least " + numberText(*e.whole, 3) + ": the mesh's is not known";
  return numberText(*e.whole, 3) + (*e.whole > error ? " <span class=\"mark warn\">! more</span>"
                                                     : " <span class=\"mark good\">✓</span>");
}

/// "velocity-verlet, time step 1/256".
std::string nameOf(const AccuracyEntry& e) { return e.series + ", time step " + stepText(e.timeStep); }

std::string besideTable(const AccuracyRead& read) {
  if (read.besideBullet.empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const auto& s : read.besideBullet)
    rows.push_back({numberText(s.error, 3), shown(s.series), numberText(s.ours, 3), shown(s.bulletSeries),
                    numberText(s.bullets, 3), numberText(s.bullets / s.ours, 3),
                    numberText(s.slowest / s.ours, 3)});
  return "<h3>At equal error, beside Bullet</h3>\n<p>Between neighbouring runs of a series, the least CPU "
         "time "
         "of all settings tried.</p>\n" +
         htmlTable("At equal error, beside Bullet",
                   {"Error", "Ours at best", "CPU time [s]", "Bullet at its best", "CPU time [s]",
                    "times as long", "with its slowest setting"},
                   rows);
}

std::string failureTable(const AccuracyRead& read) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::pair<std::string, std::string>> told;  // series, reason
  for (const AccuracyEntry& e : read.rows) {
    if (e.failure.empty()) continue;
    if (!told.empty() && told.back() == std::pair(e.series, e.failure)) {
      rows.back()[1] += ", " + stepText(e.timeStep);
      continue;
    }
    told.push_back({e.series, e.failure});
    rows.push_back({shown(e.series), stepText(e.timeStep), shown(e.failure)});
  }
  if (rows.empty()) return {};
  return "<h3>What failed</h3>\n" + htmlTable("What failed", {"Settings", "Time steps", "Why"}, rows);
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

PageBlock accuracyChartBlock(const AccuracyRead& read) {
  const auto out = leftOut(read);
  const std::string caption =
      "CPU time is of the machine that ran it. Errors on the scenario's own mesh; grey: what that mesh "
      "itself "
      "adds." +
      (out.empty()
           ? ""
           : " " + counted(out.size(), "setting") +
                 " of Bullet's that others of its own beat in error and time are in the table alone.");
  return {"accuracy",
          "Error against cost",
          htmlLarge("image/svg+xml", drawChart(chartOf(read, out)).file(PictureFormat::svg),
                    "error against CPU time, a line for each series of settings", caption),
          {}};
}

PageBlock cheapestBlock(const AccuracyRead& read) {
  PageBlock block{"cheapest", "Cheapest settings for an error", "", {}};
  std::vector<std::vector<std::string>> rows;
  const bool bullet =
      std::any_of(read.rows.begin(), read.rows.end(), [](const auto& e) { return !e.isOurs(); });
  for (int decade = 1; decade <= 12; ++decade) {
    const double error = std::pow(10.0, -decade);
    const AccuracyEntry *ours = cheapestFor(read, error, true), *theirs = cheapestFor(read, error, false);
    if (!ours && !theirs) continue;
    std::vector<std::string> row{numberText(error, 3)};
    if (ours) {
      row.insert(row.end(), {shown(nameOf(*ours)), numberText(ours->cpuSeconds, 3), number(ours->onMesh),
                             wholeText(*ours, error)});
      const std::string command = setCommand(read, *ours);
      if (block.commands.size() < mostCommands &&
          std::find(block.commands.begin(), block.commands.end(), command) == block.commands.end())
        block.commands.push_back(command);
    } else row.insert(row.end(), {"none of those tried", "", "", ""});
    if (bullet && theirs)
      row.insert(row.end(), {shown(nameOf(*theirs)), numberText(theirs->cpuSeconds, 3),
                             ours ? numberText(theirs->cpuSeconds / ours->cpuSeconds, 3) : ""});
    else if (bullet) row.insert(row.end(), {"none of those tried", "", ""});
    rows.push_back(std::move(row));
  }
  std::vector<std::string> head{"Error at most", "Settings of ours", "CPU time [s]",
                                "Error on the scenario's mesh", "Whole error, with the mesh's"};
  if (bullet) head.insert(head.end(), {"Bullet's best", "CPU time [s]", "times as long"});
  block.html = rows.empty() ? "<p><span class=\"mark warn\">! Warning</span>None of the settings tried holds "
                              "an error of 0.1.</p>\n"
                            : "<p>Of the runs made: each row's error, with the reference's own added, is at "
                              "most that. The mesh's "
                              "error is the same for all time steps and stands apart.</p>\n" +
                                  htmlTable("Cheapest settings for an error", head, rows);
  block.html += besideTable(read);
  return block;
}

PageBlock settingsBlock(const AccuracyRead& read) {
  std::vector<std::vector<std::string>> rows;
  bool anyNote = false;
  for (const AccuracyEntry& e : read.rows) {
    if (!e.failure.empty()) continue;
    const std::string note = noteOf(e, read.referenceError());
    anyNote = anyNote || !note.empty();
    rows.push_back({shown(e.series), stepText(e.timeStep),
                    e.whole ? (e.mesh || e.model ? "" : "≥\u00a0") + numberText(*e.whole, 3) : "",
                    (e.resolved || !e.onMesh ? "" : "~\u00a0") + number(e.time), number(e.mesh),
                    number(e.precision), number(e.model), number(e.onMesh), numberText(e.cpuSeconds, 3),
                    std::to_string(e.evaluations), shown(note)});
  }
  std::vector<std::string> head{"Settings",  "Time step", "Error",   "time",         "mesh",
                                "precision", "model",     "on mesh", "CPU time [s]", "Forces"};
  if (anyNote) head.push_back("");
  else
    for (auto& row : rows) row.pop_back();
  return {"rows",
          "Settings",
          "<p>An error is at most the sum of its parts: of the time step, the mesh, the precision and the "
          "model; ≥ "
          "where the mesh's is not known. Another contact law, cell model or engine is stated with its time "
          "step, "
          "under model. On mesh: against the reference, on the scenario's mesh. Forces: how often they were "
          "evaluated.</p>\n" +
              htmlTable("Settings", head, rows) + failureTable(read),
          {}};
}

PageBlock referenceBlock(const AccuracyRead& read) {
  const auto& r = read.reference;
  std::vector<std::vector<std::string>> facts{
      {"Reference", shown(r.integrator + ", time step " + stepText(r.timeStep))},
      {"Its own error, by Richardson", r.error ? numberText(*r.error, 3) : "not known"},
      {"Order observed", r.order > 0 ? numberText(r.order, 3) : "none: it does not converge"},
      {"Witness", shown(r.witness + ", time step " + stepText(r.witnessTimeStep))},
      {"Distance of the two", r.witnessDistance ? numberText(*r.witnessDistance, 3) : "not known"},
      {"The witness' own error", r.witnessError ? numberText(*r.witnessError, 3) : "not known"},
      {"They agree",
       r.agrees ? "<span class=\"mark good\">✓ yes</span>" : "<span class=\"mark bad\">✗ no</span>"}};
  std::string html = htmlTable("Reference", {}, facts);
  const auto& m = read.mesh;
  if (!m.levels.empty()) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& level : m.levels)
      rows.push_back({std::to_string(level.icosphere) +
                          (m.icosphere && *m.icosphere == level.icosphere ? " (the scenario's)" : ""),
                      numberText(level.error, 3), numberText(level.position, 3), numberText(level.volume, 3),
                      numberText(level.surface, 3), numberText(level.pressure, 3),
                      numberText(level.contactArea, 3)});
    html +=
        "<h3>Meshes</h3>\n" +
        htmlTable("Meshes",
                  {"Icosphere", "Error", "Position", "Volume", "Surface", "Pressure", "Contact area"}, rows) +
        "<p class=\"note\">" +
        (m.order > 0 ? "Order " + numberText(m.order, 3) +
                           (m.orderIsObserved ? ", observed" : ", assumed: there are only two meshes")
                     : std::string("Errors do not fall from mesh to mesh, so nothing is extrapolated")) +
        ".</p>\n";
  }
  std::vector<std::vector<std::string>> orders;
  for (const auto& o : read.orders)
    orders.push_back({shown(o.series),
                      !o.observed    ? "too few errors to fit"
                      : o.points > 2 ? numberText(*o.observed, 3) + " ± " + numberText(o.standardError, 2)
                                     : numberText(*o.observed, 3),
                      std::to_string(o.points), numberText(o.theory, 3)});
  if (!orders.empty())
    html +=
        "<h3>Orders</h3>\n<p>How fast errors fall with the time step: contact, shell and friction lower "
        "it.</p>\n" +
        htmlTable("Orders", {"Settings", "Observed", "Points", "Where all is smooth"}, orders);
  return {"reference", "What errors are held against", html, {}};
}

}  // namespace morula
