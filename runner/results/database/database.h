#pragma once
// SQLite's C interface with owners: Database, Statement, Transaction. Errors are StoreErrors that name the file.
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/cell_path.h"
#include "base/hash.h"
#include "base/record.h"
#include "base/vec3.h"
#include "observation/measure_fields.h"

struct sqlite3;
struct sqlite3_stmt;

namespace morula {

class Database {
 public:
  enum class Mode { create, existing, temporary };

  /// Opens a file (Mode::create: makes it if it is not there) and checks that SQLite can read it. `patience`: max wait
  /// for other processes that hold the file, now and later; a wait over two seconds is told on stderr, a longer one is
  /// a BusyError. SQLite's own temporary data lie in the file's folder from then on. Mode::temporary: a separate
  /// database in memory (large ones on the disk) that ends with the connection; `file` only names it in messages.
  Database(std::filesystem::path file, Mode mode, std::chrono::milliseconds patience);
  ~Database();
  Database(Database&&) noexcept;
  Database& operator=(Database&&) noexcept;

  /// Returns a database in memory: an empty one, or one with the content of a database file's bytes. `name` is used
  /// only in messages. Throws StoreError if the bytes are no database.
  static Database inMemory(std::filesystem::path name, std::string_view bytes = {});
  /// Returns the database as the bytes of a file, also if it is in memory.
  std::string bytes();

  /// Runs statements that take no values and give no rows.
  void execute(const std::string& sql);
  std::int64_t integer(const std::string& sql);  // the first column of the first row
  const std::filesystem::path& file() const { return file_; }
  bool readOnly() const;
  /// Sets the max wait for other processes. Returns the previous one.
  std::chrono::milliseconds setPatience(std::chrono::milliseconds patience);

  /// Throws the StoreError for SQLite's last error. `doing`: the attempted action, "store the run".
  [[noreturn]] void fail(int code, const std::string& doing) const;

 private:
  friend class Statement;
  Database(std::filesystem::path name, sqlite3* db);
  void protect();
  struct Close {
    void operator()(sqlite3* db) const;
  };
  struct Wait;
  static int waitForOthers(void* wait, int calls);
  std::filesystem::path file_;
  std::unique_ptr<Wait> wait_;  // the connection refers to it until it is closed
  std::unique_ptr<sqlite3, Close> db_;
};

/// Bytes for a BLOB column.
struct Blob {
  std::string_view bytes;
};

/// Texts for several adjacent columns; an absent text is NULL.
struct Texts {
  std::vector<std::optional<std::string>> texts;
};

/// A prepared statement. Parameters are bound in order by `run` or `start`, columns read by number from 0.
class Statement {
 public:
  Statement(Database& db, std::string_view sql);

  /// Binds the values and runs a statement that returns no rows. The statement can then run again.
  template <class... Values>
  void run(const Values&... values) {
    bindAll(values...);
    next();
    reset();
  }

  /// Binds copies of the values and starts the statement; `next` gives its rows.
  template <class... Values>
  Statement& start(const Values&... values) {
    copyValues_ = true;
    bindAll(values...);
    return *this;
  }

  /// Binds the columns of another statement's present row, in their order, and runs.
  void runWith(const Statement& row);

  /// Goes to the next row. Returns false after the last one; the statement can then start again.
  bool next();

  // A stranger's file may hold any value in any column, whatever its tables declare. Each function throws a StoreError
  // that names the column for a value of another type or out of range.
  bool isNull(int column) const;
  std::int64_t integer(int column) const;
  std::uint64_t natural(int column) const;  // from 0
  int small(int column) const;              // from 0 to a million
  double finite(int column) const;
  /// Reads a number of 64 bits, also from 2^63 on, which `bind` stores in two's complement.
  std::uint64_t bits(int column) const { return static_cast<std::uint64_t>(integer(column)); }
  /// NULL reads as NaN: see bind(double).
  double real(int column) const;
  std::string text(int column) const;  // also reads a BLOB; NULL reads as ""
  /// Reads a text of one line, without control characters.
  std::string line(int column) const;

  /// Returns a record read from the columns from number `from` on, in the order of its fields. Throws StoreError also
  /// for a NULL that the record excludes, or for a value where it requires NULL.
  template <Record Row>
  Row row(int from = 0) const {
    Row row{};
    int column = from;
    listFields(row, [&](const FieldInfo& field, auto&& member) { read(field, column, member); });
    column = from;
    listFields(row, [&](const FieldInfo&, auto&& member) { refuseWrongNull(column, member); });
    return row;
  }

  int columns() const;
  /// Adds a column's value and type to the hash; NULL adds nothing.
  void addTo(Hasher& hasher, int column) const;
  /// For each column that is not NULL, appends the column's number, type and value. `columns`: the number of each
  /// column.
  void appendRow(std::string& bytes, const std::vector<std::uint64_t>& columns) const;

  /// Throws the StoreError for a wrong value of the column. `right`: the correct form, "needs …".
  [[noreturn]] void refuse(int column, const std::string& right) const;

