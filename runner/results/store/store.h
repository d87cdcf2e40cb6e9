#pragma once
// A file of results: SQLite, one or many runs in it. The life of a run:
//
//   Store store = Store::openForWriting("results/unique-four.db");
//   std::string id = store.begin(record);   // the row `run`, status running, is on the disk before the first step
//   … step …
//   store.finish(id, end, results);         // all results, and the status done, failed or killed: one transaction
//   store.addChecks(id, checks);            // what `morula check` found
//
// A process that dies in between leaves the row with status running and no results; the file stays whole.
// One writer at a time: others wait (StoreOptions::patience), then get a StoreError.
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "database/database.h"
#include "store/contents.h"
#include "store/records.h"
#include "store/seal.h"
#include "store/table_difference.h"

namespace morula {

struct StoreOptions {
  std::chrono::milliseconds patience{30'000};  // how long to wait for another writer
};

struct SqlTable;

class Store {
 public:
  using Options = StoreOptions;

  /// Opens the file, and makes it if it is not there. Throws StoreError: not a database, not Morula's, from a
  /// newer Morula, directory missing or not writable, locked.
  static Store openForWriting(const std::filesystem::path& file, Options options = {});
  /// Opens a file that is there, to read from it.
  static Store openForReading(const std::filesystem::path& file, Options options = {});

  /// A database of its own that is gone with the Store: for results that are only to be compared.
  static Store temporary();

  /// Enters the run and returns its id. If the file has a finished run of that id, its row and results stay
  /// until `finish` has compared the two; unfinished or failed attempts are replaced now. A checkpoint of
  /// theirs stays until there is a later one: the same run goes through the same states.
  std::string begin(const RunRecord& record);

  /// Takes samples and hashes of a run that goes on, in their order. They lie apart from the file, and get into it with
  /// `finish` and `keepCheckpoint`, to which those that come later are given. Unless the file has a finished run or a
  /// checkpoint of this id, they get into it every few seconds, too, so that a program that is killed leaves them.
  void record(const std::string& id, const RunResults& records);

  /// Keeps what a run can be resumed from, in place of its last checkpoint, and those of `records`' samples and hashes
  /// that the file has not yet: a program killed at any moment leaves one whole checkpoint and what was recorded up to
  /// it. Not for a run that the file has finished, nor in place of a checkpoint of a later step. Returns whether there
  /// is one to resume from.
  bool keepCheckpoint(const std::string& id, const Checkpoint& checkpoint, const RunResults& records,
                      const FrameSource& frames = {});

  /// The step of the checkpoint that the run of this id can be resumed from.
  std::optional<std::uint64_t> checkpointStep(const std::string& id);

  /// Begins a run where its last checkpoint left it. Without one the run is not begun. `record` as for `begin`.
  std::optional<ResumedRun> resume(const RunRecord& record);

  /// Stores how the run ended and what it left behind, replacing what the file has of this id. Throws
  /// NondeterminismError, and leaves the file as it was, if a finished run of this id has another state hash (or this
  /// one failed). An attempt that was killed, or failed for want of something (Want), never replaces a finished run,
  /// for it says nothing against it; one that was killed keeps its checkpoint.
  void finish(const std::string& id, const RunEnd& end, const RunResults& results);

  /// Stores the run as `finish` does in a new file beside this one, "FILE-ID.db", since another process holds this one
  /// (BusyError). Returns the new file.
  Store finishBeside(const std::string& id, const RunEnd& end, const RunResults& results);

  /// Replaces the run's check results of the kinds that occur in `checks`.
  void addChecks(const std::string& id, const std::vector<CheckResult>& checks);

  /// Replaces the cells of the same scene in Bullet that are kept beside the run's own.
  void putBulletSamples(const std::string& id, const std::string& baseline, const std::vector<Sample>& samples);

