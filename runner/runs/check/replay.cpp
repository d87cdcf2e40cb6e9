#include "check/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "check/check_run.h"
#include "check/sanity_check.h"
#include "files/text.h"
#include "loop/simulate.h"
#include "store/run_tables.h"

namespace morula {
namespace {

/// Makes the record of the same run under the conditions of now.
RunRecord recordNow(const RunRecord& before, const Scenario& scenario, const Execution& how, const std::string& command,
                    std::vector<SourceText> documents) {
  RunRecord now;
  now.scenario = before.scenario;
  now.scenarioHash = scenario.meaning.text();
  now.seed = scenario.scene.seed;
  now.documents = std::move(documents);
  now.command = command;
  now.isa = name(how.isa);
  now.threads = how.threads;
  return now;
}

std::string endText(const std::string& hash, const std::string& failure) {
  return failure.empty() ? hash : "failed: " + failure;
}

void compareEnds(const StoredRun& before, const std::vector<ChainLink>& hashes, const Simulation& run, Replay& c) {
  c.hashBefore = endText(before.stateHash, before.failure);
  c.hashNow = endText(run.end.stateHash ? run.end.stateHash->text() : "", run.end.failure);
  c.hashesBefore = hashes.size();
  c.hashesNow = run.results.chain.size();
  const auto [a, b] = std::mismatch(hashes.begin(), hashes.end(), run.results.chain.begin(), run.results.chain.end());
  if (a != hashes.end()) c.firstDifference = a->step;
  else if (b != run.results.chain.end()) c.firstDifference = b->step;
}

/// Drops a table in which the two cannot be expected to agree, and says why.
void leaveOut(Replay& c, const std::string& table, const std::string& why) {
  const auto found =
      std::find_if(c.tables.begin(), c.tables.end(), [&](const TableDifference& t) { return t.table == table; });
  if (found == c.tables.end()) return;
  c.tables.erase(found);
  c.notCompared.push_back(table + ": " + why);
}

/// Compares the stored tables of a run with those of the repeated run.
void compareTables(Store& stored, const StoredRun& before, Store& again, const RunRecord& now, bool checked,
                   Replay& c) {
  c.tables = stored.compareResults(before.id, again, runId(now));
  const bool sameProgram = buildId(before.record.build) == buildId(now.build);
  std::vector<std::string> later;
  for (const TableDifference& t : c.tables)
    if (!t.missing.empty()) c.notCompared.push_back(t.table + ": the file has no column for " + join(t.missing));
  for (const TableDifference& t : c.tables)
    if (!sameProgram && t.rows == 0 && t.recomputedRows > 0) later.push_back(t.table);
  for (const std::string& table : later)
    leaveOut(c, table,
             "another program, which had no such column, stored the "
             "run");
  // `keep: {samples: end}`
  bool ofStudy = false;
  for (const TableContents& t : stored.contents(runTables())) ofStudy |= t.table == "task";
  std::vector<std::string> endAlone;
  for (const TableDifference& t : c.tables)
    for (const char* table : {"sample", "cell_sample", "contact", "measure", "connection"})
      if (ofStudy && t.table == table && t.rows < t.recomputedRows) endAlone.push_back(t.table);
  for (const std::string& table : endAlone) leaveOut(c, table, "the study keeps samples of the end only");
  std::size_t elsewhere = 0;
  for (const CheckResult& r : stored.checks(before.id))
    elsewhere += r.kind == CheckKind::golden || r.kind == CheckKind::bullet;
  if (!checked) leaveOut(c, "check_result", "the run was not checked");
  if (elsewhere > 0)
    c.notCompared.push_back(
        fmt::format("check_result: {} of kind golden or bullet, which depend on data that is not stored", elsewhere));
  for (const TableContents& t : stored.contents(runTables(), before.id))
    if (t.table == "against_stage" && t.rows > 0)
      c.notCompared.push_back("against_stage, against_cell: the table of measured cells is not stored");
    else if (t.table == "bullet_sample" && t.rows > 0)
      c.notCompared.push_back("bullet_sample: Bullet is not run again");
}

std::string describe(const ValueDifference& d) {
  if (d.column.empty()) return fmt::format("{}: stored: {}; recomputed: {}", d.row, d.stored, d.recomputed);
  return fmt::format("{}: {}: stored {}, recomputed {}", d.row, d.column, d.stored, d.recomputed);
}

std::string describeTables(const Replay& c) {
  std::string text;
  std::size_t same = 0;
  std::uint64_t rows = 0;
  for (const TableDifference& t : c.tables) {
    if (t.differing == 0) ++same, rows += t.rows;
    else
      text += fmt::format(
          "  {:<15} {} of {} rows differ{}\n    first {}\n", t.table, t.differing, std::max(t.rows, t.recomputedRows),
          t.rows == t.recomputedRows ? "" : fmt::format(" ({} are stored, {} recomputed)", t.rows, t.recomputedRows),
          describe(*t.first));
  }
  text += fmt::format("  tables          {}{} the same, {} rows\n", same == c.tables.size() ? "all " : "", same, rows);
  for (const std::string& what : c.notCompared) text += fmt::format("  not compared    {}\n", what);
  return text;
}

Json toJson(const ValueDifference& d) {
  return {{"table", d.table}, {"row", d.row}, {"column", d.column}, {"stored", d.stored}, {"recomputed", d.recomputed}};
}

/// The kinds of checks that the run was held against and that it decides itself: it is again. Sanity is measured of
/// every run with bodies that came to its end, so rows that are not there were taken out.
std::set<CheckKind> kindsOfChecks(Store& store, const StoredRun& run, const Scenario& scenario) {
  std::set<CheckKind> kinds;
  if (run.status == RunStatus::done && scenario.scene.mechanics) kinds.insert(CheckKind::sanity);
  for (const CheckResult& r : store.checks(run.id))
    if (r.kind != CheckKind::golden && r.kind != CheckKind::bullet) kinds.insert(r.kind);
  return kinds;
}

}  // namespace

Replay replay(Store& store, const StoredRun& before, const Scenario& scenario, const ReplayQuestion& question) {
  Replay c;
  const Execution& how = question.execution;
  const RunRecord now = recordNow(before.record, scenario, how, question.command, store.documents(before.id));
  c.conditions = compareConditions(before.record, now);
  const std::vector<ChainLink> hashes = store.chain(before.id);

  const auto kinds = kindsOfChecks(store, before, scenario);
  // A study may have kept the hashes of the end alone.
  const bool endAlone = hashes.size() == 1 && hashes.front().step == before.steps && before.steps > 0;
  RecordOptions recording = recordingOf(scenario, !hashes.empty() && !endAlone);
  recording.hashEnd = endAlone;
  CheckedRun checked = simulateChecked(scenario, how, {.quiet = question.quiet, .record = recording},
                                       kinds.contains(CheckKind::invariant));
  Simulation& run = checked.run;
  requireEnough(run.end);
  run.results.checks = checkWithoutGolden(scenario, checked);
  run.results.checks.insert(run.results.checks.end(), checked.sanity.begin(), checked.sanity.end());
  std::erase_if(run.results.checks, [&](const CheckResult& r) { return !kinds.contains(r.kind); });
  compareEnds(before, hashes, run, c);
  auto again = Store::temporary();
  again.finish(again.begin(now), run.end, run.results);
  compareTables(store, before, again, now, !kinds.empty(), c);
  if (!question.databaseOut.empty()) {
    auto out = Store::openForWriting(question.databaseOut);
    out.finish(out.begin(now), run.end, run.results);
  }
  return c;
}

std::string describe(const Replay& c, const StoredRun& run) {
  auto text = fmt::format("{}  seed {}: run {}, replayed\n", run.record.scenario, run.record.seed, run.id);
  if (!c.record.empty()) {
    text = fmt::format("{}  seed {}: run {}, not replayed, because its record was changed since it was stored\n",
                       run.record.scenario, run.record.seed, run.id);
    for (const ValueDifference& d : c.record) text += fmt::format("  {:<15} {}\n", d.table, describe(d));
    return text + "NOT the same record\n";
  }
  std::size_t same = 0;
  for (const auto& [name, label, before, now] : c.conditions) {
    if (before == now) ++same;
    else text += fmt::format("  {:<15} differs\n    then  {}\n    now   {}\n", label, before, now);
  }
  text += same == c.conditions.size() ? fmt::format("  conditions      all {} the same\n", same)
                                      : fmt::format("  conditions      {} others the same\n", same);
  if (c.hashBefore == c.hashNow) text += fmt::format("  state           the same: {}\n", c.hashNow);
  else text += fmt::format("  state           differs\n    then  {}\n    now   {}\n", c.hashBefore, c.hashNow);
  if (c.firstDifference) text += fmt::format("  steps           differ first at step {}\n", *c.firstDifference);
  else if (c.hashesBefore > 0)
    text += fmt::format("  steps           all {} hashes on the way the same\n", c.hashesBefore);
  else text += "  steps           none were hashed on the way\n";
  return text + describeTables(c) + (c.sameBits() ? "the same bits\n" : "NOT the same bits\n");
}

Json toJson(const Replay& c, const StoredRun& run) {
  Json conditions = Json::array(), tables = Json::array(), record = Json::array();
  for (const auto& [name, label, before, now] : c.conditions)
    conditions.push_back({{"item", name}, {"then", before}, {"now", now}, {"same", before == now}});
  for (const TableDifference& t : c.tables)
    tables.push_back({{"table", t.table},
                      {"stored", t.rows},
                      {"recomputed", t.recomputedRows},
                      {"differing", t.differing},
                      {"first", t.first ? toJson(*t.first) : Json()}});
  for (const ValueDifference& d : c.record) record.push_back(toJson(d));
  return {{"run_id", run.id},
          {"scenario", run.record.scenario},
          {"seed", run.record.seed},
          {"same_bits", c.sameBits()},
          {"state_hash", {{"then", c.hashBefore}, {"now", c.hashNow}, {"same", c.hashBefore == c.hashNow}}},
          {"step_hashes",
           {{"then", c.hashesBefore}, {"now", c.hashesNow}, {"first_difference", orNull(c.firstDifference)}}},
          {"record", record},
          {"tables", tables},
          {"not_compared", c.notCompared},
          {"conditions", conditions}};
}

}  // namespace morula
