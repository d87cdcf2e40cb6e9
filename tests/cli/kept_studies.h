#pragma once
// The shipped studies with the values that golden/FAMILY/NAME.csv keeps of all their runs. Some runs are made again, and
// must be to the last bit what is kept. With MORULA_WHOLE_STUDIES=1 in the environment all runs are made again, which
// takes a quarter of an hour of CPU time.
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "cli/document.h"
#include "launch.h"
#include "stored.h"
// Included last, because of CHECK:
#include "catch.h"

namespace morula::test {

/// The folder of a study below `scenarios/` and `golden/`.
inline std::string familyOf(const std::string& study) {
  if (study == "cleavage-rules") return "urchin/";
  return study == "worm-placement" || study == "ablations" ? "worm/" : "policies/";
}

/// Runs that the test makes again, by their number in the plan: of each study a few that take little time.
inline const std::map<std::string, std::vector<std::size_t>> madeAgain{
    {"policies", {0, 249, 499}},  {"placement", {0, 139}},      {"settings", {0}},
    {"models", {0, 80}},          {"settling", {0, 60, 99}},   {"heavier", {20, 59}},
    {"heavier-128", {8}},         {"elegans-128", {20}},        {"elegans-1024", {6}},
    {"worm-placement", {0, 863}}, {"ablations", {0, 129}}, {"cleavage-rules", {0, 100}}, {"clones", {0, 239, 479}},    {"settling-sticky", {0, 39}},
    {"settling-128", {6}},        {"beyond-chaos-42", {0, 30}}, {"beyond-chaos-162", {0, 15}},
    {"beyond-chaos-step", {30}},  {"beyond-chaos-box", {0}},    {"beyond-chaos-thesis", {0, 29}}};

inline std::string sourceFile(const std::string& name) { return std::string(MORULA_SOURCE_DIR) + "/" + name; }

/// A run's values as golden/FAMILY/NAME.csv keeps them (tests/studies/values.py).
struct KeptRun {
  std::string task, state, reason;                              // reason: of a run that failed
  std::vector<std::tuple<double, std::string, double>> values;  // time, measure, value
};

inline std::vector<KeptRun> keptRuns(const std::string& study) {
  std::istringstream lines(readWhole(sourceFile("golden/" + familyOf(study) + study + ".csv")));
  std::string line;
  std::getline(lines, line);
  const auto head = morula::partsOf(line, ',');
  std::vector<KeptRun> runs;
  while (std::getline(lines, line)) {
    const auto cells = morula::partsOf(line, ',');
    if (runs.empty() || runs.back().task != cells[0]) runs.push_back({cells[0], cells[1], "", {}});
    if (cells[1] == "failed") runs.back().reason = line.substr(line.find(",failed,") + 8);
    else
      for (std::size_t i = 3; i < cells.size(); ++i)
        if (!cells[i].empty()) runs.back().values.emplace_back(std::stod(cells[2]), head[i], std::stod(cells[i]));
  }
  return runs;
}

/// The values of the run with this id, in a merged database.
inline std::vector<std::tuple<double, std::string, double>> valuesIn(Database& db, const std::string& run) {
  std::vector<std::tuple<double, std::string, double>> values;
  Statement rows(db, "SELECT time, measure, value FROM result WHERE run_id = ? ORDER BY time, measure");
  for (rows.start(run); rows.next();) values.emplace_back(rows.real(0), rows.text(1), rows.real(2));
  return values;
}

/// Makes some of a study's runs and merges them; what the golden keeps of these must be what they gave. Then puts what
/// it keeps of all others beside them. Returns the database.
inline std::string databaseOf(const TemporaryFolder& temporary, const std::string& study) {
  const std::string to = temporary / study, file = to + "/study.db";
  if (std::filesystem::exists(file)) return file;
  INFO(study);
  const auto kept = keptRuns(study);
  Words command{"study",        "run",    "scenarios/" + familyOf(study) + study + ".study.yaml", "--out", to,
                "--no-predict", "--quiet"};
  const bool whole = std::getenv("MORULA_WHOLE_STUDIES");
  std::vector<std::size_t> made = madeAgain.at(study);
  if (whole)
    for (made.clear(); made.size() < kept.size();) made.push_back(made.size());
  for (const std::size_t number : made) command.insert(command.end(), {"--task", kept.at(number).task});
  succeeds(command);
  endsWith(whole ? 0 : 5, {"study", "merge", to, "--quiet"});  // most runs are missing
  Database db = opened(file);
  CHECK(db.integer("SELECT count(*) FROM task") == static_cast<std::int64_t>(kept.size()));
  CHECK(db.integer("SELECT count(*) FROM task WHERE status <> 'missing'") == static_cast<std::int64_t>(made.size()));
  db.execute("BEGIN; CREATE TEMPORARY TABLE copy AS SELECT * FROM run LIMIT 1");
  Statement find(db, "SELECT task.status, run_id, state_hash FROM task LEFT JOIN run USING (run_id) WHERE task_id = ?");
  Statement rename(db, "UPDATE copy SET run_id = ?, state_hash = ?");
  Statement add(db, "INSERT INTO run SELECT * FROM copy");
  Statement done(db, "UPDATE task SET status = 'done', run_id = ? WHERE task_id = ?");
  Statement failed(db, "UPDATE task SET status = 'failed', reason = ? WHERE task_id = ?");
  Statement value(db, "INSERT INTO result (run_id, time, measure, value) VALUES (?, ?, ?, ?)");
  for (const KeptRun& one : kept) {
    INFO(one.task);
    find.start(one.task);
    REQUIRE(find.next());
    const std::string status = find.text(0), id = find.text(1), state = find.text(2);
    find.next();
    if (status != "missing") {
      CHECK(status == (one.reason.empty() ? "done" : "failed"));
      if (one.reason.empty()) CHECK(state == one.state);
      CHECK(valuesIn(db, id) == one.values);
    } else if (!one.reason.empty()) {
      failed.run(one.reason, one.task);
    } else {
      rename.run(one.task, one.state);
      add.run();
      done.run(one.task, one.task);
      for (const auto& [time, measure, v] : one.values) value.run(one.task, time, measure, v);
    }
  }
  db.execute("COMMIT");
  reseal(file);
  return file;
}

}  // namespace morula::test
