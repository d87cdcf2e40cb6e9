#include "database/database.h"

#include <sqlite3.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>
#include <thread>
#include <utility>

#include "base/error.h"
#include "base/hash.h"
#include "database/store_error.h"
#include "files/folders.h"
#include "files/printable.h"
#include "files/read_file.h"
#include "system/clock.h"
#include "system/console.h"

namespace morula {
namespace {

namespace fs = std::filesystem;

/// Returns a remedy for SQLite's error code; "" if there is none.
std::string remedy(int code, int systemError, const fs::path& file) {
  rlimit limit{};
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  switch (code & 0xff) {
    case SQLITE_NOTADB: return "the file is not an SQLite database; give another file";
    case SQLITE_CORRUPT: return "the file is damaged; give another file, or restore it from a copy";
    case SQLITE_BUSY:
    case SQLITE_LOCKED: return "another process holds the file; wait until it has finished, or give another file";
    case SQLITE_READONLY:
      return "the file or its directory is not writable; change its permissions or give another file";
    case SQLITE_FULL: return "the disk is full; free some space or give a file on another disk";
    case SQLITE_CANTOPEN:
      if (!fileExists(folder))
        return "the directory " + folder.string() + " does not exist; make it or give another file";
      if (isFolder(file)) return "the path is a directory; give a file";
      if (!fileExists(file))
        return "the file does not exist and cannot be made in " + folder.string() +
               "; check that the directory is writable";
      return "the file cannot be opened; check that the file and its directory are readable and writable";
    case SQLITE_IOERR:
      // SQLite has rolled back, so nothing that was stored is lost.
      if (getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        return "files may not grow beyond " + std::to_string(limit.rlim_cur) + " bytes here (ulimit -f)";
      return systemError ? std::strerror(systemError) : "";
    case SQLITE_TOOBIG: return "a single value must stay below 1 GB";
    default: return "";
  }
}

constexpr double toldAfter = 2;  // [s] of waiting until the user is told: nobody notices shorter waits

/// Lets SQLite keep its temporary data beside the results, since the system's folder may be small. A folder that the
/// user has named in the environment stays.
void keepTemporaryDataBeside(const fs::path& file) {
  if (std::getenv("SQLITE_TMPDIR") || std::getenv("TMPDIR")) return;
  const std::string folder = file.has_parent_path() ? file.parent_path().string() : ".";
  sqlite3_free(sqlite3_temp_directory);
  sqlite3_temp_directory = sqlite3_mprintf("%s", folder.c_str());
}

}  // namespace

/// The wait of a connection for other processes: its limit and its beginning.
struct Database::Wait {
  fs::path file;
  double limit = 0, began = 0;  // [s]
  bool told = false;
};

int Database::waitForOthers(void* wait, int calls) {
  Wait& w = *static_cast<Wait*>(wait);
  const double now = seconds(ClockKind::wall);
  if (calls == 0) w.began = now, w.told = false;
  if (now - w.began >= w.limit) return 0;
  if (!w.told && now - w.began >= toldAfter) {
    w.told = true;
    tell("waiting for another process that holds " + w.file.string() + ", for up to " + formatDuration(w.limit), false);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(calls < 10 ? 2 : 25));
  return 1;
}

Database::Database(fs::path name, sqlite3* db) : file_(std::move(name)), db_(db) {}
Database::~Database() = default;
Database::Database(Database&&) noexcept = default;
Database& Database::operator=(Database&&) noexcept = default;

std::chrono::milliseconds Database::setPatience(std::chrono::milliseconds patience) {
  const double before = std::exchange(wait_->limit, 1e-3 * static_cast<double>(patience.count()));
  return std::chrono::milliseconds(static_cast<std::int64_t>(1e3 * before));
}

void Database::Close::operator()(sqlite3* db) const { sqlite3_close(db); }
void Statement::Finalize::operator()(sqlite3_stmt* s) const { sqlite3_finalize(s); }

Database::Database(fs::path file, Mode mode, std::chrono::milliseconds patience) : file_(std::move(file)) {
  // SQLite takes an empty name for a file of its own that it removes afterwards.
  if (file_.empty()) throw StoreError("'' is no file name; give the database a name");
  if (!isFolder(file_)) requireRegularFile(file_);  // SQLite itself says what is wrong with a folder
  if (mode == Mode::existing && !fileExists(file_))
    throw StoreError(file_.string() + ": no such file; a database of results is expected");
  // The file is opened for writing even if it is only read: after a crash the first to open the file must undo the
  // unfinished transaction. SQLite opens a write-protected file for reading by itself. A connection belongs to one
  // thread, so it needs no mutex.
  const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX | (mode == Mode::existing ? 0 : SQLITE_OPEN_CREATE);
  sqlite3* db = nullptr;
  // SQLite takes names like ":memory:" and "file:x.db" for more than files, unless a folder precedes them.
  const fs::path plain = file_.is_relative() ? "." / file_ : file_;
  const int code = sqlite3_open_v2(mode == Mode::temporary ? "" : plain.string().c_str(), &db, flags, nullptr);
  db_.reset(db);
  if (code != SQLITE_OK) fail(code, "open the database");
  if (mode != Mode::temporary) keepTemporaryDataBeside(plain);
  wait_.reset(new Wait{file_});
  setPatience(patience);
  sqlite3_busy_handler(db, waitForOthers, wait_.get());
  protect();
}

void Database::protect() {
  sqlite3* const db = db_.get();
  sqlite3_extended_result_codes(db, 1);
  // The content of a stranger's file is data: neither its triggers nor its views run, and its schema calls no function
  // that could reach beyond the file.
  sqlite3_db_config(db, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(db, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_db_config(db, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  // "name" in SQL is a column and never a text: if there is no such column the query fails.
  sqlite3_db_config(db, SQLITE_DBCONFIG_DQS_DML, 0, nullptr);
  integer("SELECT count(*) FROM sqlite_schema");  // reads the file's first page: fails unless it is a database
}

Database Database::inMemory(fs::path name, std::string_view bytes) {
  sqlite3* handle = nullptr;
  const int code =
      sqlite3_open_v2(":memory:", &handle,
                      SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_MEMORY | SQLITE_OPEN_NOMUTEX, nullptr);
  Database db(std::move(name), handle);
  if (code != SQLITE_OK) db.fail(code, "open the database");
  if (!bytes.empty()) {
    auto* copy = static_cast<unsigned char*>(sqlite3_malloc64(bytes.size()));
    if (!copy) db.fail(SQLITE_NOMEM, "open the database");
    std::memcpy(copy, bytes.data(), bytes.size());
    const auto size = static_cast<sqlite3_int64>(bytes.size());
    const int taken = sqlite3_deserialize(handle, "main", copy, size, size,
                                          SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_RESIZEABLE);
    if (taken != SQLITE_OK) db.fail(taken, "open the database");
  }
  db.protect();
  return db;
}

std::string Database::bytes() {
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> copy(sqlite3_serialize(db_.get(), "main", &size, 0),
                                                             sqlite3_free);
  if (!copy) fail(SQLITE_NOMEM, "read the database");
  return {reinterpret_cast<const char*>(copy.get()), static_cast<std::size_t>(size)};
}

void Database::fail(int code, const std::string& doing) const {
  if ((code & 0xff) == SQLITE_NOMEM) throw std::bad_alloc();  // a lack of memory is no error of the file
  std::string text = file_.string() + ": cannot " + doing + ": ";
  text += db_ ? sqlite3_errmsg(db_.get()) : sqlite3_errstr(code);
  if (const std::string help = remedy(code, db_ ? sqlite3_system_errno(db_.get()) : 0, file_); !help.empty())
    text += "; " + help;
  if ((code & 0xff) == SQLITE_BUSY) throw BusyError(text);
  throw StoreError(text);
}

void Database::execute(const std::string& sql) {
  if (const int code = sqlite3_exec(db_.get(), sql.c_str(), nullptr, nullptr, nullptr); code != SQLITE_OK)
    fail(code, "write to the database");
}

std::int64_t Database::integer(const std::string& sql) {
  Statement statement(*this, sql);
  return statement.next() ? statement.integer(0) : 0;
}

bool Database::readOnly() const { return sqlite3_db_readonly(db_.get(), "main") == 1; }

Statement::Statement(Database& db, std::string_view sql) : db_(&db) {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v2(db.db_.get(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
  statement_.reset(statement);
  if (code != SQLITE_OK) db.fail(code, "read the database");
}

bool Statement::next() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) {
    reset();
    return false;
  }
  const bool writes = !sqlite3_stmt_readonly(statement_.get());
  db_->fail(code, writes ? "write to the database" : "read the database");
}

void Statement::reset() { sqlite3_reset(statement_.get()); }  // the returned code is the last step's

void Statement::expectParameters(int count) const {
  MORULA_CHECK(sqlite3_bind_parameter_count(statement_.get()) == count, sqlite3_sql(statement_.get()));
}

bool Statement::isNull(int column) const { return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL; }

void Statement::refuse(int column, const std::string& right) const {
  const char* value = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  constexpr std::size_t most = 60;
  const std::string there = value ? printableLine(std::string_view(value).substr(0, most)) : "NULL";
  throw StoreError(db_->file().string() + ": " + sqlite3_column_name(statement_.get(), column) + ": '" + there +
                   "' is not a value that Morula writes; " + right +
                   ". The file is damaged or not Morula's; give another one");
}

std::int64_t Statement::integer(int column) const {
  if (sqlite3_column_type(statement_.get(), column) != SQLITE_INTEGER) refuse(column, "needs a whole number");
  return sqlite3_column_int64(statement_.get(), column);
}

std::uint64_t Statement::natural(int column) const {
  const auto value = integer(column);
  if (value < 0) refuse(column, "needs a whole number from 0");
  return static_cast<std::uint64_t>(value);
}

double Statement::real(int column) const {
  if (isNull(column)) return std::numeric_limits<double>::quiet_NaN();
  const int type = sqlite3_column_type(statement_.get(), column);
  if (type != SQLITE_FLOAT && type != SQLITE_INTEGER) refuse(column, "needs a number");
  return sqlite3_column_double(statement_.get(), column);
}

std::string Statement::text(int column) const {
  const int type = sqlite3_column_type(statement_.get(), column);
  if (type == SQLITE_NULL) return {};
  if (type != SQLITE_TEXT && type != SQLITE_BLOB) refuse(column, "needs a text");
  const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement_.get(), column));
  const int size = sqlite3_column_bytes(statement_.get(), column);
  if (!bytes && size > 0) db_->fail(SQLITE_NOMEM, "read the database");
  return bytes ? std::string(bytes, static_cast<std::size_t>(size)) : std::string();
}

std::string Statement::line(int column) const {
  auto value = text(column);
  if (printableLine(value) != value) refuse(column, "needs one line of plain text");
  return value;
}

double Statement::finite(int column) const {
  const double value = real(column);
  if (!std::isfinite(value)) refuse(column, "needs a finite number");
  return value;
}

int Statement::small(int column) const {
  const auto value = integer(column);
  if (value < 0 || value > 1'000'000) refuse(column, "needs a whole number from 0 to 1000000");
  return static_cast<int>(value);
}

Hash Statement::hash(int column) const {
  const auto hash = readHash(line(column));
  if (!hash) refuse(column, "needs 32 hexadecimal digits");
  return *hash;
}

CellPath Statement::path(int column) const {
  try {
    return CellPath::parse(line(column));
  } catch (const InputError& error) { refuse(column, std::string("needs a cell's path (") + error.what() + ")"); }
}

int Statement::columns() const { return sqlite3_column_count(statement_.get()); }

void Statement::addTo(Hasher& hasher, int column) const {
  switch (sqlite3_column_type(statement_.get(), column)) {
    case SQLITE_INTEGER: hasher.add("integer").add(integer(column)); return;
    case SQLITE_FLOAT: hasher.add("real").add(real(column)); return;
    case SQLITE_NULL: return;
    default: hasher.add("text").add(text(column));
  }
}

void Statement::appendRow(std::string& bytes, const std::vector<std::uint64_t>& columns) const {
  const auto append = [&](const auto& number) { bytes.append(reinterpret_cast<const char*>(&number), sizeof number); };
  sqlite3_stmt* const row = statement_.get();
  for (int c = 0; c < static_cast<int>(columns.size()); ++c) {
    const int type = sqlite3_column_type(row, c);
    if (type == SQLITE_NULL) continue;
    append(columns[static_cast<std::size_t>(c)] + static_cast<std::uint64_t>(type));
    if (type == SQLITE_INTEGER) append(sqlite3_column_int64(row, c));
    else if (type == SQLITE_FLOAT) append(sqlite3_column_double(row, c));
    else {
      const auto* text = static_cast<const char*>(sqlite3_column_blob(row, c));
      const int size = sqlite3_column_bytes(row, c);
      if (!text && size > 0) db_->fail(SQLITE_NOMEM, "read the database");
      append(static_cast<std::uint64_t>(size));
      if (size > 0) bytes.append(text, static_cast<std::size_t>(size));
    }
  }
}

void Statement::runWith(const Statement& row) {
  reset();
  const int count = row.columns();
  expectParameters(count);
  for (int i = 0; i < count; ++i)
    bound(sqlite3_bind_value(statement_.get(), i + 1, sqlite3_column_value(row.statement_.get(), i)));
  next();
  reset();
}

void Statement::bound(int code) const {
  if (code != SQLITE_OK) db_->fail(code, "write to the database");
}
void Statement::bind(int place, double value) { bound(sqlite3_bind_double(statement_.get(), place, value)); }
void Statement::bind(int place, std::int64_t value) { bound(sqlite3_bind_int64(statement_.get(), place, value)); }
void Statement::bind(int place, std::uint64_t value) { bind(place, static_cast<std::int64_t>(value)); }
void Statement::bindNull(int place) { bound(sqlite3_bind_null(statement_.get(), place)); }
void Statement::bind(int place, std::string_view value) {
  // A null pointer would bind NULL, not the empty text.
  bound(sqlite3_bind_text64(statement_.get(), place, value.data() ? value.data() : "", value.size(),
                            copyValues_ ? SQLITE_TRANSIENT : SQLITE_STATIC, SQLITE_UTF8));
}
void Statement::bind(int place, Blob value) {
  bound(sqlite3_bind_blob64(statement_.get(), place, value.bytes.data() ? value.bytes.data() : "", value.bytes.size(),
                            copyValues_ ? SQLITE_TRANSIENT : SQLITE_STATIC));
}

Transaction::Transaction(Database& db) : db_(db) {
  try {
    db_.execute("BEGIN IMMEDIATE");
  } catch (...) {
    rollBack();  // the transaction may have begun before memory ran out
    throw;
  }
}

Transaction::~Transaction() {
  if (open_) rollBack();
}

void Transaction::rollBack() {
  try {
    db_.execute("ROLLBACK");
  } catch (const std::exception&) {
    // SQLite has rolled back by itself (disk full, for instance); the error that led to this rollback is the one to
    // report.
  }
}

void Transaction::commit() {
  db_.execute("COMMIT");
  open_ = false;
}

}  // namespace morula
