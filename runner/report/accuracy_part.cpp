// What accuracy costs: the rows of an accuracy run, and error against CPU time.
#include <algorithm>

#include "base/error.h"
#include "base/number_text.h"
#include "charts/chart.h"
#include "drawing/palette.h"
#include "files/read_file.h"
#include "report/parts.h"

namespace morula {

namespace {

std::string number(const Json& value, int digits = 3) {
  return value.is_number() ? numberText(value.get<double>(), digits) : "";
}

std::string tableOf(const Json& rows) {
  std::vector<std::vector<std::string>> cells;
  for (const Json& row : rows) {
    const Json& parts = row.at("parts");
    const auto part = [&](const char* name) { return parts.is_object() ? number(parts.at(name)) : ""; };
    cells.push_back({shown(row.at("series").get<std::string>()), shown(row.at("engine").get<std::string>()),
                     number(row.at("settings").at("time_step"), 5), number(row.at("error")), part("time"),
                     part("mesh"), part("precision"), part("model"), number(row.at("cpu_seconds")),
                     number(row.at("force_evaluations"), 9),
                     row.at("failure").is_string() ? "<span class=\"mark bad\">✗ failed</span> " +
                                                         shown(row.at("failure").get<std::string>())
                                                   : ""});
  }
  return htmlTable("Settings",
                   {"Settings", "Engine", "Time step", "Error", "of the time step", "of the mesh",
                    "of the precision", "of the model", "CPU time [s]", "Force evaluations", ""},
                   cells);
}

/// As morula accuracy draws it: a line a series, a point a time step; one point alone is hollow.
Drawing drawingOf(const Json& rows, const std::string& scenario) {
  Chart chart;
  chart.title = "Error against cost: " + scenario;
  chart.xLabel = "CPU time [s]", chart.yLabel = "error on the scenario's mesh [egg radii, relative volume]";
  chart.xScale = Axis::Scale::decades;
  for (const Json& row : rows) {
    const Json &error = row.at("error_on_scenario_mesh"), &cost = row.at("cpu_seconds");
    if (!error.is_number() || !cost.is_number() || !(error.get<double>() > 0) || !(cost.get<double>() > 0) ||
        !row.at("resolved").get<bool>())
      continue;
    const auto series = row.at("series").get<std::string>();
    if (chart.lines.empty() || chart.lines.back().label != series)
      chart.lines.push_back(
          {series, seriesColour(chart.lines.size()), {}, chart.lines.size() >= fewSeries, {}});
    chart.lines.back().points.push_back({cost.get<double>(), error.get<double>()});
  }
  return drawChart(chart);
}

}  // namespace

PagePart accuracyPart(const std::string& file) {
  const Json json = Json::tryParse(readFile(file));
  const std::string right = "; needs what morula accuracy --json has printed";
  if (!json.is_object() || !json.contains("rows"))
    throw InputError(file + ": no rows of an accuracy run" + right);
  try {
    const Json& rows = json.at("rows");
    const auto scenario = json.at("scenario").get<std::string>();
    std::vector<Finding> findings;
    std::size_t failed = 0;
    for (const Json& row : rows) failed += row.at("failed").get<bool>() ? 1 : 0;
    if (failed)
      findings.push_back({Finding::Kind::warning, std::to_string(failed) + " of " +
                                                      counted(rows.size(), "setting") +
                                                      " failed; the table says why"});
    for (const Json& remark : json.at("remarks"))
      findings.push_back({Finding::Kind::warning, shown(remark.get<std::string>())});
    PagePart part{
        .title = "Accuracy of " + scenario, .summary = {}, .verdict = {}, .change = {}, .blocks = {}};
    part.verdict = "<p class=\"said\">" + counted(rows.size(), "setting") + " of " + shown(scenario) +
                   " held against a converged reference.</p>\n" + findingsHtml(findings);
    part.blocks.push_back(
        {"accuracy",
         "Error against cost",
         "<div class=\"charts\">" +
             htmlPicture("image/svg+xml", drawingOf(rows, scenario).file(PictureFormat::svg),
                         "error against CPU time, a line for each series of settings",
                         "CPU time is of the machine that ran it") +
             "</div>\n",
         {}});
    part.blocks.push_back(
        {"rows", "Settings", tableOf(rows), {"./morula accuracy SCENARIO --json > " + shellWord(file)}});
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
