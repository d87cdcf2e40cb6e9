// Where runs come from, their parameters, and what of them can be taken along.
#include <algorithm>
#include <functional>
#include <set>

#include "base/number_text.h"
#include "page/html.h"
#include "report/run_blocks.h"
#include "report/tables.h"
#include "scenario/deciding_values.h"

namespace morula {

namespace {

constexpr std::size_t mostColumns = 6;     // runs side by side
constexpr std::size_t mostDownloads = 24;  // runs with links

struct Row {
  const char* name;
  std::function<std::string(const RunFacts&)> get;
};

const std::vector<Row>& provenanceRows() {
  static const std::vector<Row> rows{
      {"Run", [](const RunFacts& r) { return r.run.id; }},
      {"Scenario", [](const RunFacts& r) { return r.run.record.scenario; }},
      {"Meaning of the scenario", [](const RunFacts& r) { return r.run.record.scenarioHash; }},
      {"Seed",
       [](const RunFacts& r) {
         return std::to_string(r.run.record.seed) +
                (usesSeed(r.scenario.scene) ? "" : " (changes nothing in this scenario)");
       }},
      {"End state", [](const RunFacts& r) { return r.run.stateHash; }},
      {"Steps", [](const RunFacts& r) { return std::to_string(r.run.steps); }},
      {"Started", [](const RunFacts& r) { return r.run.started; }},
      {"Ended", [](const RunFacts& r) { return r.run.ended; }},
      {"Command", [](const RunFacts& r) { return r.run.record.command; }},
      {"Database", [](const RunFacts& r) { return r.database; }},
      {"Version", [](const RunFacts& r) { return r.run.record.build.version; }},
      {"Commit",
       [](const RunFacts& r) {
         return r.run.record.build.gitCommit + " (" + r.run.record.build.gitState + ")";
       }},
      {"Build", [](const RunFacts& r) { return buildId(r.run.record.build); }},
      {"Program file", [](const RunFacts& r) { return r.run.record.binaryHash; }},
      {"Compiler", [](const RunFacts& r) { return r.run.record.build.compiler; }},
      {"Flags", [](const RunFacts& r) { return r.run.record.build.flags; }},
      {"Target", [](const RunFacts& r) { return r.run.record.build.target; }},
      {"Libraries", [](const RunFacts& r) { return librariesText(r.run.record.build); }},
      {"Processor", [](const RunFacts& r) { return r.run.record.machine.cpu; }},
      {"Kernel", [](const RunFacts& r) { return r.run.record.machine.kernel; }},
      {"Instruction set", [](const RunFacts& r) { return r.run.record.isa + " (changes no result)"; }},
      {"Threads",
       [](const RunFacts& r) { return std::to_string(r.run.record.threads) + " (changes no result)"; }},
  };
  return rows;
}

/// One row a name, one column a run; rows whose values differ are marked.
std::string sideBySide(const std::string& caption, const std::vector<RunFacts>& runs,
                       const std::vector<std::pair<std::string, std::vector<std::string>>>& rows) {
  std::vector<std::string> head{""};
  const std::size_t columns = std::min(runs.size(), mostColumns);
  for (std::size_t i = 0; i < columns; ++i) head.push_back(shown(titleOf(runs[i], runs)));
  std::vector<std::vector<std::string>> cells;
  for (const auto& [label, values] : rows) {
    const bool same = std::all_of(values.begin(), values.end(),
                                  [&, &first = values.front()](const auto& v) { return v == first; });
    std::vector<std::string> row{shown(label) +
                                 (same ? "" : " <span class=\"mark warn\" title=\"differs\">≠</span>")};
    for (const std::string& v : values) row.push_back(shown(v));
    cells.push_back(std::move(row));
  }
  return htmlTable(caption, runs.size() > 1 ? head : std::vector<std::string>{}, cells);
}

std::string leftOut(const std::vector<RunFacts>& runs, std::size_t most) {
  if (runs.size() <= most) return {};
  return "<p class=\"note\">The first " + std::to_string(most) + " of " + counted(runs.size(), "run") +
         ".</p>\n";
}

/// What decides the results and differs between the runs.
std::string differences(const std::vector<RunFacts>& runs) {
  const std::size_t columns = std::min(runs.size(), mostColumns);
  if (columns < 2) return {};
  std::vector<std::string> keys;
  std::set<std::string> known;
  std::vector<std::map<std::string, std::string>> values;
  for (std::size_t i = 0; i < columns; ++i) {
    values.emplace_back();
    for (const auto& [key, value] : decidingValues(runs[i].scenario)) {
      if (known.insert(key).second) keys.push_back(key);
      values.back()[key] = value;
    }
  }
  std::vector<std::pair<std::string, std::vector<std::string>>> rows;
  for (const std::string& key : keys) {
    if (key == "seed") continue;  // stands among where they come from
    std::vector<std::string> row;
    for (const auto& of : values) row.push_back(of.contains(key) ? of.at(key) : "not given");
    if (std::any_of(row.begin(), row.end(), [&](const auto& v) { return v != row.front(); }))
      rows.push_back({key, std::move(row)});
  }
  if (rows.empty()) return "<p>The scenarios are the same but for their seeds.</p>\n";
  return "<h3>What differs</h3>\n" + sideBySide("Parameters that differ", runs, rows);
}

std::string link(const std::string& name, const std::string& type, const std::string& bytes) {
  return "<a download=\"" + htmlText(name) + "\" href=\"" + dataUri(type, bytes) + "\">" + htmlText(name) +
         " <span class=\"note\">(" + numberText(static_cast<double>(bytes.size()) / 1000, 3) +
         " kB)</span></a>\n";
}

}  // namespace

PageBlock provenanceBlock(const std::vector<RunFacts>& runs) {
  std::vector<std::pair<std::string, std::vector<std::string>>> rows;
  for (const Row& row : provenanceRows()) {
    std::vector<std::string> values;
    for (std::size_t i = 0; i < std::min(runs.size(), mostColumns); ++i) values.push_back(row.get(runs[i]));
    rows.push_back({row.name, std::move(values)});
  }
  PageBlock block{
      "provenance", "Provenance", sideBySide("Provenance", runs, rows) + leftOut(runs, mostColumns), {}};
  block.commands.push_back(commandFor(runs[0], "replay"));
  return block;
}

PageBlock parameterBlock(const std::vector<RunFacts>& runs) {
  std::string html = differences(runs);
  std::set<std::string> shownAlready;
  for (const RunFacts& r : runs) {
    if (shownAlready.size() >= mostColumns) break;
    if (!shownAlready.insert(r.run.record.scenarioHash).second) continue;
    const std::string of = runs.size() > 1 ? " of " + titleOf(r, runs) : "";
    for (const Document& d : r.documents) {
      const bool resolved = d.role == "resolved";
      const std::string title = resolved               ? "All parameters, defaults filled in"
                                : d.role == "scenario" ? "The scenario as it was read"
                                : d.role == "diff"
                                    ? "What the program's sources had that their commit had not"
                                    : "The file that it names as " + d.role;
      html += htmlFolded(title + of + (d.path.empty() ? "" : ": " + d.path),
                         shownBlock(resolved ? indented(d.content) : d.content));
    }
  }
  return {"parameters",
          "Parameters",
          html,
          {"./morula run " + shellWord(sourceOf(runs[0])) +
           (runs[0].run.record.seed ? " --seed " + std::to_string(runs[0].run.record.seed) : "")}};
}

PageBlock downloadBlock(const std::vector<RunFacts>& runs, std::size_t mostBytes) {
  std::string html = "<div class=\"downloads\">\n";
  std::size_t used = 0, left = 0;
  for (std::size_t i = 0; i < std::min(runs.size(), mostDownloads); ++i) {
    const std::string of = runs.size() > 1 ? "-" + runs[i].run.id : "";
    const auto offer = [&](const std::string& name, const char* type, const std::string& bytes) {
      if (bytes.empty()) return;
      if (used + bytes.size() > mostBytes) return void(++left);
      used += bytes.size();
      html += link(name, type, bytes);
    };
    offer("cells" + of + ".csv", "text/csv", cellsCsv(runs[i].results));
    offer("samples" + of + ".csv", "text/csv", samplesCsv(runs[i].results));
    offer("cell-samples" + of + ".csv", "text/csv", cellSamplesCsv(runs[i].results));
    offer("lineage" + of + ".nwk", "text/plain", newick(runs[i].results, runs[i].run.time));
  }
  html += "</div>\n";
  if (left)
    html += "<p class=\"note\">" + counted(left, "table") +
            " would make the page too large; the database holds them.</p>\n";
  html += leftOut(runs, mostDownloads);
  std::set<std::string> databases;
  for (const RunFacts& r : runs)
    if (databases.insert(r.database).second && databases.size() <= 12)
      html += "<p>Database: <code>" + shown(r.database) + "</code></p>\n";
  return {"downloads", "Downloads", html, {}};
}

}  // namespace morula
