#include "store/rows.h"

#include <algorithm>
#include <map>
#include <memory>

#include "base/error.h"
#include "store/result_rows.h"

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

bool isNew(std::uint64_t step, std::optional<std::uint64_t> after) { return !after || step > *after; }

/// Stores rows of any table of a run, with one statement for each table.
class Inserter {
 public:
  Inserter(Database& db, const std::string& id) : db_(db), id_(id) {}

  template <class Row, class... Context>
  void add(const Row& row, const Context&... context) {
    auto& insert = inserts_[&sqlTable<Row>()];
    if (!insert) insert = std::make_unique<Statement>(db_, sqlTable<Row>().insert());
    insert->run(id_, context..., row);
  }

 private:
  Database& db_;
  const std::string& id_;
  std::map<const SqlTable*, std::unique_ptr<Statement>> inserts_;
};

/// Stores faces as documents, which runs with the same mesh share. Faces that the run's record has are not stored
/// again.
void insertFaces(Database& db, const std::string& id, const std::vector<MeshFaces>& meshes) {
  constexpr int behindOthers = 1000;
  Statement known(db, "SELECT 1 FROM run_document WHERE run_id = ? AND role = 'faces' AND path = ?");
  Documents documents(db, id);
  for (const MeshFaces& m : meshes)
    if (const std::string path = std::to_string(m.mesh); !known.start(id, path).next())
      documents.add(behindOthers + m.mesh, "faces", path, faceBytes(m));
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
  Inserter inserter(db, id);
  visitRecords(results, [&](std::uint64_t step, const auto& row, const auto&... context) {
    if (isNew(step, after)) inserter.add(row, context...);
  });
  insertFaces(db, id, results.meshes);
}

void insertResults(Database& db, const std::string& id, const RunResults& results) {
  Inserter inserter(db, id);
  std::vector<CellRow> cells;
  visitEnd(results, 0, [&]<class Row>(std::uint64_t, const Row& row, const auto&... context) {
    if constexpr (std::is_same_v<Row, CellRow>) cells.push_back(row);
    else inserter.add(row, context...);
  });
  // Rows are inserted in the order of the table's key, so that the table grows at its end: many times faster than by
  // order of birth.
  std::ranges::sort(cells, {}, [](const CellRow& c) -> const CellPath& { return c.cell.path; });
  for (const CellRow& c : cells) inserter.add(c);
  insertRecords(db, id, results);
  insertChecks(db, id, results.checks);
  std::int64_t number = 0;
  for (const AgainstStage& stage : results.against) {
    inserter.add(stage, number++);
    for (const AgainstCell& cell : stage.byCell) inserter.add(cell);
  }
}

void replaceCheckpoint(Database& db, const std::string& id, const Checkpoint& c) {
  std::string update;
  for (const SqlColumn& column : sqlTable<CheckpointRow>().own)
    update += (update.empty() ? "" : ", ") + column.name + " = excluded." + column.name;
  Statement(db, sqlTable<CheckpointRow>().insert() + " ON CONFLICT DO UPDATE SET " + update)
      .run(id, CheckpointRow{c, utcNow()});
}

void insertChecks(Database& db, const std::string& id, const std::vector<CheckResult>& checks) {
  Statement next(db, "SELECT coalesce(max(number), -1) + 1 FROM check_result WHERE run_id = ?");
  next.start(id).next();
  std::int64_t number = next.integer(0);
  Inserter inserter(db, id);
  for (const CheckResult& check : checks) inserter.add(check, number++);
}

void insertBulletSamples(Database& db, const std::string& id, const std::string& baseline,
                         const std::vector<Sample>& samples) {
  Statement insert(db, sqlTable<BulletSampleRow>().insert());
  for (const Sample& sample : samples)
    for (const CellMeasures& c : sample.cells) insert.run(id, sample.world.time, BulletSampleRow{c, baseline});
}

}  // namespace morula
