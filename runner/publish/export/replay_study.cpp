#include "export/replay_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "analysis/study_state.h"
#include "base/error.h"
#include "document/words.h"
#include "export/study_crate.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "files/scratch_folder.h"
#include "store/build_info.h"
#include "store/store.h"
#include "study_store/task_file.h"
#include "tasks/run_study.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t maxDerived = std::uint64_t{1} << 30;  // [byte]

/// Returns the number of the tasks that are repeated.
std::vector<std::size_t> chosenOf(const StudyResults& results, std::size_t count) {
  std::vector<std::size_t> done, chosen;
  for (std::size_t t = 0; t < results.tasks.size(); ++t)
    if (results.isDone(t)) done.push_back(t);
  count = std::min(count, done.size());
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(done[count < 2 ? 0 : i * (done.size() - 1) / (count - 1)]);
  return chosen;
}

/// A value of a study: measure, time, value.
using Value = std::tuple<std::string, double, double>;

std::vector<Value> valuesIn(const fs::path& file, const std::string& run) {
  Database db(file, Database::Mode::existing, std::chrono::seconds(30));
  Statement rows(db, "SELECT measure, time, value FROM result WHERE run_id = ? ORDER BY measure, time");
  std::vector<Value> values;
  for (rows.start(run); rows.next();) values.emplace_back(rows.text(0), rows.real(1), rows.real(2));
  return values;
}

/// Compares a run of the study with the file of the repeated task, row by row. Their ids differ where builds do.
StudyReplay::Run compared(const fs::path& database, const ResultTask& then, const fs::path& again) {
  StudyReplay::Run run{.name = "", .then = then.stateHash, .now = ""};
  if (!fileExists(again)) return run;
  const StoredRun now = TaskFile(again).run();
  run.now = now.stateHash;
  auto stored = Store::openForReading(database), repeated = Store::openForReading(again);
  for (const TableDifference& table : stored.compareResults(then.runId, repeated, now.id))
    run.rows += table.rows, run.differing += table.differing;
  const auto a = valuesIn(database, then.runId), b = valuesIn(again, now.id);
  run.rows += a.size(), run.differing += a != b;
  return run;
}

void repeatRuns(const fs::path& crate, const StudyResults& results, std::size_t count, const TaskSettings& settings,
                StudyReplay& replay) {
  const fs::path database = crate / "study.db";
  const Study study = loadStudy(crate / inputsOf(database).studyFile, true);
  const PlanDifference difference = differenceFrom(database, study);
  replay.plan = difference.stale;
  replay.plan.insert(replay.plan.end(), difference.lacking.begin(), difference.lacking.end());
  if (!replay.plan.empty()) return;  // other tasks have other numbers
  const ScratchFolder scratch("");   // in the current folder
  const PlannedStudy planned = openStudy(
      {.what = study.file, .to = (scratch.path() / "study").string(), .allowOutside = true}, {.predict = false});
  keepPlan(planned);
  const std::vector<std::size_t> tasks = chosenOf(results, count);
  runStudy(planned, {.tasks = tasks, .jobs = 1, .retryFailed = false, .settings = settings, .quiet = true});
  for (const std::size_t task : tasks) {
    replay.runs.push_back(compared(database, results.tasks[task], planned.folder.task(planned.plan.tasks[task].id)));
    replay.runs.back().name = nameOfTask(planned.plan, task);
  }
}

}  // namespace

bool StudyReplay::sameBytes() const {
  return changed.empty() && plan.empty() && std::ranges::all_of(runs, &Run::isSame) &&
         std::ranges::all_of(derived, [](const auto& d) { return d.second; });
}

StudyReplay replayStudy(const fs::path& crate, std::size_t count, const TaskSettings& settings) {
  const fs::path database = crate / "study.db";
  if (!isFolder(crate) || !fileExists(database) || !fileExists(crate / "ro-crate-metadata.json"))
    throw FileError("'" + crate.string() +
                    "' is no crate of a study: a folder with study.db and ro-crate-metadata.json, which `morula study "
                    "export` makes (unpack a zip first)");
  const StudyResults results = readStudyResults(database);
  StudyReplay replay;
  replay.study = results.name;
  replay.buildThen = results.buildId, replay.buildNow = buildId(buildInfo());
  repeatRuns(crate, results, count, settings, replay);  // first, since it may leave nothing in this very folder
  replay.files = everyFileBelow(crate).size() - 1;
  replay.changed = changedFiles(crate);
  for (const CrateFile& file : derivedFiles(database))
    replay.derived.emplace_back(
        file.path, fileExists(crate / file.path) && readFile(crate / file.path, maxDerived) == file.content);
  return replay;
}

std::string describe(const StudyReplay& r) {
  std::string text = r.study + ": replayed from its crate\n";
  if (r.buildThen != r.buildNow)
    text += fmt::format("  program  another build: then {}, now {}\n", r.buildThen, r.buildNow);
  text += r.changed.empty() ? fmt::format("  files    all {} have the bytes that the metadata tells\n", r.files) : "";
  for (const std::string& line : r.changed) text += "  files    DIFFERS " + line + '\n';
  text += r.plan.empty() ? "  plan     the same\n" : "";
  for (const std::string& line : r.plan) text += "  plan     DIFFERS " + line + '\n';
  for (const auto& run : r.runs)
    text += fmt::format("  run      {}: {}\n", run.name,
                        run.isSame()      ? fmt::format("the same state {}, all {} rows the same", run.now, run.rows)
                        : run.now.empty() ? "DIFFERS: it did not end"
                        : run.then != run.now ? "DIFFERS: state then " + run.then + ", now " + run.now
                                              : fmt::format("DIFFERS in {} of {} rows", run.differing, run.rows));
  for (const auto& [file, isSame] : r.derived)
    text += fmt::format("  {}  {}\n", isSame ? "the same" : "DIFFERS ", file);
  return text + (r.sameBytes() ? "the same bytes\n" : "NOT the same bytes\n");
}

Json toJson(const StudyReplay& r) {
  Json runs = Json::array(), derived = Json::array();
  for (const auto& run : r.runs)
    runs.push_back({{"run", run.name},
                    {"then", run.then},
                    {"now", run.now},
                    {"rows", run.rows},
                    {"differing", run.differing},
                    {"same", run.isSame()}});
  for (const auto& [file, isSame] : r.derived) derived.push_back({{"file", file}, {"same", isSame}});
  return {{"study", r.study},
          {"same_bytes", r.sameBytes()},
          {"build", {{"then", r.buildThen}, {"now", r.buildNow}}},
          {"files", {{"compared", r.files}, {"changed", r.changed}}},
          {"plan", r.plan},
          {"runs", runs},
          {"derived", derived}};
}

}  // namespace morula
