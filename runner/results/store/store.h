#pragma once
// A file of results: an SQLite database of one or many runs. The life of a run:
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
#include <string_view>
#include <vector>

#include "database/database.h"
#include "store/contents.h"
#include "store/records.h"
#include "store/seal.h"
#include "store/table_difference.h"

namespace morula {

struct StoreOptions {
  std::chrono::milliseconds patience{30'000};  // max wait for another writer
};

struct SqlTable;

class Store {
 public:
  using Options = StoreOptions;

  /// Opens the file, and makes it if it is missing. Throws StoreError if the file is no database, not Morula's, from a
  /// newer Morula or locked, or its directory is missing or not writable.
  static Store openForWriting(const std::filesystem::path& file, Options options = {});
  /// Opens an existing file, to read from it.
  static Store openForReading(const std::filesystem::path& file, Options options = {});

  /// Returns a temporary database, which ends with the Store: for results that are only to be compared.
  static Store temporary();
  /// Returns a database in memory: an empty one, or one from the bytes that `bytes` gave. Throws StoreError for others.
  static Store inMemory(std::string_view bytes = {});
  /// Returns the database as the bytes of a file.
  std::string bytes() { return db_.bytes(); }

  /// Enters the run and returns its id. If the file has a finished run of that id, its row and results stay until
  /// `finish` has compared the two. Unfinished or failed attempts are replaced now, but their checkpoint stays until
  /// there is a later one, since the same run goes through the same states.
  std::string begin(const RunRecord& record);

  /// Takes samples and hashes of a run in progress, in their order. They are kept apart from the file until `finish`
  /// and `keepCheckpoint`, which are given the later ones. If the file has neither a finished run nor a checkpoint of
  /// this id, they are also stored every few seconds, in case the program is killed.
  void record(const std::string& id, const RunResults& records);

  /// Stores a checkpoint, in place of the last one, and the samples and hashes in `records` that the file lacks. A
  /// program killed at any moment leaves one whole checkpoint and the records up to it. Does nothing if the file has a
  /// finished run or a later checkpoint. Returns true if there is a checkpoint.
  bool keepCheckpoint(const std::string& id, const Checkpoint& checkpoint, const RunResults& records,
                      const FrameSource& frames = {});

  /// Returns the step of the checkpoint from which the unfinished run of this id can be resumed.
  std::optional<std::uint64_t> checkpointStep(const std::string& id);

  /// Returns the last checkpoint of a run, ended or not, from which other runs may go on.
  std::optional<Checkpoint> checkpointOf(const std::string& id);

  /// Begins an unfinished run at its last checkpoint. Without one the run is not begun. `record`: as for `begin`.
  std::optional<ResumedRun> resume(const RunRecord& record);

  /// Stores the end and the results of the run, replacing its rows in the file. Throws NondeterminismError, and leaves
  /// the file unchanged, if a finished run of this id has another state hash (or this run failed). An attempt that was
  /// killed or lacked a resource (Want) never replaces a finished run. A killed attempt keeps its checkpoint.
  /// `last`: the checkpoint that a finished run keeps, of a state before its stop.
  void finish(const std::string& id, const RunEnd& end, const RunResults& results,
              const std::optional<Checkpoint>& last = {});

  /// Stores the run as `finish` does, but in a new file "FILE-ID.db" beside this one, if another process holds this
  /// file (BusyError). Returns the new file.
  Store finishBeside(const std::string& id, const RunEnd& end, const RunResults& results,
                     const std::optional<Checkpoint>& last = {});

  /// Replaces the run's check results of the kinds that occur in `checks`.
  void addChecks(const std::string& id, const std::vector<CheckResult>& checks);

  /// Replaces the stored cells of the same scene in Bullet.
  void putBulletSamples(const std::string& id, const std::string& baseline, const std::vector<Sample>& samples);

