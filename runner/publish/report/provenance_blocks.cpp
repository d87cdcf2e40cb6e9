// The origins and parameters of runs, and their differences from goldens and from one another.
#include <algorithm>
#include <map>
#include <set>

#include "report/run_blocks.h"
#include "scenario/deciding_values.h"
#include "system/json.h"

namespace morula {
namespace {

constexpr std::size_t maxColumns = 6;  // max number of runs side by side

/// Returns [label, value] of a run's record, and its database.
std::vector<std::pair<std::string, std::string>> provenanceOf(const RunFacts& r) {
  std::vector<std::pair<std::string, std::string>> rows;
  eachFieldOf(r.run, [&](const RunField& field, std::string value) {
    const bool isIdle = field.name == std::string_view("seed") && !usesSeed(r.scenario.scene);
    if (!value.empty() && isIdle) value += " (changes nothing in this scenario)";
    if (!value.empty() && field.changesNothing) value += " (changes no result)";
    rows.push_back({headingOf(field), std::move(value)});
  });
  rows.push_back({"Database", r.database});
  return rows;
}

/// Returns a table with a row for each name and a column for each run; rows with differing values are marked.
Table sideBySide(const std::string& caption, const std::vector<RunFacts>& runs,
                 const std::vector<std::pair<std::string, std::vector<std::string>>>& rows) {
  Table table{caption, {}};
  if (runs.size() > 1) {
    table.columns.push_back("");
    for (std::size_t i = 0; i < std::min(runs.size(), maxColumns); ++i) table.columns.push_back(titleOf(runs[i]));
  }
  for (const auto& [label, values] : rows) {
    const bool same =
        std::all_of(values.begin(), values.end(), [&, &first = values.front()](const auto& v) { return v == first; });
    table.rows.push_back({same ? label : label + " " + Words("≠", Emphasis::warning, "differs")});
    table.rows.back().insert(table.rows.back().end(), values.begin(), values.end());
  }
  return table;
}

/// Shows the parameters that decide results and differ between the runs.
Document differences(const std::vector<RunFacts>& runs) {
  const std::size_t columns = std::min(runs.size(), maxColumns);
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
    if (key == "seed") continue;  // the seed is shown with the origins
    std::vector<std::string> row;
    for (const auto& of : values) row.push_back(of.contains(key) ? of.at(key) : "not given");
    if (std::any_of(row.begin(), row.end(), [&](const auto& v) { return v != row.front(); }))
      rows.push_back({key, std::move(row)});
  }
  if (rows.empty()) return Document().say("The scenarios differ only in their seeds.");
  return Document().heading("What differs").add(sideBySide("Parameters that differ", runs, rows));
}

/// Returns JSON with line breaks, for people; unchanged if it cannot be read.
std::string indented(const std::string& json) {
  const Json read = tryParseJson(json);
  return read.is_null() ? json : jsonText(read, 2);
}

constexpr std::size_t maxChanges = 4;  // max number of runs that are compared with the first of their scenario

void tellBesideGolden(const RunFacts& run, Document& changes) {
  if (run.change.empty()) {
    changes.say("Nothing: the run equals the accepted result, " + code(run.golden) + ", records.");
    return;
  }
  const auto goldens = [](const CheckResult& c) { return c.kind == CheckKind::golden; };
  const bool within =
      std::any_of(run.checks.begin(), run.checks.end(), goldens) &&
      std::all_of(run.checks.begin(), run.checks.end(), [&](const CheckResult& c) { return !goldens(c) || c.passed; });
  changes.say((within ? "Nothing beyond the tolerances of the accepted result, " : "Beside the accepted result, ") +
              code(run.golden) + ":");
  changes.add(changeTable(run.change, run.scenario.names));
}

void tellBesideFirst(const RunFacts& first, const RunFacts& run, Document& changes) {
  const std::string change = changeBetween(first, run);
  changes.say("Beside " + titleOf(first) +
              (change.empty()         ? ": nothing."
               : change == run.change ? ": the same."
                                      : ":"));
  if (!change.empty() && change != run.change) changes.add(changeTable(change, run.scenario.names));
}

}  // namespace

PageSection provenanceSection(const std::vector<RunFacts>& runs) {
  std::vector<std::pair<std::string, std::vector<std::string>>> rows;
  for (std::size_t i = 0; i < std::min(runs.size(), maxColumns); ++i) {
    const auto of = provenanceOf(runs[i]);
    rows.resize(of.size());
    for (std::size_t k = 0; k < of.size(); ++k) rows[k].first = of[k].first, rows[k].second.push_back(of[k].second);
  }
  std::erase_if(rows, [](const auto& row) {
    // A study's runs record no time and no machine: their bytes do not depend on them.
    return std::ranges::all_of(row.second, [](const std::string& v) { return v.empty(); });
  });
  PageSection section{"provenance", "Provenance", {}};
  section.body.add(sideBySide("Provenance", runs, rows));
  if (runs.size() > maxColumns)
    section.body.note("The first " + std::to_string(maxColumns) + " of " + counted(runs.size(), "run") + ".");
  for (const RunFacts& r : runs)
    if (section.commands.size() < maxColumns && r.run.status != RunStatus::running)
      section.commands.push_back(commandFor(r, "replay"));
  return section;
}

PageSection parameterSection(const std::vector<RunFacts>& runs) {
  PageSection section{"parameters", "Parameters", differences(runs)};
  std::set<std::string> shownAlready;
  for (const RunFacts& r : runs) {
    if (shownAlready.size() >= maxColumns) break;
    if (!shownAlready.insert(r.run.record.scenarioHash).second) continue;
    const std::string of = runs.size() > 1 ? " of " + titleOf(r) : "";
    for (const SourceText& d : r.documents) {
      const bool resolved = d.role == "resolved";
      const std::string title = resolved               ? "All parameters, defaults filled in"
                                : d.role == "scenario" ? "The scenario as it was read"
                                : d.role == "diff"     ? "Changes of the program's sources since their commit"
                                                       : "The file that it names as " + d.role;
      section.body.add(folded(title + of + (d.path.empty() ? "" : ": " + d.path),
                              Document().add(Verbatim{resolved ? indented(d.content) : d.content})));
    }
  }
  for (const RunFacts& r : runs)
    if (section.commands.size() < maxColumns && r.run.status == RunStatus::done)
      section.commands.push_back(commandFor(r, "export", "--ro-crate " + shellWord("crate-" + r.run.id)));
  return section;
}

Document changesOf(const std::vector<RunFacts>& runs) {
  Document all;
  std::map<std::string, const RunFacts*> firsts;  // the first run of each scenario
  std::size_t told = 0;
  for (const RunFacts& run : runs) {
    if (run.run.status != RunStatus::done || !run.label.empty()) continue;
    Document changes;
    if (!run.golden.empty() && run.unusableGolden.empty() && (runs.size() == 1 || !run.change.empty()))
      tellBesideGolden(run, changes);
    const auto [first, isFirst] = firsts.emplace(run.run.record.scenario, &run);
    if (!isFirst && ++told <= maxChanges) tellBesideFirst(*first->second, run, changes);
    if (changes.empty()) continue;
    if (runs.size() > 1) all.heading(titleOf(run));
    all.add(std::move(changes));
  }
  if (told > maxChanges)
    all.note("Of the runs of one scenario the first " + std::to_string(maxChanges + 1) + " are listed.");
  return all;
}

}  // namespace morula
