#include "study_db.h"

#include <set>

#include "database/database.h"
#include "store/result_file.h"
#include "store/rows.h"
#include "store/seal.h"
#include "study_store/study_tables.h"

namespace morula {

namespace {

template <class Row, class... Context>
void insert(Database& db, const Row& row, const Context&... context) {
  Statement(db, sqlTable<Row>().insert()).run(context..., row);
}

void makeTables(Database& db, const MadeStudy& study) {
  std::vector<std::string> names;
  for (const auto& axis : study.axes) names.push_back(axis.name);
  makeTaskTables(db);
  makeStudyTables(db, names, {});
  insert(db, StudyRow{"made", "A study that was never run", "", "", ""});
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    insert(db, AxisRow{a, names[a]});
    std::uint64_t number = 0;
    for (const std::string& label : study.axes[a].labels) insert(db, LevelRow{a, number++, label, "{}"});
  }
}

void insertTask(Database& db, const MadeStudy& study, const std::string& task, const std::vector<int>& levels,
                int seed) {
  const std::string trouble = study.trouble ? study.trouble(levels, seed) : "";
  TaskRow row{task, std::uint64_t(db.integer("SELECT count(*) FROM task")), 0, std::uint64_t(seed)};
  row.status = trouble.empty() ? TaskStatus::done : parseChoice<TaskStatus>(trouble);
  if (trouble == "failed") row.reason = "numerical failure: too fast";
  if (trouble != "missing") row.runId = task + "-run";
  insert(db, row);
  if (trouble == "missing") return;
  RunEnd end;
  if (study.cells) end.cells = std::uint64_t(study.cells(levels)) / (trouble == "failed" ? 2 : 1);
  if (trouble.empty()) end.stateHash = Hasher().field("state").add(task).digest();
  else end.status = RunStatus::failed;
  insertRun(db, row.runId, {}, "", &end);
  if (!trouble.empty()) return;
  for (const auto& [measure, value] : study.values(levels, seed))
    for (const double t : study.times) insert(db, ResultRow{measure, t, value * t / study.times.back()}, row.runId);
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
      insert(db, ReplicateRow{std::uint64_t(condition), std::uint64_t(seed), task});
    }
    std::size_t a = levels.size();
    while (a > 0 && ++levels[a - 1] == int(study.axes[a - 1].labels.size())) levels[--a] = 0;
    if (a == 0) break;
  }
  std::vector<std::string> runs;
  Statement ids(db, "SELECT run_id FROM run");
  while (ids.next()) runs.push_back(ids.text(0));
  for (const std::string& id : runs) sealRun(db, id);
  sealStudy(db);
  transaction.commit();
}

}  // namespace morula
