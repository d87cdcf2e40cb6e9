#include "store/contents.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "database/database.h"
#include "database/store_error.h"

namespace morula {

namespace {

/// The one list of who reads what: store/README.md says it at length.
struct Purpose {
  std::string_view table, why;
};

constexpr Purpose purposes[] = {
    {"run", "always: which run it is, how it ended, with which program and where"},
    {"document", "always: the scenario, its files and the program's changes, to repeat the run from"},
    {"run_document", "always: which document is what of which run"},
    {"cell", "always: the lineage; lineage, render, replay and explain read it"},
    {"sample", "the organism over time, as often as `record.every` says; replay and queries read it"},
    {"cell_sample", "each cell at the times of `sample`"},
    {"contact", "each pair of touching cells at the times of `sample`, in a scene with contact"},
    {"measure", "what `record.measures` asks for, at the times of `sample`; replay and queries read it"},
    {"mesh_sample", "each cell's surface, as often as `record.meshes` says; export and replay read it"},
    {"connection", "every connection that was ever made, in a scene with connections"},
    {"division", "every division: its axis and how the volume was shared"},
    {"time_step", "in a scene with bodies: the time step and its changes; replay reads it"},
    {"step_hash",
     "where the run was checked against a golden or as `check` asks: explain --db and replay find with it "
     "the "
     "first step that differs"},
    {"cell_hash", "with `step_hash`: explain --db finds with it which cells differ there"},
    {"check_result", "where the run was checked: what each check found"},
    {"bullet_sample", "where `check.bullet` asks for it: each cell in Bullet beside the run's own"},
    {"study", "of a study: what was planned"},
    {"axis", "of a study: what it varies; compare reads it"},
    {"level", "of a study: the values of each axis; compare reads it"},
    {"condition", "of a study: each combination of levels; compare reads it"},
    {"condition_key", "of a study: the conditions' values of the scenario's keys, for queries"},
    {"replicate", "of a study: which task is which condition with which seed; compare reads it"},
    {"task", "of a study: how each run ended; compare and status read it"},
    {"result", "of a study: what `measures` asks for; compare reads it"},
    {"timing", "of a study: when and where each task was computed"},
    {"checkpoint", "only until the run has finished: run --resume goes on from it"},
    {"checkpoint_frame", "only until the run has finished: the shapes of its sequence of pictures"},
};

std::string whyOf(const std::string& table) {
  for (const Purpose& p : purposes)
    if (p.table == table) return std::string(p.why);
  return {};
}

/// [byte] Pages of each table and of its indices; empty where this SQLite does not count them.
std::map<std::string, std::uint64_t> pagesOf(Database& db) {
  std::map<std::string, std::uint64_t> bytes;
  try {
    Statement s(
        db,
        "SELECT tbl_name, sum(pgsize) FROM dbstat JOIN sqlite_schema USING (name) WHERE aggregate = 1 "
        "GROUP BY tbl_name");
    while (s.next()) bytes[s.text(0)] = s.natural(1);
  } catch (const StoreError&) { bytes.clear(); }
  return bytes;
}

std::vector<std::string> namesOfColumns(Database& db, const std::string& table) {
  std::vector<std::string> columns;
  Statement s(db, "SELECT name FROM pragma_table_info(?)");
  for (s.start(table); s.next();) columns.push_back(s.text(0));
  return columns;
}

/// [byte] The values of all rows, each as SQLite would write it as text or bytes.
std::uint64_t lengthOf(Database& db, const std::string& table, const std::vector<std::string>& columns) {
  std::string sum;
  for (const std::string& c : columns)
    sum += (sum.empty() ? "" : " + ") + ("ifnull(length(CAST(\"" + c + "\" AS BLOB)), 0)");
  return static_cast<std::uint64_t>(db.integer("SELECT ifnull(sum(" + sum + "), 0) FROM \"" + table + '"'));
}

}  // namespace

std::vector<TableContents> contentsOf(Database& db, const std::string& id) {
  std::vector<std::string> tables;
  Statement names(
      db, "SELECT name FROM sqlite_schema WHERE type = 'table' AND name NOT LIKE 'sqlite%' ORDER BY rowid");
  while (names.next()) tables.push_back(names.text(0));
  const auto pages = pagesOf(db);

  std::vector<TableContents> list;
  for (const std::string& table : tables) {
    TableContents& t = list.emplace_back();
    t.table = table, t.why = whyOf(table);
    const auto all = static_cast<std::uint64_t>(db.integer("SELECT count(*) FROM \"" + table + '"'));
    t.rows = all;
    const auto measured = pages.find(table);
    t.estimated = measured == pages.end();
    t.bytes = t.estimated ? lengthOf(db, table, namesOfColumns(db, table)) : measured->second;
    const std::vector<std::string> columns = namesOfColumns(db, table);
    const bool ofRuns = table == "document" || std::ranges::find(columns, "run_id") != columns.end();
    if (id.empty() || !ofRuns) continue;
    Statement count(db, table == "document" ? "SELECT count(DISTINCT hash) FROM run_document WHERE run_id = ?"
                                            : "SELECT count(*) FROM \"" + table + "\" WHERE run_id = ?");
    count.start(id).next();
    t.rows = count.natural(0);
    if (t.rows == all) continue;
    t.bytes = static_cast<std::uint64_t>(static_cast<double>(t.bytes) * static_cast<double>(t.rows) /
                                         static_cast<double>(all));
    t.estimated = true;
  }
  return list;
}

}  // namespace morula
