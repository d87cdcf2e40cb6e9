// What of the runs can be taken along: tables, trees, and where the databases are.
#include <set>

#include "export/csv_tables.h"
#include "export/newick.h"
#include "page/html.h"
#include "report/run_blocks.h"

namespace morula {

namespace {

constexpr std::size_t mostRuns = 24;       // with links
constexpr std::size_t mostDatabases = 12;  // that are named

std::string link(const std::string& name, const std::string& type, const std::string& bytes) {
  return "<a download=\"" + htmlText(name) + "\" href=\"" + dataUri(type, bytes) + "\">" + htmlText(name) +
         " <span class=\"note\">(" + inBytes(bytes.size()) + ")</span></a>\n";
}

/// More than the names of its columns.
bool hasRows(const std::string& csv) {
  const auto head = csv.find('\n');
  return head != csv.npos && head + 1 < csv.size();
}

struct Links {
  std::size_t mostBytes, used = 0;
  std::string html = {};
  std::vector<std::string> left = {};

  void offer(const std::string& name, const char* type, const std::string& bytes) {
    if (used + bytes.size() > mostBytes) return left.push_back(name);
    used += bytes.size();
    html += link(name, type, bytes);
  }
};

void offerRun(const RunFacts& run, const std::string& ending, Links& links) {
  auto store = Store::openForReading(run.database);
  static const std::set<std::string> ofStudies{"conditions", "replicates", "tasks", "results"};
  for (const NamedTable& table : csvTables(store, run.run.id))
    if (!ofStudies.contains(table.name) && hasRows(table.text))
      links.offer(table.name + ending + ".csv", "text/csv", table.text);
  if (run.results.lineage.empty()) return;
  SurfaceRequest tree;
  tree.wanted = Wanted::tree, tree.quiet = true;
  links.offer("lineage" + ending + ".nwk", "text/plain", newickTree(exportedRun(store, run.run, tree)));
}

}  // namespace

PageBlock downloadBlock(const std::vector<RunFacts>& runs, std::size_t mostBytes) {
  Links links{mostBytes};
  PageBlock block{"downloads", "Downloads", "", {}};
  for (std::size_t i = 0; i < std::min(runs.size(), mostRuns); ++i) {
    const std::string ending = runs.size() > 1 ? "-" + runs[i].run.id : "";
    offerRun(runs[i], ending, links);
    if (block.commands.size() >= 4) continue;
    // They do not replace what is there, so each has a name of its own.
    const std::string& id = runs[i].run.id;
    block.commands.push_back(commandFor(runs[i], "export", "--format csv -o tables-" + id));
    if (!runs[i].results.lineage.empty())
      block.commands.push_back(commandFor(runs[i], "export", "--format newick -o lineage-" + id + ".nwk"));
  }
  block.html = "<div class=\"downloads\">\n" + links.html + "</div>\n";
  if (!links.left.empty())
    block.html +=
        "<p class=\"note\">Left out, since the page would become too large: " + shown(listed(links.left)) +
        ". The commands below write all tables.</p>\n";
  if (runs.size() > mostRuns)
    block.html += "<p class=\"note\">The first " + std::to_string(mostRuns) + " of " +
                  counted(runs.size(), "run") + ".</p>\n";
  std::set<std::string> databases;
  for (const RunFacts& r : runs)
    if (databases.size() < mostDatabases && databases.insert(r.database).second)
      block.html += "<p>Database: <code>" + shown(r.database) + "</code></p>\n";
  return block;
}

}  // namespace morula
