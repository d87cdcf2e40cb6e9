#include "store/rows.h"

#include <algorithm>

#include "base/error.h"
#include "store/run_tables.h"

namespace morula {
namespace {

class Documents {
 public:
  Documents(Database& db, const std::string& id)
      : id_(id),
        text_(db, sqlTable<StoredText>().insert() + " ON CONFLICT DO NOTHING"),
        use_(db, sqlTable<DocumentUse>().insert()) {}
  void add(int number, const std::string& role, const std::string& path, const std::string& content) {
    const StoredText text{Hasher().add(content).digest().text(), content};
    text_.run(text);
    use_.run(id_, number, DocumentUse{role, path, text.hash});
  }

 private:
  const std::string& id_;
  Statement text_, use_;
};

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
  Statement insert(db, sqlTable<CellRow>().insert());
  for (const LineageEntry* e : entries) {
    const auto label = results.names.find(e->path);
    insert.run(id, CellRow{*e, stateText(results, e->state),
                           label == results.names.end() ? std::nullopt : std::optional(label->second)});
  }
}

bool isNew(std::uint64_t step, std::optional<std::uint64_t> after) { return !after || step > *after; }

void insertSamples(Database& db, const std::string& id, const RunResults& results, std::optional<std::uint64_t> after) {
  Statement whole(db, sqlTable<WorldMeasures>().insert()), cell(db, sqlTable<CellSampleRow>().insert()),
      contact(db, sqlTable<ContactMeasures>().insert()), more(db, sqlTable<TakenMeasure>().insert()),
      surface(db, sqlTable<CellSurface>().insert());
  for (const Sample& s : results.samples) {
    const double time = s.world.time;
    if (!isNew(s.world.step, after)) continue;
    whole.run(id, s.world);
    for (const TakenMeasure& m : s.more) more.run(id, time, m);
    for (const CellSurface& c : s.surfaces) surface.run(id, time, c);
    for (const CellMeasures& c : s.cells) cell.run(id, time, CellSampleRow{c, stateText(results, c.state)});
    for (const ContactMeasures& c : s.contacts) contact.run(id, time, c);
  }
}

/// As documents: runs with one mesh share them. Those that the run's record has already are the same.
void insertFaces(Database& db, const std::string& id, const std::vector<MeshFaces>& meshes) {
  constexpr int behindOthers = 1000;
  Statement known(db, "SELECT 1 FROM run_document WHERE run_id = ? AND role = 'faces' AND path = ?");
  Documents documents(db, id);
  for (const MeshFaces& m : meshes)
    if (const std::string path = std::to_string(m.mesh); !known.start(id, path).next())
      documents.add(behindOthers + m.mesh, "faces", path, faceBytes(m));
}

void insertChain(Database& db, const std::string& id, const std::vector<ChainLink>& chain,
                 std::optional<std::uint64_t> after) {
  Statement link(db, sqlTable<ChainLink>().insert()), cell(db, sqlTable<CellHash>().insert());
  for (const ChainLink& l : chain) {
    if (!isNew(l.step, after)) continue;
    link.run(id, l);
    for (const CellHash& c : l.state.cells) cell.run(id, l.step, c);
  }
}

template <class Row>
void insertAll(Database& db, const std::string& id, const std::vector<Row>& rows, std::int64_t number = 0) {
  Statement insert(db, sqlTable<Row>().insert());
  for (const Row& row : rows)
    if constexpr (std::string_view(tableInfo<Row>.context).ends_with("number")) insert.run(id, number++, row);
    else insert.run(id, row);
}

}  // namespace

void insertRun(Database& db, const std::string& id, const RunRecord& record, const std::string& started,
               const RunEnd* end) {
  StoredRun run{.id = id, .record = record, .started = started};
  if (end) {
    run.status = end->status, run.ended = utcNow(), run.steps = end->steps, run.cells = end->cells;
    run.time = end->time, run.failure = end->failure;
    if (end->stateHash) run.stateHash = end->stateHash->text();
  }
  Statement(db, sqlTable<StoredRun>().insert()).run(run);
  Documents documents(db, id);
  int number = 0;
  for (const SourceText& d : record.documents) documents.add(number++, d.role, d.path, d.content);
}

void restartRun(Database& db, const std::string& id, const std::string& started) {
  Statement(db,
            "UPDATE run SET status = 'running', started = ?, ended = NULL, steps = NULL, cells = NULL, "
            "time = NULL, failure = NULL WHERE run_id = ?")
      .run(started, id);
  deleteRows(db, id, [](TablePart part) { return part == TablePart::end; });
}

void endRun(Database& db, const std::string& id, const RunEnd& end) {
  Statement(db,
            "UPDATE run SET status = ?, ended = ?, steps = ?, cells = ?, time = ?, failure = nullif(?, ''), "
            "state_hash = ? WHERE run_id = ?")
      .run(name(end.status), utcNow(), end.steps, end.cells, end.time, end.failure,
           end.stateHash ? std::optional(end.stateHash->text()) : std::nullopt, id);
}

void deleteRows(Database& db, const std::string& id, bool (*takes)(TablePart)) {
  for (const SqlTable* t : runTables())
    if (takes(t->info.part)) Statement(db, std::string("DELETE FROM ") + t->info.name + " WHERE run_id = ?").run(id);
}

void insertRecords(Database& db, const std::string& id, const RunResults& results, std::optional<std::uint64_t> after) {
  insertSamples(db, id, results, after);
  insertFaces(db, id, results.meshes);
  insertChain(db, id, results.chain, after);
}

void insertResults(Database& db, const std::string& id, const RunResults& results) {
  insertCells(db, id, results);
  insertRecords(db, id, results);
  insertAll(db, id, results.connections);
  insertAll(db, id, results.timeSteps);
  insertAll(db, id, results.settlings);
  insertAll(db, id, results.divisions);
  insertChecks(db, id, results.checks);
}

void insertChecks(Database& db, const std::string& id, const std::vector<CheckResult>& checks) {
  Statement next(db, "SELECT coalesce(max(number), -1) + 1 FROM check_result WHERE run_id = ?");
  next.start(id).next();
  insertAll(db, id, checks, next.integer(0));
}

void insertBulletSamples(Database& db, const std::string& id, const std::string& baseline,
                         const std::vector<Sample>& samples) {
  Statement insert(db, sqlTable<BulletSampleRow>().insert());
  for (const Sample& sample : samples)
    for (const CellMeasures& c : sample.cells) insert.run(id, sample.world.time, BulletSampleRow{c, baseline});
}

}  // namespace morula