  /// All runs, by start, then id.
  std::vector<StoredRun> runs();
  /// The run whose id is, or begins with, `id`; with "" the only run in the file or else the one that was
  /// started last. Throws StoreError if there is none or several.
  StoredRun find(const std::string& id);
  /// Everything the run left behind. State ids are numbered anew; their texts are the same.
  RunResults results(const std::string& id);
  /// Its samples, with the faces of their surfaces, and hashes, in parts, so that they are not in memory at a time.
  void eachRecord(const std::string& id, const RecordSink& take);
  /// Reads only the lineage, state texts and names.
  RunResults lineage(const std::string& id);
  std::vector<CheckResult> checks(const std::string& id);
  std::vector<ChainLink> chain(const std::string& id);
  std::vector<SourceText> documents(const std::string& id);

  /// Throws StoreError unless the rows of the run are those that were stored: each table is compared with its digest.
  void requireIntact(const std::string& id);
  /// requireIntact for all tables but those of the hashes on the way, which no verb shows that reads a run to show it.
  void requireShownIntact(const std::string& id);
  /// Throws StoreError if the rows of any run are not those that were stored, or rows belong to no run.
  void requireAllIntact();
  /// Lists the changes of a run's record since it was made: documents that do not fit the hashes that
  /// they are stored under, a run_id or build_id that does not follow from the row. Empty for a whole record.
  std::vector<ValueDifference> changedRecord(const std::string& id);
  /// Lists the signs that cells of an ended run are gone: a cell without its mother, a mother without both daughters,
  /// fewer leaves than the run counted. Empty for a whole lineage.
  std::vector<ValueDifference> lostCells(const StoredRun& run);
  /// The results of a run beside those of the same run made again and stored in `again` as `idAgain`: all tables that
  /// results are made of, in the order of the schema, by their keys; of `run` what the computation decides. Equal
  /// means: the same bits as far as SQLite keeps them (−0.0 is kept as 0.0, what is no number as NULL). Left out:
  /// `checkpoint`, which a finished run does not have, `bullet_sample`, and of `check_result` the kinds golden and
  /// bullet, which depend on what is not stored. Throws StoreError.
  std::vector<TableDifference> compareResults(const std::string& id, Store& again, const std::string& idAgain);
  /// All tables, in the order of the schema; why is said of those in `known`. `id`: rows of this run alone, "": of all.
  std::vector<TableContents> contents(const std::vector<const SqlTable*>& known, const std::string& id = {});

  /// The columns of a table, apart from bytes (BLOB); none if there is no such table.
  std::vector<std::string> columns(const std::string& table);
  /// Calls `take` for each row, with the values of `columns`, in the order of the table's key. `id`: rows with this
  /// run_id alone, if the table has that column; "": all. Throws StoreError for values of another type than the
  /// column's.
  void eachRow(const std::string& table, const std::string& id, const std::function<void(const TableRow&)>& take);

  /// Makes a file that holds this run alone. It must not be there yet.
  void copyRun(const std::string& id, const std::filesystem::path& file);

  const std::filesystem::path& file() const { return db_.file(); }

 private:
  friend class TaskFile;
  struct Attempt {
    RunRecord record;
    std::string started;
    bool storesOnTheWay = false;  // its records go into the file while it runs
    RecordedUntil until = {};     // of those that did
    double flushed = 0;           // [s] by the wall clock, when they did
  };
  void flush(const std::string& id, Attempt& attempt);
  /// The last sample and hash that the file holds up to this step.
  RecordedUntil recordedUntil(const std::string& id, std::uint64_t step);
  /// Copies the records that `record` took after `until` into the file.
  void takeOver(const std::string& id, const RecordedUntil& until = {});
  explicit Store(Database db) : db_(std::move(db)) {}
  Database db_;
  std::map<std::string, Attempt> attempts_;  // begun here and not finished, by id
  std::optional<Database> recorded_;         // what `record` took
};

}  // namespace morula