  /// Returns all runs, by start, then id.
  std::vector<StoredRun> runs();
  /// Returns the run whose id is, or begins with, `id`; for "" the only run in the file or else the one started last.
  /// Throws StoreError if no run matches or several do.
  StoredRun find(const std::string& id);
  /// Returns all results of the run. State ids are numbered anew; their texts are the same.
  RunResults results(const std::string& id);
  /// Calls `take` with parts of the run's samples, their surfaces' faces, and hashes; they are never in memory as a
  /// whole.
  void eachRecord(const std::string& id, const RecordSink& take);
  /// Reads only the lineage, state texts and what experiments have done.
  RunResults lineage(const std::string& id);
  /// Reads the lineage and the samples, without surfaces.
  RunResults measured(const std::string& id);
  std::vector<CheckResult> checks(const std::string& id);
  std::vector<ChainLink> chain(const std::string& id);
  std::vector<SourceText> documents(const std::string& id);

  /// Throws StoreError unless the rows of the run are those that were stored: each table is compared with its digest.
  void requireIntact(const std::string& id);
  /// requireIntact for all tables but those of the hashes on the way, which no verb shows that reads a run to show it.
  void requireShownIntact(const std::string& id);
  /// Throws StoreError if the rows of any run are not those that were stored, or rows belong to no run.
  void requireAllIntact();
  /// Lists the changes of a run's record since it was made: documents that do not match their hashes, a run_id or
  /// build_id that does not follow from the row. Empty for an unchanged record.
  std::vector<ValueDifference> changedRecord(const std::string& id);
  /// Lists the signs that cells of an ended run are gone: a cell without its mother, a mother without both daughters,
  /// fewer leaves than the run counted. Empty for a whole lineage.
  std::vector<ValueDifference> lostCells(const StoredRun& run);
  /// Compares the results of a run with those of its repetition, stored in `again` as `idAgain`: all tables of results,
  /// in the order of the schema, by their keys. Of `run` it compares the columns that the computation decides. Equal
  /// means the same bits as far as SQLite keeps them (−0.0 is kept as 0.0, NaN as NULL). Left out are `checkpoint`,
  /// which is no result, `bullet_sample`, and check results of the kinds golden and bullet, which
  /// depend on data that is not stored. Throws StoreError.
  std::vector<TableDifference> compareResults(const std::string& id, Store& again, const std::string& idAgain);
  /// Returns all tables, in the order of the schema; those in `known` with their purpose. `id`: counts only this run's
  /// rows; "": all rows.
  std::vector<TableContents> contents(const std::vector<const SqlTable*>& known, const std::string& id = {});

  /// Returns the columns of a table, but those of bytes (BLOB); none if there is no such table.
  std::vector<std::string> columns(const std::string& table);
  /// Calls `take` for each row, with the values of `columns`, in the order of the table's key. `id`: only rows with
  /// this run_id, if the table has that column; "": all rows. Throws StoreError for values of another type than the
  /// column's.
  void eachRow(const std::string& table, const std::string& id, const std::function<void(const TableRow&)>& take);

  /// Makes a file that holds only this run. The file must not exist.
  void copyRun(const std::string& id, const std::filesystem::path& file);

  const std::filesystem::path& file() const { return db_.file(); }

 private:
  friend class TaskFile;
  struct Attempt {
    RunRecord record;
    std::string started;
    bool storesOnTheWay = false;  // true: its records are stored while it runs
    RecordedUntil until = {};     // the last records stored while it ran
    double flushed = 0;           // [s] by the wall clock: when they were stored
  };
  void flush(const std::string& id, Attempt& attempt);
  /// Returns the last sample and hash that the file holds up to this step.
  RecordedUntil recordedUntil(const std::string& id, std::uint64_t step);
  /// Copies the records that `record` took after `until` into the file.
  void takeOver(const std::string& id, const RecordedUntil& until = {});
  explicit Store(Database db) : db_(std::move(db)) {}
  Database db_;
  std::map<std::string, Attempt> attempts_;  // attempts begun by this Store and not finished, by id
  std::optional<Database> recorded_;         // the records that `record` took
};

}  // namespace morula
