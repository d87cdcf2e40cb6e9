// What accuracy costs, as a page: the verdict of an accuracy run, and its blocks.
#include "base/error.h"
#include "base/number_text.h"
#include "files/read_file.h"
#include "page/html.h"
#include "report/accuracy_blocks.h"
#include "report/parts.h"

namespace morula {

namespace {

using Kind = Finding::Kind;

constexpr double wellConverged = 1;  // least order by which errors must fall from mesh to mesh

/// "error 0.0927 up to time 4 of 31.25: 0.00535 of the time step, 0.0874 of the mesh".
std::string sentenceOf(const AccuracyRead& read) {
  const AccuracyEntry& own = read.own;
  const std::string start = shown(read.scenario) + " as it is";
  if (!own.failure.empty()) return start + " does not come to its end.";
  if (!own.whole) return start + ": not compared, for other cells live.";
  std::string text = start + ": error " + (own.mesh ? "" : "at least ") + numberText(*own.whole, 3);
  const auto add = [&](const std::optional<double>& part, const std::string& of) {
    text += (part ? numberText(*part, 3) : std::string("an unknown part")) + " of " + of;
  };
  text += ": ";
  add(own.time, "the time step");
  text += ", ";
  add(own.mesh, "the mesh");
  return text + " [radii of the egg, relative volume].";
}

void judgeReference(const AccuracyRead& read, std::vector<Finding>& findings) {
  const auto& r = read.reference;
  if (!r.error || !(r.order > 0))
    findings.push_back(
        {Kind::bad,
         "No converged reference: its own error does not fall with its time step, so no error on this "
         "page is sure"});
  if (!r.agrees)
    findings.push_back({Kind::bad, "The reference is not confirmed: the witness, " + shown(r.witness) +
                                       ", is farther away than both their errors allow"});
  if (r.agrees && r.error && r.order > 0)
    findings.push_back({Kind::good, "The reference, good to " + numberText(*r.error, 2) +
                                        ", is confirmed by another integrator, " + shown(r.witness)});
}

void judgeMesh(const AccuracyRead& read, std::vector<Finding>& findings) {
  const auto& m = read.mesh;
  if (!m.unknown.empty())
    findings.push_back(
        {Kind::warning, "What the mesh adds is not known, so whole errors are at least what is stated: " +
                            shown(m.unknown)});
  else if (!m.levels.empty() && m.order < wellConverged)
    findings.push_back(
        {Kind::warning, "Errors hardly fall from mesh to mesh: the mesh's error may be larger than stated"});
  if (!m.limit.empty()) findings.push_back({Kind::warning, "No finer mesh took part: " + shown(m.limit)});
  if (m.partedAt)
    findings.push_back(
        {Kind::warning, "On another mesh other cells live from " + numberText(*m.partedAt) + " on"});
  if (m.error && read.own.time && *m.error > 3 * *read.own.time && *m.error > 0)
    findings.push_back({Kind::warning, "The mesh costs " +
                                           (*read.own.time > 0 ? numberText(*m.error / *read.own.time, 2) +
                                                                     " times what the time step does"
                                                               : std::string("all, the time step nothing")) +
                                           ": shorter time steps gain little"});
}

void judgeRows(const AccuracyRead& read, std::vector<Finding>& findings) {
  if (!read.own.failure.empty())
    findings.push_back({Kind::bad, "The scenario as it is failed: " + shown(read.own.failure)});
  else if (read.own.partedAt)
    findings.push_back({Kind::bad, "The scenario as it is has other cells than the reference from time " +
                                       numberText(*read.own.partedAt) + " on"});
  else if (!read.own.resolved)
    findings.push_back(
        {Kind::warning, "The error of the scenario as it is is below ten times the reference's own"});
  if (read.end && read.until < *read.end * (1 - 1e-6))
    findings.push_back({Kind::warning, "Compared up to time " + numberText(read.until, 6) + " of " +
                                           numberText(*read.end, 6) +
                                           ": nothing is said of what comes later"});
  std::size_t failed = 0, parted = 0;
  for (const AccuracyEntry& e : read.rows) failed += !e.failure.empty(), parted += e.partedAt.has_value();
  if (failed)
    findings.push_back({Kind::warning, std::to_string(failed) + " of " +
                                           counted(read.rows.size(), "setting") +
                                           " failed; a table says why"});
  if (parted)
    findings.push_back({Kind::warning, std::to_string(parted) + " of " +
                                           counted(read.rows.size(), "setting") +
                                           " come to other cells than the reference"});
  for (const std::string& remark : read.remarks) findings.push_back({Kind::warning, shown(remark)});
  if (!read.rival.empty())
    findings.push_back({Kind::good, "As exact on this mesh, and the cheapest tried: " + shown(read.rival) +
                                        ", " + numberText(read.rivalSpeed, 3) +
                                        " times as fast as the scenario as it is"});
}

/// What --target has found.
void judgeTarget(const AccuracyRead& read, std::vector<Finding>& findings) {
  const Json& t = read.target;
  if (!t.is_object()) return;
  const std::string error = numberText(t.at("error").get<double>(), 3);
  const Json& best = t.at("run_to_the_end");
  if (!best.is_object()) {
    findings.push_back(
        {Kind::bad, "None of the settings tried holds an error of " + error + " and runs to its end"});
    return;
  }
  std::string command = "./morula";
  for (const Json& word : best.at("command")) command += " " + shellWord(word.get<std::string>());
  const bool holds = t.at("mesh_holds").is_boolean() && t.at("mesh_holds").get<bool>();
  findings.push_back({holds ? Kind::good : Kind::warning,
                      "An error of " + error + " on the scenario's mesh is held for the least CPU time, " +
                          numberText(best.at("cpu_seconds").get<double>(), 3) + " s to its end, by <code>" +
                          shown(command) + "</code>" +
                          (holds ? "; with the mesh's, too"
                           : t.at("mesh_error").is_number()
                               ? "; the mesh itself adds " + numberText(t.at("mesh_error").get<double>(), 3) +
                                     ", which is not in it"
                               : "; what the mesh adds is not known")});
  if (t.at("icosphere_that_holds").is_number() && !holds)
    findings.push_back({Kind::warning, "For the whole error it needs icosphere " +
                                           std::to_string(t.at("icosphere_that_holds").get<int>())});
}

std::string download(const std::string& name, const char* type, const std::string& bytes) {
  return "<a download=\"" + htmlText(name) + "\" href=\"" + dataUri(type, bytes) + "\">" + htmlText(name) +
         " <span class=\"note\">(" + numberText(static_cast<double>(bytes.size()) / 1000, 3) +
         " kB)</span></a>\n";
}

PageBlock madeBy(const AccuracyRead& read, const std::string& file) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [name, value] : read.provenance) rows.push_back({shown(name), shown(value)});
  PageBlock block{"made-by", "Where it comes from", "", {}};
  block.html = rows.empty() ? "<p>The output does not say by which program and machine it was made.</p>\n"
                            : htmlTable("Where it comes from", {}, rows);
  block.commands = {"./morula accuracy " + (read.file.empty() ? "SCENARIO" : shellWord(read.file)) +
                        " --json > " + shellWord(file),
                    "./morula report " + shellWord(file)};
  return block;
}

}  // namespace

