// Downloads of the runs: tables, trees, and the places of the databases.
#include <set>

#include "export/csv.h"
#include "export/newick.h"
#include "report/run_blocks.h"

namespace morula {
namespace {

constexpr std::size_t maxRuns = 24;       // max number of runs with links
constexpr std::size_t maxDatabases = 12;  // max number of databases that are named

/// Returns true if the CSV holds more than the names of its columns.
bool hasRows(const std::string& csv) {
  const auto head = csv.find('\n');
  return head != csv.npos && head + 1 < csv.size();
}

struct Links {
  std::size_t maxBytes, used = 0;
  Downloads downloads = {};
  std::vector<std::string> left = {};

  void offer(const std::string& name, const char* type, const std::string& bytes) {
    if (used + bytes.size() > maxBytes) return left.push_back(name);
    used += bytes.size();
    downloads.files.push_back({name, type, bytes});
  }
};

void offerRun(const RunFacts& run, const std::string& ending, Links& links) {
  auto store = Store::openForReading(run.database);
  static const std::set<std::string> ofStudies{"conditions", "replicates", "tasks", "results"};
  for (const NamedTable& table : csvTables(store, run.run.id))
    if (!ofStudies.contains(table.name) && hasRows(table.table.text()))
      links.offer(table.name + ending + ".csv", "text/csv", table.table.text());
  if (run.results.lineage.empty()) return;
  SurfaceRequest tree;
  tree.wanted = Wanted::tree, tree.quiet = true;
  links.offer("lineage" + ending + ".nwk", "text/plain", newickTree(exportedRun(store, run.run, tree)));
}

}  // namespace

PageSection downloadSection(const std::vector<RunFacts>& runs, std::size_t maxBytes) {
  Links links{maxBytes};
  PageSection section{"downloads", "Downloads", {}};
  for (std::size_t i = 0; i < std::min(runs.size(), maxRuns); ++i) {
    const std::string ending = runs.size() > 1 ? "-" + runs[i].run.id : "";
    offerRun(runs[i], ending, links);
    if (section.commands.size() >= 4) continue;
    // The commands do not replace files, so each output has a different name.
    const std::string& id = runs[i].run.id;
    section.commands.push_back(commandFor(runs[i], "export", "--format csv -o tables-" + id));
    if (!runs[i].results.lineage.empty())
      section.commands.push_back(commandFor(runs[i], "export", "--format newick -o lineage-" + id + ".nwk"));
  }
  section.body.add(std::move(links.downloads));
  if (!links.left.empty())
    section.body.note("Left out, since the page would become too large: " + listed(links.left) +
                      ". The commands below write all tables.");
  if (runs.size() > maxRuns)
    section.body.note("The first " + std::to_string(maxRuns) + " of " + counted(runs.size(), "run") + ".");
  std::set<std::string> databases;
  for (const RunFacts& r : runs)
    if (databases.size() < maxDatabases && databases.insert(r.database).second)
      section.body.say("Database: " + code(r.database));
  return section;
}

}  // namespace morula
