#include "report/accuracy_blocks.h"

#include <algorithm>
#include <cmath>

#include "accuracy/tables.h"
#include "base/number_text.h"
#include "report_data/words.h"
#include "system/installation.h"

namespace morula {
namespace {

constexpr std::size_t mostCommands = 4;

std::string setCommand(const AccuracyRow& row, const std::string& scenario) {
  std::string command = programWord() + " run " + scenario;
  for (const std::string& change : row.set) command += " --set " + shellWord(change);
  return command;
}

/// The whole error of a row, with a word where it is more than `error` or not known.
Words wholeText(const AccuracyRow& row, double error) {
  const double whole = row.parts.sum();
  if (!row.parts.mesh && !row.parts.model) return "at least " + numberText(whole, 3) + ": the mesh's is not known";
  return numberText(whole, 3) + " " + (whole > error ? Words("! more", Emphasis::warning) : Words("✓", Emphasis::good));
}

/// "velocity-verlet, time step 1/256".
std::string nameOfRow(const AccuracyRow& row) { return row.series + ", time step " + stepText(row.setting); }

/// What may be infinite, which is not known.
std::string orUnknown(double error) { return std::isfinite(error) ? numberText(error, 3) : "not known"; }

}  // namespace

PageSection accuracyChartSection(const AccuracyReport& report) {
  const std::size_t out = beatenBullets(report).size();
  const std::string caption =
      "CPU time is of the machine that ran it. Errors on the scenario's own mesh; grey: what that mesh itself adds." +
      (out ? " " + counted(out, "setting") +
                 " of Bullet's that others of its own beat in error and time are in the table alone."
           : "");
  return {"accuracy", "Error against cost",
          Document().add(svgPicture(drawAccuracy(report), "error against CPU time, a line for each series of settings",
                                    caption, Picture::Size::large))};
}

PageSection cheapestSection(const AccuracyReport& report, const std::string& scenario) {
  PageSection section{"cheapest", "Cheapest settings for an error", {}};
  Table table{section.title,
              {"Error at most", "Settings of ours", "CPU time [s]", "Error on the scenario's mesh",
               "Whole error, with the mesh's"}};
  const bool bullet = std::ranges::any_of(report.rows, [](const AccuracyRow& row) { return row.engine != "morula"; });
  if (bullet) table.columns.insert(table.columns.end(), {"Bullet's best", "CPU time [s]", "times as long"});
  for (int decade = 1; decade <= 12; ++decade) {
    const double error = std::pow(10.0, -decade);
    const auto ours = thatHold(report, error), theirs = thatHold(report, error, false);
    if (ours.empty() && theirs.empty()) continue;
    std::vector<Cell> row{number(error, 3)};
    if (ours.empty()) row.insert(row.end(), {"none of those tried", "", "", ""});
    else {
      const AccuracyRow& best = *ours.front();
      row.insert(row.end(),
                 {nameOfRow(best), number(best.cpuSeconds, 3), number(best.error, 3), wholeText(best, error)});
      const std::string command = setCommand(best, scenario);
      if (section.commands.size() < mostCommands &&
          std::ranges::find(section.commands, command) == section.commands.end())
        section.commands.push_back(command);
    }
    if (bullet && theirs.empty()) row.insert(row.end(), {"none of those tried", "", ""});
    else if (bullet) {
      const AccuracyRow& best = *theirs.front();
      row.insert(row.end(), {nameOfRow(best), number(best.cpuSeconds, 3),
                             ours.empty() ? Cell() : number(best.cpuSeconds / ours.front()->cpuSeconds, 3)});
    }
    table.rows.push_back(std::move(row));
  }
  if (table.rows.empty()) section.body.say(warning() + "None of the settings tried holds an error of 0.1.");
  else
    section.body
        .say(
            "Of the runs made: each row's error, with the reference's own added, is at most that. The mesh's error is "
            "the same for all time steps and stands apart.")
        .add(std::move(table));
  if (!report.bulletSpeeds.empty())
    section.body.heading("At equal error, beside Bullet")
        .say("Between neighbouring runs of a series, the least CPU time of all settings tried.")
        .add(bulletTable(report));
  return section;
}

PageSection referenceSection(const AccuracyReport& report) {
  const AccuracyReference& r = report.reference;
  const auto nameOfSetting = [](const Setting& s) {
    return nameOf(s.integrator) + (", time step " + stepText(s.timeStep));
  };
  PageSection section{"reference", "What errors are held against", {}};
  section.body.add(
      Table{"Reference",
            {},
            {{"Reference", nameOfSetting(r.setting)},
             {"Its own error, by Richardson", orUnknown(r.left.error)},
             {"Order observed", r.left.order > 0 ? numberText(r.left.order, 3) : "none: it does not converge"},
             {"Witness", nameOfSetting(r.witness)},
             {"Distance of the two", orUnknown(r.distance)},
             {"The witness' own error", orUnknown(r.witnessLeft.error)},
             {"They agree", mark(r.agrees, "yes", "no")}}});
  using Row = LevelError;
  const MeshError& mesh = report.mesh;
  const std::vector<FieldOf<Row>> fields{
      {"Icosphere",
       [&](const Row& l) { return std::to_string(l.level) + (l.level == mesh.own ? " (the scenario's)" : ""); }},
      {"Error", [](const Row& l) { return number(l.worst.largest(), 3); }},
      {"Position", [](const Row& l) { return number(l.worst.centroid, 3); }},
      {"Volume", [](const Row& l) { return number(l.worst.volume, 3); }},
      {"Surface", [](const Row& l) { return number(l.worst.surface, 3); }},
      {"Pressure", [](const Row& l) { return number(l.worst.pressure, 3); }},
      {"Contact area", [](const Row& l) { return number(l.worst.contactArea, 3); }},
  };
  if (!mesh.levels.empty())
    section.body.heading("Meshes")
        .add(tableOf("Meshes", fields, mesh.levels))
        .note(mesh.order > 0 ? "Order " + numberText(mesh.order, 3) +
                                   (mesh.orderIsObserved ? ", observed." : ", assumed: there are only two meshes.")
                             : "Errors do not fall from mesh to mesh, so nothing is extrapolated.");
  if (!report.orders.empty())
    section.body.heading("Orders")
        .say("How fast errors fall with the time step: contact, shell and friction lower it.")
        .add(orderTable(report));
  return section;
}

}  // namespace morula
