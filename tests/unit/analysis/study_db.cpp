#include "study_db.h"

#include <set>

#include "database/database.h"
#include "store/schema.h"

namespace morula {

namespace {

/// A row of `run` of which only the id and the state matter.
void insertRun(Database& db, const std::string& id, const std::string& state) {
  const auto number = db.integer("SELECT count(*) FROM pragma_table_info('run')");
  std::string names, values;
  for (std::int64_t i = 0; i < number; ++i) {
    Statement column(db, "SELECT name, type, \"notnull\" FROM pragma_table_info('run') WHERE cid = ?");
    column.start(i).next();
    const std::string name = column.text(0);
    if (column.integer(2) == 0 && name != "run_id") continue;
    names += (names.empty() ? "" : ", ") + name;
    std::string value = column.text(1) == "TEXT" ? "''" : "0";
    if (name == "run_id") value = "'" + id + "'";
    if (name == "status") value = "'done'";
    if (name == "git_state") value = "'clean'";
    values += (values.empty() ? "" : ", ") + value;
  }
  db.execute("INSERT INTO run (" + names + ") VALUES (" + values + ")");
  db.execute("UPDATE run SET state_hash = '" + state + "' WHERE run_id = '" + id + "'");
}

void makeTables(Database& db, const MadeStudy& study) {
  std::string labels;
  for (const auto& axis : study.axes) labels += ", \"" + axis.name + "\" TEXT NOT NULL";
  db.execute("CREATE TABLE study (name TEXT, summary TEXT, plan_id TEXT, plan TEXT, build_id TEXT)");
  db.execute("CREATE TABLE axis (number INTEGER PRIMARY KEY, name TEXT)");
  db.execute("CREATE TABLE level (axis INTEGER, number INTEGER, label TEXT, keys TEXT)");
  db.execute("CREATE TABLE condition (condition_id INTEGER PRIMARY KEY" + labels +
             ", uses_seed INTEGER, distinct_runs INTEGER)");
  db.execute(
      "CREATE TABLE task (task_id TEXT PRIMARY KEY, number INTEGER, condition_id INTEGER, seed INTEGER, status TEXT, "
      "reason TEXT, run_id TEXT, result_hash TEXT)");
  db.execute("CREATE TABLE replicate (condition_id INTEGER, seed INTEGER, task_id TEXT)");
  db.execute("CREATE TABLE result (run_id TEXT, measure TEXT, time REAL, value REAL)");
  db.execute("INSERT INTO study VALUES ('made', 'A study that was never run', '', '', '')");
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    Statement(db, "INSERT INTO axis VALUES (?, ?)").run(static_cast<int>(a), study.axes[a].name);
    for (std::size_t l = 0; l < study.axes[a].labels.size(); ++l)
      Statement(db, "INSERT INTO level VALUES (?, ?, ?, '{}')")
          .run(static_cast<int>(a), static_cast<int>(l), study.axes[a].labels[l]);
  }
}

void insertTask(Database& db, const MadeStudy& study, const std::string& task, const std::vector<int>& levels,
                int seed) {
  const std::string trouble = study.trouble ? study.trouble(levels, seed) : "";
  const auto run = trouble == "missing" ? std::nullopt : std::optional(task + "-run");
  Statement(db, "INSERT INTO task VALUES (?, (SELECT count(*) FROM task), 0, ?, ?, ?, ?, NULL)")
      .run(task, seed, trouble.empty() ? "done" : trouble, trouble == "failed" ? "numerical failure: too fast" : "",
           run);
  if (!run) return;
  insertRun(db, *run, trouble.empty() ? "state of " + task : "");
  if (study.cells) Statement(db, "UPDATE run SET cells = ? WHERE run_id = ?").run(study.cells(levels), *run);
  if (!trouble.empty()) return;
  for (const auto& [measure, value] : study.values(levels, seed))
    for (const double t : study.times)
      Statement(db, "INSERT INTO result VALUES (?, ?, ?, ?)").run(*run, measure, t, value * t / study.times.back());
}

}  // namespace

void writeStudy(const MadeStudy& study, const std::filesystem::path& file) {
  Database db(file, Database::Mode::create, std::chrono::seconds(1));
  makeTables(db);
  db.execute("PRAGMA synchronous = OFF");
  Transaction transaction(db);
  makeTables(db, study);
  std::vector<int> levels(study.axes.size());
  std::set<std::string> made;
  for (int condition = 0;; ++condition) {
    const bool seedless = study.seedless && study.seedless(levels);
    std::string columns, shown = std::to_string(condition);
    for (std::size_t a = 0; a < levels.size(); ++a) shown += ", '" + study.axes[a].labels[std::size_t(levels[a])] + "'";
    db.execute("INSERT INTO condition VALUES (" + shown + ", " +
               (seedless ? "0, 1)" : "1, " + std::to_string(study.seeds) + ")"));
    const auto meant = study.sameAs ? study.sameAs(levels) : levels;
    for (int seed = 1; seed <= study.seeds; ++seed) {
      std::string task = "task";
      for (const int l : meant) task += "-" + std::to_string(l);
      if (!seedless) task += "-seed-" + std::to_string(seed);
      if (made.insert(task).second) insertTask(db, study, task, meant, seed);
      Statement(db, "INSERT INTO replicate VALUES (?, ?, ?)").run(condition, seed, task);
    }
    std::size_t a = levels.size();
    while (a > 0 && ++levels[a - 1] == int(study.axes[a - 1].labels.size())) levels[--a] = 0;
    if (a == 0) break;
  }
  transaction.commit();
}

}  // namespace morula
