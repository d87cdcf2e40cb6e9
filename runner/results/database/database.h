#pragma once
// SQLite's C interface with owners: Database, Statement, Transaction. Errors are StoreErrors that name the file.
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace morula {

class Hasher;

class Database {
 public:
  enum class Mode { create, existing, temporary };

  /// Opens a file (Mode::create: makes it if it is not there) and checks that SQLite can read it. Waits
  /// `patience` for other writers, now and later. Mode::temporary: a database of its own, in memory and on
  /// the disk where it is large, which is gone with the connection; `file` only names it in messages.
  Database(std::filesystem::path file, Mode mode, std::chrono::milliseconds patience);

  /// A database in memory: an empty one, or with all that the bytes of a database's file hold. `name` only names it in
  /// messages. Throws StoreError if the bytes are no database.
  static Database inMemory(std::filesystem::path name, std::string_view bytes = {});
  /// The bytes of its file, also of one that is none.
  std::string bytes();

  /// Runs statements that take no values and give no rows.
  void execute(const std::string& sql);
  std::int64_t integer(const std::string& sql);  // the first column of the first row
  const std::filesystem::path& file() const { return file_; }
  bool readOnly() const;

  /// Throws the StoreError for what SQLite last reported. `doing`: "store the run".
  [[noreturn]] void fail(int code, const std::string& doing) const;

 private:
  friend class Statement;
  Database(std::filesystem::path name, sqlite3* db) : file_(std::move(name)), db_(db) {}
  void protect();
  struct Close {
    void operator()(sqlite3* db) const;
  };
  std::filesystem::path file_;
  std::unique_ptr<sqlite3, Close> db_;
};

/// Bytes for a BLOB column.
struct Blob {
  std::string_view bytes;
};

/// Numbers for several columns in a row; NULL where there is none, whole ones as integers.
struct BoundNumbers {
  struct Number {
    std::optional<double> value;
    bool isWhole = false;
  };
  std::vector<Number> numbers;
};

/// Texts for several columns in a row; NULL where there is none.
struct Texts {
  std::vector<std::optional<std::string>> texts;
};

/// A prepared statement. Parameters are bound in order by `run` or `start`, columns read by number from 0.
class Statement {
 public:
  Statement(Database& db, std::string_view sql);

  /// Binds the values and runs a statement that gives no rows; ready to run again.
  template <class... Values>
  void run(const Values&... values) {
    bindAll(values...);
    next();
    reset();
  }

  /// Binds copies of the values; the rows follow with `next`.
  template <class... Values>
  Statement& start(const Values&... values) {
    copyValues_ = true;
    bindAll(values...);
    return *this;
  }

  /// Binds the columns of another statement's row, in their order, and runs.
  void runWith(const Statement& row);

  /// Goes to the next row; false after the last one, and then ready to start again.
  bool next();

  // A file of a stranger may hold anything anywhere, whatever its tables promise: a value of another type or out
  // of range is a StoreError that names the column.
  bool isNull(int column) const;
  std::int64_t integer(int column) const;
  std::uint64_t natural(int column) const;  // from 0
  /// As `bind` writes numbers from 2^63 on.
  std::uint64_t bits(int column) const { return static_cast<std::uint64_t>(integer(column)); }
  /// NULL reads as NaN: see bind(double).
  double real(int column) const;
  std::string text(int column) const;  // or a BLOB; NULL reads as ""
  /// A text of one line, without control characters.
  std::string line(int column) const;

  int columns() const;
  /// Adds a value with its type; nothing for NULL.
  void addTo(Hasher& hasher, int column) const;

  /// Throws the StoreError for a value that cannot be right. `right`: "needs …".
  [[noreturn]] void refuse(int column, const std::string& right) const;

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* s) const;
  };

  template <class... Values>
  void bindAll(const Values&... values) {
    reset();
    int place = 0;
    (bindNext(place, values), ...);
    expectParameters(place);
  }

  template <class T>
  void bindNext(int& place, const T& value) {
    bind(++place, value);
  }
  void bindNext(int& place, const BoundNumbers& values) {
    for (const auto& [value, isWhole] : values.numbers) {
      if (value && isWhole) bind(++place, static_cast<std::int64_t>(*value));
      else bind(++place, value);
    }
  }

  void bindNext(int& place, const Texts& values) {
    for (const auto& text : values.texts) bind(++place, text);
  }

  /// SQLite keeps every finite double and the infinities bit for bit, but −0.0 becomes 0.0 and NaN becomes
  /// NULL. So REAL columns are for reading and reckoning; what must be exact to the last bit is stored as a
  /// hash beside them.
  void bind(int place, double value);
  void bind(int place, std::int64_t value);
  void bind(int place, std::uint64_t value);  // two's complement: SQLite's integers are signed
  void bind(int place, int value) { bind(place, std::int64_t{value}); }
  void bind(int place, bool value) { bind(place, std::int64_t{value}); }
  void bind(int place, std::string_view value);
  void bind(int place, const std::string& value) { bind(place, std::string_view(value)); }
  void bind(int place, const char* value) { bind(place, std::string_view(value)); }
  void bind(int place, Blob value);
  void bindNull(int place);
  template <class T>
  void bind(int place, const std::optional<T>& value) {
    if (value) bind(place, *value);
    else bindNull(place);
  }
  void reset();
  void bound(int code) const;
  void expectParameters(int count) const;

  Database* db_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  // Otherwise the bound texts must live until the statement has run, as they do in `run`
  bool copyValues_ = false;
};

/// BEGIN IMMEDIATE; rolled back at the end of the scope unless committed.
class Transaction {
 public:
  explicit Transaction(Database& db);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& db_;
  bool open_ = true;
};

}  // namespace morula
