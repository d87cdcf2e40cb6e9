// What accuracy costs, as a page: the verdict of an accuracy run, and its sections.
#include <cmath>

#include "accuracy/tables.h"
#include "base/error.h"
#include "base/number_text.h"
#include "files/read_file.h"
#include "report/accuracy_blocks.h"
#include "report/parts.h"
#include "system/installation.h"
#include "system/json_record.h"

namespace morula {
namespace {

using Kind = Finding::Kind;

/// "error 0.0927 up to time 4 of 31.25: 0.00535 of the time step, 0.0874 of the mesh".
std::string sentenceOf(const AccuracyReport& report) {
  const AccuracyRow& own = report.own;
  const std::string start = report.scenario + " as it is";
  if (!own.failure.empty()) return start + " does not come to its end.";
  if (!own.error) return start + ": not compared, for other cells live.";
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
                        "No converged reference: its own error does not fall with its time step, so no error on this "
                        "page is sure"});
  if (!r.agrees)
    findings.push_back({Kind::bad, "The reference is not confirmed: the witness, " + witness +
                                       ", is farther away than both their errors allow"});
  if (r.agrees && converged)
    findings.push_back({Kind::good, "The reference, good to " + numberText(r.left.error, 2) +
                                        ", is confirmed by another integrator, " + witness});
}

void judgeMesh(const AccuracyReport& report, std::vector<Finding>& findings) {
  const MeshError& m = report.mesh;
  if (!m.unknown.empty())
    findings.push_back(
        {Kind::warning, "What the mesh adds is not known, so whole errors are at least what is stated: " + m.unknown});
  else if (!m.levels.empty() && m.order < leastMeshOrder)
    findings.push_back(
        {Kind::warning, "Errors hardly fall from mesh to mesh: the mesh's error may be larger than stated"});
  if (!m.limit.empty()) findings.push_back({Kind::warning, "No finer mesh took part: " + m.limit});
  if (m.partedAt)
    findings.push_back({Kind::warning, "On another mesh other cells live from " + numberText(*m.partedAt) + " on"});
  const auto error = m.error(), time = report.own.parts.time;
  if (error && time && *error > 3 * *time && *error > 0)
    findings.push_back({Kind::warning, "The mesh costs " +
                                           (*time > 0 ? numberText(*error / *time, 2) + " times what the time step does"
                                                      : "all, the time step nothing") +
                                           ": shorter time steps gain little"});
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
                                           numberText(*report.end, 6) + ": nothing is said of what comes later"});
  std::size_t failed = 0, parted = 0;
  for (const AccuracyRow& row : report.rows) failed += !row.failure.empty(), parted += row.partedAt.has_value();
  if (failed)
    findings.push_back({Kind::warning, std::to_string(failed) + " of " + counted(report.rows.size(), "setting") +
                                           " failed; a table says why"});
  if (parted)
    findings.push_back({Kind::warning, std::to_string(parted) + " of " + counted(report.rows.size(), "setting") +
                                           " come to other cells than the reference"});
  for (const std::string& remark : report.remarks) findings.push_back({Kind::warning, remark});
  if (report.rival)
    findings.push_back({Kind::good, "As exact on this mesh, and the cheapest tried: " + report.rival->series + ", " +
                                        numberText(report.rival->speed, 3) +
                                        " times as fast as the scenario as it is"});
}

/// What --target has found.
void judgeTarget(const Json& t, std::vector<Finding>& findings) {
  const std::string error = numberText(t.at("error").get<double>(), 3);
  const Json& best = t.at("run_to_the_end");
  if (!best.is_object()) {
    findings.push_back({Kind::bad, "None of the settings tried holds an error of " + error + " and runs to its end"});
    return;
  }
  std::string command = programWord();
  for (const Json& word : best.at("command")) command += " " + shellWord(word.get<std::string>());
  const bool holds = t.at("mesh_holds").is_boolean() && t.at("mesh_holds").get<bool>();
  findings.push_back(
      {holds ? Kind::good : Kind::warning,
       "An error of " + error + " on the scenario's mesh is held for the least CPU time, " +
           numberText(best.at("cpu_seconds").get<double>(), 3) + " s to its end, by " + code(command) +
           (holds ? "; with the mesh's, too"
            : t.at("mesh_error").is_number()
                ? "; the mesh itself adds " + numberText(t.at("mesh_error").get<double>(), 3) + ", which is not in it"
                : "; what the mesh adds is not known")});
  if (t.at("icosphere_that_holds").is_number() && !holds)
    findings.push_back({Kind::warning, "For the whole error it needs icosphere " +
                                           std::to_string(wholeFrom<int>(t.at("icosphere_that_holds")))});
}

PageSection madeBy(const Json& json, const std::string& scenario, const std::string& file) {
  PageSection section{"made-by",
                      "Where it comes from",
                      {},
                      {programWord() + " accuracy " + scenario + " --json > " + shellWord(file),
                       programWord() + " report " + shellWord(file)}};
  Table table{section.title, {}};
  if (json.contains("made_by"))
    for (const auto& [name, value] : json.at("made_by").items()) table.rows.push_back({name, value.get<std::string>()});
  if (table.rows.empty()) section.body.say("The output does not say by which program and machine it was made.");
  else section.body.add(std::move(table));
  return section;
}

}  // namespace

PagePart accuracyPart(const std::string& file) {
  const std::string text = readFile(file);
  const Json json = tryParseJson(text);
  const std::string right = "; needs what morula accuracy --json has printed";
  if (!json.is_object() || !json.contains("rows")) throw InputError(file + ": no rows of an accuracy run" + right);
  try {
    const AccuracyReport report = accuracyFrom(json);
    const std::string scenario = json.contains("file") ? shellWord(json.at("file").get<std::string>()) : "SCENARIO";
    PagePart part{.title = "Accuracy of " + report.scenario,
                  .summary = "What accuracy costs: error against CPU time",
                  .verdict = {}};
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
    part.sections.push_back({"rows-download", "Downloads",
                             Document().add(Downloads{{{"settings.csv", "text/csv", accuracyCsv(json.at("rows"))},
                                                       {"accuracy.json", "application/json", text}}})});
    return part;
  } catch (const std::exception&) {  // JSON of other kinds, and choices that are none
    throw InputError(file + ": rows that are none of an accuracy run" + right);
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
