#include "store/rows.h"

#include <algorithm>

#include "base/error.h"
#include "database/measure_columns.h"

namespace morula {

namespace {

void insertDocuments(Database& db, const std::string& id, const std::vector<SourceText>& documents) {
  Statement content(db, insertInto("document", "hash, content") + " ON CONFLICT DO NOTHING");
  Statement use(db, insertInto("run_document", "run_id, number, role, path, hash"));
  int number = 0;
  for (const SourceText& d : documents) {
    const std::string hash = Hasher().add(d.content).digest().text();
    content.run(hash, Blob{d.content});
    use.run(id, number++, d.role, d.path, hash);
  }
}

const std::string& stateText(const RunResults& results, StateId state) {
  const auto found = results.stateTexts.find(state);
  MORULA_CHECK(found != results.stateTexts.end(), "every state in the results has its text");
  return found->second;
}

void insertCells(Database& db, const std::string& id, const RunResults& results) {
  // In the order of the table's key, so that the table grows at its end: many times faster than by order of birth.
  std::vector<const LineageEntry*> entries;
  entries.reserve(results.lineage.size());
  for (const LineageEntry& e : results.lineage) entries.push_back(&e);
  std::sort(entries.begin(), entries.end(), [](auto* a, auto* b) { return a->path < b->path; });

  Statement insert(
      db, insertInto("cell", "run_id, path, parent, born, ended, fate, state, name, born_step, ended_step"));
  for (const LineageEntry* e : entries) {
    std::optional<double> ended;
    std::optional<std::uint64_t> endedStep;
    if (e->fate != Fate::alive) ended = e->ended, endedStep = e->endedStep;
    const std::string path = e->path.text();
    std::optional<std::string_view> parent;
    if (!path.empty()) parent = std::string_view(path).substr(0, path.size() - 1);
    std::optional<std::string_view> label;
    if (const auto found = results.names.find(e->path); found != results.names.end()) label = found->second;
    insert.run(id, path, parent, e->born, ended, name(e->fate), stateText(results, e->state), label,
               e->bornStep, endedStep);
  }
}

bool isNew(std::uint64_t step, std::optional<std::uint64_t> after) { return !after || step > *after; }

void insertSamples(Database& db, const std::string& id, const RunResults& results,
                   std::optional<std::uint64_t> after) {
  const auto world = columnsOf<Observation>(), ofCell = columnsOf<CellContext>(), ofPair = columnsOf<Touch>();
  Statement whole(db, insertInto("sample", "run_id, time, step", world));
  Statement cell(db, insertInto("cell_sample", "run_id, time, path, state", ofCell));
  Statement contact(db, insertInto("contact", "run_id, time, a, b", ofPair));
  Statement more(db, insertInto("measure", "run_id, time, scope, name, a, b, value"));
  Statement surface(db, insertInto("mesh_sample",
                                   "run_id, time, path, mesh, low_x, low_y, low_z, step_x, step_y, step_z, "
                                   "vertices"));
  for (const Sample& s : results.samples) {
    const WorldMeasures& w = s.world;
    if (!isNew(w.step, after)) continue;
    whole.run(id, w.time, w.step, valuesOf(w, world));
    for (const TakenMeasure& m : s.more)
      more.run(id, w.time, name(m.scope), m.name, m.a.text(), m.b.text(), m.value);
    for (const CellSurface& c : s.surfaces) {
      const std::string numbers = numberBytes(c);
      surface.run(id, w.time, c.path.text(), c.mesh, c.low.x, c.low.y, c.low.z, c.step.x, c.step.y, c.step.z,
                  Blob{numbers});
    }
    for (const CellMeasures& c : s.cells)
      cell.run(id, w.time, c.path.text(), stateText(results, c.state), valuesOf(c, ofCell));
    for (const ContactMeasures& c : s.contacts)
      contact.run(id, w.time, c.a.text(), c.b.text(), valuesOf(c, ofPair));
  }
}

/// As documents: runs with one mesh share them. Those that the run's record has already are the same.
void insertFaces(Database& db, const std::string& id, const std::vector<MeshFaces>& meshes) {
  constexpr int behindOthers = 1000;
  Statement content(db, insertInto("document", "hash, content") + " ON CONFLICT DO NOTHING");
  Statement known(db, "SELECT 1 FROM run_document WHERE run_id = ? AND role = 'faces' AND path = ?");
  Statement use(db, insertInto("run_document", "run_id, number, role, path, hash"));
  for (const MeshFaces& m : meshes) {
    const std::string faces = faceBytes(m), number = std::to_string(m.mesh);
    if (known.start(id, number).next()) continue;
    const std::string hash = Hasher().add(faces).digest().text();
    content.run(hash, Blob{faces});
    use.run(id, behindOthers + m.mesh, "faces", number, hash);
  }
}

void insertChain(Database& db, const std::string& id, const std::vector<ChainLink>& chain,
                 std::optional<std::uint64_t> after) {
  Statement link(db, insertInto("step_hash", "run_id, step, hash, state, clock, connections, lineage"));
  Statement cell(db, insertInto("cell_hash", "run_id, step, path, hash"));
  for (const ChainLink& l : chain) {
    if (!isNew(l.step, after)) continue;
    const StateHashes& s = l.state;
    link.run(id, l.step, l.hash.text(), s.whole.text(), s.clock.text(), s.connections.text(),
             s.lineage.text());
    for (const CellHash& c : s.cells) cell.run(id, l.step, c.path.text(), c.hash.text());
  }
}

}  // namespace

void insertRun(Database& db, const std::string& id, const RunRecord& r, const std::string& started,
               const RunEnd* end) {
  std::optional<std::string> hash, ended, failure;
  std::optional<std::uint64_t> steps, cells;
  std::optional<double> time;
  if (end) {
    ended = utcNow(), steps = end->steps, cells = end->cells, time = end->time;
    if (end->stateHash) hash = end->stateHash->text();
    if (!end->failure.empty()) failure = end->failure;
  }
  Statement(db, insertInto("run",
                           "run_id, scenario, seed, status, state_hash, started, ended, steps, "
                           "cells, time, failure, scenario_hash, build_id, version, sources, "
                           "git_commit, git_state, compiler, flags, target, "
                           "libraries, cpu, kernel, isa, threads, command, binary_hash, "
                           "fp_environment, cpu_features"))
      .run(id, r.scenario, r.seed, name(end ? end->status : RunStatus::running), hash, started, ended, steps,
           cells, time, failure, r.scenarioHash, buildId(r.build), r.build.version, r.build.sources,
           r.build.gitCommit, r.build.gitState, r.build.compiler, r.build.flags, r.build.target,
           librariesText(r.build), r.machine.cpu, r.machine.kernel, r.isa, r.threads, r.command, r.binaryHash,
           r.machine.fpEnvironment, r.machine.features);
  insertDocuments(db, id, r.documents);
}

void restartRun(Database& db, const std::string& id, const std::string& started) {
  Statement(db,
            "UPDATE run SET status = 'running', started = ?, ended = NULL, steps = NULL, cells = NULL, "
            "time = NULL, failure = NULL WHERE run_id = ?")
      .run(started, id);
  for (const char* table : {"cell", "connection", "time_step", "division"})
    Statement(db, std::string("DELETE FROM ") + table + " WHERE run_id = ?").run(id);
}

void endRun(Database& db, const std::string& id, const RunEnd& end) {
  Statement(db, "UPDATE run SET status = ?, ended = ?, steps = ?, cells = ?, time = ? WHERE run_id = ?")
      .run(name(end.status), utcNow(), end.steps, end.cells, end.time, id);
}

void deleteResults(Database& db, const std::string& id) {
  for (const char* table : {"cell", "sample", "cell_sample", "contact", "measure", "mesh_sample",
                            "connection", "time_step", "division", "step_hash", "cell_hash", "bullet_sample"})
    Statement(db, std::string("DELETE FROM ") + table + " WHERE run_id = ?").run(id);
}

void insertRecords(Database& db, const std::string& id, const RunResults& results,
                   std::optional<std::uint64_t> after) {
  insertSamples(db, id, results, after);
  insertFaces(db, id, results.meshes);
  insertChain(db, id, results.chain, after);
}

void insertResults(Database& db, const std::string& id, const RunResults& results) {
  insertCells(db, id, results);
  insertRecords(db, id, results);

  Statement connection(db, insertInto("connection", "run_id, number, a, b, made, released, cause"));
  std::uint64_t number = 0;
  for (const ConnectionRecord& c : results.connections)
    connection.run(id, number++, c.a.text(), c.b.text(), c.made,
                   c.released < 0 ? std::nullopt : std::optional(c.released), c.cause);

  Statement timeStep(db, insertInto("time_step", "run_id, step, time, time_step"));
  for (const TimeStepRecord& t : results.timeSteps) timeStep.run(id, t.step, t.time, t.timeStep);

  Statement division(
      db, insertInto("division", "run_id, path, time, step, axis_x, axis_y, axis_z, share, extent_ratio"));
  for (const DivisionRecord& d : results.divisions)
    division.run(id, d.path.text(), d.time, d.step, d.axis.x, d.axis.y, d.axis.z, d.share, d.extentRatio);

  insertChecks(db, id, results.checks);
}

void insertChecks(Database& db, const std::string& id, const std::vector<CheckResult>& checks) {
  Statement last(db, "SELECT coalesce(max(number), -1) FROM check_result WHERE run_id = ?");
  last.start(id).next();
  std::int64_t number = last.integer(0);
  Statement insert(db, insertInto("check_result",
                                  "run_id, number, \"check\", kind, expected, actual, tolerance, passed, "
                                  "class, first_step, cell, field, share_of_tolerance, message"));
  for (const CheckResult& c : checks)
    insert.run(id, ++number, c.check, c.kind, c.expected, c.actual, c.tolerance, c.passed, c.failureClass,
               c.firstStep, c.cell, c.field, c.share, c.message);
}

void insertBulletSamples(Database& db, const std::string& id, const std::string& baseline,
                         const std::vector<Sample>& samples) {
  const auto columns = bulletColumns();
  Statement insert(db, insertInto("bullet_sample", "run_id, time, path, baseline", columns));
  for (const Sample& sample : samples)
    for (const CellMeasures& c : sample.cells)
      insert.run(id, sample.world.time, c.path.text(), baseline, valuesOf(c, columns));
}

}  // namespace morula
