// Where runs come from, and their parameters.
#include <algorithm>
#include <functional>
#include <set>

#include "report/run_blocks.h"
#include "scenario/deciding_values.h"
#include "system/json.h"

namespace morula {

namespace {

constexpr std::size_t mostColumns = 6;  // runs side by side

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
      {"Instruction set",
       [](const RunFacts& r) {
         return r.run.record.isa.empty() ? "" : r.run.record.isa + " (changes no result)";
       }},
      {"Threads",
       [](const RunFacts& r) { return std::to_string(r.run.record.threads) + " (changes no result)"; }},
  };
  return rows;
}

/// One row a name, one column a run; rows whose values differ are marked.
Table sideBySide(const std::string& caption, const std::vector<RunFacts>& runs,
                 const std::vector<std::pair<std::string, std::vector<std::string>>>& rows) {
  Table table{caption, {}};
  if (runs.size() > 1) {
    table.columns.push_back("");
    for (std::size_t i = 0; i < std::min(runs.size(), mostColumns); ++i)
      table.columns.push_back(titleOf(runs[i]));
  }
  for (const auto& [label, values] : rows) {
    const bool same = std::all_of(values.begin(), values.end(),
                                  [&, &first = values.front()](const auto& v) { return v == first; });
    table.rows.push_back({same ? label : label + " " + Words("≠", Emphasis::warning, "differs")});
    table.rows.back().insert(table.rows.back().end(), values.begin(), values.end());
  }
  return table;
}

/// What decides the results and differs between the runs.
Document differences(const std::vector<RunFacts>& runs) {
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
  if (rows.empty()) return Document().say("The scenarios are the same but for their seeds.");
  return Document().heading("What differs").add(sideBySide("Parameters that differ", runs, rows));
}

/// JSON with line breaks, for people; as it is if it cannot be read.
std::string indented(const std::string& json) {
  const Json read = Json::tryParse(json);
  return read.is_null() ? json : jsonText(read, 2);
}

}  // namespace

PageSection provenanceSection(const std::vector<RunFacts>& runs) {
  std::vector<std::pair<std::string, std::vector<std::string>>> rows;
  for (const Row& row : provenanceRows()) {
    std::vector<std::string> values;
    for (std::size_t i = 0; i < std::min(runs.size(), mostColumns); ++i) values.push_back(row.get(runs[i]));
    // Runs of a study have no time and no machine of their own: they are the same bytes wherever they were run.
    if (std::all_of(values.begin(), values.end(), [](const std::string& v) { return v.empty(); })) continue;
    rows.push_back({row.name, std::move(values)});
  }
  PageSection section{"provenance", "Provenance", {}};
  section.body.add(sideBySide("Provenance", runs, rows));
  if (runs.size() > mostColumns)
    section.body.note("The first " + std::to_string(mostColumns) + " of " + counted(runs.size(), "run") +
                      ".");
  for (const RunFacts& r : runs)
    if (section.commands.size() < mostColumns && r.run.status != RunStatus::running)
      section.commands.push_back(commandFor(r, "replay"));
  return section;
}

PageSection parameterSection(const std::vector<RunFacts>& runs) {
  PageSection section{"parameters", "Parameters", differences(runs)};
  std::set<std::string> shownAlready;
  for (const RunFacts& r : runs) {
    if (shownAlready.size() >= mostColumns) break;
    if (!shownAlready.insert(r.run.record.scenarioHash).second) continue;
    const std::string of = runs.size() > 1 ? " of " + titleOf(r) : "";
    for (const SourceText& d : r.documents) {
      const bool resolved = d.role == "resolved";
      const std::string title = resolved               ? "All parameters, defaults filled in"
                                : d.role == "scenario" ? "The scenario as it was read"
                                : d.role == "diff"
                                    ? "What the program's sources had that their commit had not"
                                    : "The file that it names as " + d.role;
      section.body.add(folded(title + of + (d.path.empty() ? "" : ": " + d.path),
                              Document().add(Verbatim{resolved ? indented(d.content) : d.content})));
    }
  }
  for (const RunFacts& r : runs)
    if (section.commands.size() < mostColumns && r.run.status == RunStatus::done)
      section.commands.push_back(commandFor(r, "export", "--ro-crate " + shellWord("crate-" + r.run.id)));
  return section;
}

}  // namespace morula