  /// Returns the value with the name in this column. Throws FileError if there is none.
  template <class E>
  E choice(int column) const {
    const std::string name = line(column);
    for (const auto& row : choices<E>)
      if (row.name == name) return row.value;
    refuse(column, "needs " + namesOf<E>());
  }

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

  // Each `bindNext` binds as many parameters as the value has columns.
  template <class T>
  void bindNext(int& place, const T& value) {
    if constexpr (Record<T>) listFields(value, [&](const FieldInfo&, const auto& member) { bindNext(place, member); });
    else if constexpr (IsMeasures<T>)
      value.each([&](const auto& measure, std::size_t i) {
        const std::optional<double>& v = value.of.values[i];
        if (v && measure.isWhole) bind(++place, static_cast<std::int64_t>(*v));
        else bind(++place, v);
      });
    else if constexpr (HasChoices<T>) bind(++place, nameOf(value));
    else if constexpr (requires { value.isAbsent; }) {
      if (value.isAbsent) bindNull(++place);
      else bindNext(place, value.of);
    } else if constexpr (IsTemplate<T, AnyReal> || IsTemplate<T, AllBits>) bind(++place, value.of);
    else if constexpr (IsTemplate<T, TextOf>) bindCopy(++place, std::string_view(value.write()));
    else if constexpr (IsTemplate<T, BytesOf>) bindCopy(++place, Blob{value.write()});
    else bind(++place, value);
  }
  void bindNext(int& place, const Texts& values) {
    for (const auto& text : values.texts) bind(++place, text);
  }
  void bindNext(int& place, const Vector& v) {
    for (const double x : {v.x, v.y, v.z}) bind(++place, x);
  }
  void bindNext(int& place, const Hash& hash) { bindCopy(++place, hash.text()); }
  void bindNext(int& place, const CellPath& path) { bindCopy(++place, path.text()); }
  /// Binds a copy of a value that may end before the statement runs.
  template <class T>
  void bindCopy(int place, const T& value) {
    const bool before = std::exchange(copyValues_, true);
    bind(place, value);
    copyValues_ = before;
  }

  template <class T>
  void read(const FieldInfo& field, int& column, T&& member) const {
    using Member = std::remove_cvref_t<T>;
    if constexpr (IsMeasures<Member>)
      member.each([&](const auto& measure, std::size_t i) {
        const int c = column++;
        if (!isNull(c)) member.of.values[i] = measure.isWhole ? static_cast<double>(natural(c)) : real(c);
      });
    else if constexpr (std::same_as<Member, Vector>)
      for (double* x : {&member.x, &member.y, &member.z}) *x = finite(column++);
    else if constexpr (requires { member.isAbsent; }) {
      if (isNull(column)) ++column;
      else read(field, column, member.of);
    } else if constexpr (IsOptional<Member>) {
      if (isNull(column)) ++column;
      else if constexpr (std::same_as<Member, std::optional<double>>) member = real(column++);
      else read(field, column, member.emplace());
    } else readOne(field, column++, member);
  }

  template <class T>
  void readOne(const FieldInfo& field, int column, T&& member) const {
    using Member = std::remove_cvref_t<T>;
    if constexpr (HasChoices<Member>) member = choice<Member>(column);
    else if constexpr (IsTemplate<Member, AnyReal>) member.of = real(column);
    else if constexpr (IsTemplate<Member, AllBits>) member.of = bits(column);
    else if constexpr (IsTemplate<Member, TextOf>) member.read(textFor(field, column));
    else if constexpr (IsTemplate<Member, BytesOf>) member.read(text(column));
    else if constexpr (std::same_as<Member, bool>) member = integer(column) != 0;
    else if constexpr (std::same_as<Member, int>) member = small(column);
    else if constexpr (std::integral<Member>) member = natural(column);
    else if constexpr (std::floating_point<Member>) member = finite(column);
    else if constexpr (std::same_as<Member, Hash>) member = hash(column);
    else if constexpr (std::same_as<Member, CellPath>) member = path(column);
    else member = textFor(field, column);
  }

  template <class T>
  void refuseWrongNull(int& column, const T& member) const {
    if constexpr (requires { member.isAbsent; })
      if (isNull(column) && !member.isAbsent) refuse(column, "needs a value");
    if constexpr (IsMeasures<T>) member.each([&](const auto&, std::size_t) { ++column; });
    else column += std::same_as<T, Vector> ? 3 : 1;
  }

  std::string textFor(const FieldInfo& field, int column) const {
    return field.anyCharacters ? text(column) : line(column);
  }
  Hash hash(int column) const;
  CellPath path(int column) const;

  /// SQLite keeps every finite double and the infinities bit for bit, but −0.0 becomes 0.0 and NaN becomes NULL. So
  /// REAL columns are for reading and reckoning; exact bits are stored as a hash beside them.
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
  // True: values are copied. False: bound texts must live until the statement has run, as they do in `run`
  bool copyValues_ = false;
};

/// A transaction (BEGIN IMMEDIATE) that is rolled back at the end of the scope unless committed.
class Transaction {
 public:
  explicit Transaction(Database& db);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  void rollBack();

  Database& db_;
  bool open_ = true;
};

}  // namespace morula