PagePart accuracyPart(const std::string& file) {
  const std::string text = readFile(file);
  const Json json = tryParseJson(text);
  const std::string right = "; needs what morula accuracy --json has printed";
  if (!json.is_object() || !json.contains("rows"))
    throw InputError(file + ": no rows of an accuracy run" + right);
  try {
    const AccuracyRead read = accuracyFrom(json);
    PagePart part{.title = "Accuracy of " + read.scenario,
                  .summary = "What accuracy costs: error against CPU time",
                  .verdict = {},
                  .change = {},
                  .blocks = {}};
    std::vector<Finding> findings;
    judgeTarget(read, findings);
    judgeReference(read, findings);
    judgeMesh(read, findings);
    judgeRows(read, findings);
    part.verdict = "<p class=\"said\">" + sentenceOf(read) + "</p>\n" + findingsHtml(findings);
    part.blocks = {cheapestBlock(read), accuracyChartBlock(read), settingsBlock(read), referenceBlock(read),
                   madeBy(read, file)};
    part.blocks.push_back({"rows-download",
                           "Downloads",
                           "<div class=\"downloads\">\n" +
                               download("settings.csv", "text/csv", accuracyCsv(json.at("rows"))) +
                               download("accuracy.json", "application/json", text) + "</div>\n",
                           {}});
    return part;
  } catch (const Json::exception&) {
    throw InputError(file + ": rows that are none of an accuracy run" + right);
  }
}

PageBlock programBlock() {
  const BuildInfo& build = buildInfo();
  return {"provenance",
          "Provenance",
          htmlTable("Provenance", {},
                    {{"Version", shown(build.version)},
                     {"Commit", shown(build.gitCommit + " (" + build.gitState + ")")},
                     {"Build", "<code>" + buildId(build) + "</code>"},
                     {"Compiler", shown(build.compiler)},
                     {"Target", shown(build.target)},
                     {"Libraries", shown(librariesText(build))}}),
          {}};
}

}  // namespace morula
