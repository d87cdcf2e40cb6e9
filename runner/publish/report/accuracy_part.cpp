// The part of a page on an accuracy run: its verdict and its sections.
#include <algorithm>
#include <cmath>

#include "accuracy/accuracy.h"
#include "base/number_text.h"
#include "document/document.h"
#include "files/read_file.h"
#include "report/page_parts.h"
#include "report_data/run_words.h"
#include "system/installation.h"
#include "system/json_record.h"

namespace morula {
namespace {

constexpr std::size_t maxCommands = 4;

std::string setCommand(const AccuracyRow& row, const std::string& scenario) {
  std::string command = programWord() + " run " + scenario;
  for (const std::string& change : row.set) command += " --set " + shellWord(change);
  return command;
}

/// Returns the whole error of a row, marked if it is above `error` or unknown.
Words wholeText(const AccuracyRow& row, double error) {
  const double whole = row.parts.sum();
  if (!row.parts.mesh && !row.parts.model)
    return "at least " + numberText(whole, 3) + ": the mesh's error is not known";
  return numberText(whole, 3) + " " + (whole > error ? Words("! more", Emphasis::warning) : Words("✓", Emphasis::good));
}

/// Returns a row's name: "velocity-verlet, time step 1/256".
std::string nameOfRow(const AccuracyRow& row) { return row.series + ", time step " + stepText(row.setting); }

/// Writes an error; an infinite error is "not known".
std::string orUnknown(double error) { return std::isfinite(error) ? numberText(error, 3) : "not known"; }

/// Makes the chart of error against CPU time: a line for each series, a point for each time step, a line across for the
/// mesh's own error, and the scenario's own settings.
PageSection accuracyChartSection(const AccuracyReport& report) {
  const std::size_t out = beatenBullets(report).size();
  const std::string caption =
      "CPU times are those of the machine that ran the settings. Errors are on the scenario's own mesh; grey: the "
      "error of that mesh itself." +
      (out ? " " + counted(out, "setting") +
                 " of Bullet's with both larger errors and longer times than others of Bullet's are in the table "
                 "alone."
           : "");
  return {"accuracy", "Error against cost",
          Document().add(svgPicture(drawAccuracy(report), "error against CPU time, a line for each series of settings",
                                    caption, Picture::Size::large))};
}

/// Lists for errors of 0.1, 0.01, … the settings that reach them with the least CPU time, Morula's and Bullet's, and
/// the mesh's part. `scenario`: its file, as a word of a command.
PageSection cheapestSection(const AccuracyReport& report, const std::string& scenario) {
  PageSection section{"cheapest", "Cheapest settings for an error", {}};
  Table table{section.title,
              {"Error at most", "Morula's settings", "CPU time [s]", "Error on the scenario's mesh",
               "Whole error, including the mesh's"}};
  const bool bullet =
      std::ranges::any_of(report.rows, [](const AccuracyRow& row) { return row.engine != MeasuredEngine::morula; });
  if (bullet) table.columns.insert(table.columns.end(), {"Bullet's best", "CPU time [s]", "times as long"});
  for (int decade = 1; decade <= 12; ++decade) {
    const double error = std::pow(10.0, -decade);
    const auto ours = thatHold(report, error), theirs = thatHold(report, error, false);
    if (ours.empty() && theirs.empty()) continue;
    std::vector<Cell> row{number(error, 3)};
    if (ours.empty()) row.insert(row.end(), {"none of the settings tried", "", "", ""});
    else {
      const AccuracyRow& best = *ours.front();
      row.insert(row.end(),
                 {nameOfRow(best), number(best.cpuSeconds, 3), number(best.error, 3), wholeText(best, error)});
      const std::string command = setCommand(best, scenario);
      if (section.commands.size() < maxCommands &&
          std::ranges::find(section.commands, command) == section.commands.end())
        section.commands.push_back(command);
    }
    if (bullet && theirs.empty()) row.insert(row.end(), {"none of the settings tried", "", ""});
    else if (bullet) {
      const AccuracyRow& best = *theirs.front();
      row.insert(row.end(), {nameOfRow(best), number(best.cpuSeconds, 3),
                             ours.empty() ? Cell() : number(best.cpuSeconds / ours.front()->cpuSeconds, 3)});
    }
    table.rows.push_back(std::move(row));
  }
  if (table.rows.empty()) section.body.say(warning() + "None of the settings tried has an error of at most 0.1.");
  else
    section.body
        .say(
            "Settings of the runs made whose error, with the reference's own added, is at most that of the row. The "
            "mesh's error is the same for all time steps and stands apart.")
        .add(std::move(table));
  if (!report.bulletSpeeds.empty())
    section.body.heading("At equal error, beside Bullet")
        .say("Least CPU times of all settings tried, between neighbouring runs of a series.")
        .add(bulletTable(report));
  return section;
}

/// Shows the reference of errors: the converged solution, finer meshes, and the decrease of errors with the time step.
PageSection referenceSection(const AccuracyReport& report) {
  const AccuracyReference& r = report.reference;
  const auto nameOfSetting = [](const Setting& s) {
    return nameOf(s.integrator) + (", time step " + stepText(s.timeStep));
  };
  PageSection section{"reference", "Reference of the errors", {}};
  section.body.add(Table{
      "Reference",
      {},
      {{"Reference", nameOfSetting(r.setting)},
       {"Its own error, by Richardson", orUnknown(r.left.error)},
       {"Order observed", r.left.order > 0 ? numberText(r.left.order, 3) : "none: the reference does not converge"},
       {"Witness", nameOfSetting(r.witness)},
       {"Distance of witness and reference", orUnknown(r.distance)},
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
        .say("Orders of convergence with the time step; contact, shell and viscosity lower them.")
        .add(orderTable(report));
  return section;
}

using Kind = Finding::Kind;

/// Returns "error 0.0927 up to time 4 of 31.25: 0.00535 of the time step, 0.0874 of the mesh".
std::string sentenceOf(const AccuracyReport& report) {
  const AccuracyRow& own = report.own;
  const std::string start = report.scenario + " as it is";
  if (!own.failure.empty()) return start + " does not come to its end.";
  if (!own.error) return start + ": not compared, because other cells live.";
  std::string text = start + ": error " + (own.parts.mesh ? "" : "at least ") + numberText(own.parts.sum(), 3);
  const auto add = [&](const std::optional<double>& part, const std::string& of) {
    text += (part ? numberText(*part, 3) : std::string("an unknown part")) + " of " + of;
  };
  text += ": ";
  add(own.parts.time, "the time step");
  text += ", ";
  add(own.parts.mesh, "the mesh");
  return text + " [radii of the egg, relative volume].";
}

void judgeReference(const AccuracyReport& report, std::vector<Finding>& findings) {
  const AccuracyReference& r = report.reference;
  const std::string witness = nameOf(r.witness.integrator);
  const bool converged = std::isfinite(r.left.error) && r.left.order > 0;
  if (!converged)
    findings.push_back({Kind::bad,
                        "The reference has not converged: its own error does not fall with its time step, so no "
                        "error on this page is reliable"});
  if (!r.agrees)
    findings.push_back({Kind::bad, "The reference is not confirmed: the witness, " + witness +
                                       ", is farther away than the errors of both allow"});
  if (r.agrees && converged)
    findings.push_back({Kind::good, "The reference, good to " + numberText(r.left.error, 2) +
                                        ", is confirmed by another integrator, " + witness});
}

void judgeMesh(const AccuracyReport& report, std::vector<Finding>& findings) {
  const MeshError& m = report.mesh;
  if (!m.unknown.empty())
    findings.push_back(
        {Kind::warning, "The mesh's error is not known, so whole errors may be larger than stated: " + m.unknown});
  else if (!m.levels.empty() && m.order < minMeshOrder)
    findings.push_back(
        {Kind::warning, "Errors hardly fall from mesh to mesh: the mesh's error may be larger than stated"});
  if (!m.limit.empty()) findings.push_back({Kind::warning, "No finer mesh was computed: " + m.limit});
  if (m.partedAt)
    findings.push_back({Kind::warning, "On another mesh other cells live from " + numberText(*m.partedAt) + " on"});
  const auto error = m.error(), time = report.own.parts.time;
  if (error && time && *error > 3 * *time && *error > 0)
    findings.push_back(
        {Kind::warning,
         "The error of the mesh is " +
             (*time > 0 ? numberText(*error / *time, 2) + " times the error of the time step" : "the whole error") +
             ", so shorter time steps gain little"});
}

void judgeRows(const AccuracyReport& report, std::vector<Finding>& findings) {
  if (!report.own.failure.empty())
    findings.push_back({Kind::bad, "The scenario as it is failed: " + report.own.failure});
  else if (report.own.partedAt)
    findings.push_back({Kind::bad, "The scenario as it is has other cells than the reference from time " +
                                       numberText(*report.own.partedAt) + " on"});
  else if (!report.own.resolved)
    findings.push_back({Kind::warning, "The error of the scenario as it is is below ten times the reference's own"});
  const double until = report.times.back();
  if (report.end && until < *report.end * (1 - 1e-6))
    findings.push_back({Kind::warning, "Compared up to time " + numberText(until, 6) + " of " +
                                           numberText(*report.end, 6) + ": later times are not compared"});
  std::size_t failed = 0, parted = 0;
  for (const AccuracyRow& row : report.rows) failed += !row.failure.empty(), parted += row.partedAt.has_value();
  if (failed)
    findings.push_back({Kind::warning, std::to_string(failed) + " of " + counted(report.rows.size(), "setting") +
                                           " failed; a table lists the reasons"});
  if (parted)
    findings.push_back({Kind::warning, std::to_string(parted) + " of " + counted(report.rows.size(), "setting") +
                                           " end with other cells than the reference"});
  for (const std::string& remark : report.remarks) findings.push_back({Kind::warning, remark});
  if (report.rival)
    findings.push_back(
        {Kind::good, "The cheapest settings tried that are as exact on this mesh: " + report.rival->series + ", " +
                         numberText(report.rival->speed, 3) + " times as fast as the scenario as it is"});
}

/// Adds the findings of --target.
void judgeTarget(const Json& t, std::vector<Finding>& findings) {
  const std::string error = numberText(t.at("error").get<double>(), 3);
  const Json& best = t.at("run_to_the_end");
  if (!best.is_object()) {
    findings.push_back(
        {Kind::bad, "None of the settings tried has an error of at most " + error + " and reaches the end"});
    return;
  }
  std::string command = programWord();
  for (const Json& word : best.at("command")) command += " " + shellWord(word.get<std::string>());
  const bool holds = t.at("mesh_holds").is_boolean() && t.at("mesh_holds").get<bool>();
  findings.push_back(
      {holds ? Kind::good : Kind::warning,
       "An error of " + error + " on the scenario's mesh is held for the least CPU time, " +
           numberText(best.at("cpu_seconds").get<double>(), 3) + " s to its end, by " + code(command) +
           (holds ? "; the mesh's error is included"
            : t.at("mesh_error").is_number()
                ? "; the mesh's own error, " + numberText(t.at("mesh_error").get<double>(), 3) + ", is not included"
                : "; the mesh's error is not known")});
  if (t.at("icosphere_that_holds").is_number() && !holds)
    findings.push_back({Kind::warning, "To hold the whole error takes icosphere " +
                                           std::to_string(wholeFrom<int>(t.at("icosphere_that_holds")))});
}

PageSection madeBy(const Json& json, const std::string& scenario, const std::string& file) {
  PageSection section{"made-by",
                      "Provenance",
                      {},
                      {programWord() + " accuracy " + scenario + " --json > " + shellWord(file),
                       programWord() + " report " + shellWord(file)}};
  Table table{section.title, {}};
  if (json.contains("made_by"))
    for (const auto& [name, value] : json.at("made_by").items()) table.rows.push_back({name, value.get<std::string>()});
  if (table.rows.empty()) section.body.say("The output does not name the program and the machine that made it.");
  else section.body.add(std::move(table));
  return section;
}

}  // namespace

PagePart accuracyPart(const std::string& file) {
  const std::string text = readFile(file);
  const Json json = tryParseJson(text);
  const std::string right = "; needs what morula accuracy --json has printed";
  if (!json.is_object() || !json.contains("rows"))
    throw InputError(file + ": the file has no rows of an accuracy run" + right);
  try {
    const AccuracyReport report = accuracyFrom(json);
    const std::string scenario = json.contains("file") ? shellWord(json.at("file").get<std::string>()) : "SCENARIO";
    PagePart part{.title = "Accuracy of " + report.scenario, .summary = "Cost of accuracy: error against CPU time"};
    std::vector<Finding> findings;
    if (json.contains("target")) judgeTarget(json.at("target"), findings);
    judgeReference(report, findings);
    judgeMesh(report, findings);
    judgeRows(report, findings);
    part.verdict = verdict(sentenceOf(report), std::move(findings));
    part.sections = {cheapestSection(report, scenario),
                     accuracyChartSection(report),
                     {"rows", "Settings", settingTables(report)},
                     referenceSection(report),
                     madeBy(json, scenario, file)};
    if (Document stated = describeStated(report.stated); !stated.empty())
      part.sections.insert(part.sections.begin(), PageSection{"stated", "Errors of the scenario as it is", stated, {}});
    part.sections.push_back({"rows-download", "Downloads",
                             Document().add(Downloads{{{"settings.csv", "text/csv", accuracyCsv(json.at("rows"))},
                                                       {"accuracy.json", "application/json", text}}})});
    return part;
  } catch (const std::exception&) {  // the JSON is of another form, or a name is unknown
    throw InputError(file + ": the rows are not those of an accuracy run" + right);
  }
}

PageSection programSection() {
  const BuildInfo& build = buildInfo();
  return {"provenance", "Provenance",
          Document().add(Table{"Provenance",
                               {},
                               {{"Version", build.version},
                                {"Commit", build.gitCommit + " (" + build.gitState + ")"},
                                {"Build", code(buildId(build))},
                                {"Compiler", build.compiler},
                                {"Target", build.target},
                                {"Libraries", librariesText(build)}}})};
}

}  // namespace morula
