#pragma once
// The part of a golden on the tables that a run records: of each column the number of rows and a hash over all values,
// and the rows of small tables themselves. Rows may come in any order and in parts, so a run need not keep them.
#include <map>
#include <string>
#include <vector>

#include "golden/item.h"
#include "store/records.h"

namespace morula {

struct SqlTable;

/// More rows of a table than these are not written into a golden by value.
inline constexpr std::size_t goldenRowLimit = 64;

/// A sum of hashes: it does not depend on their order.
struct HashSum {
  Hash sum;
  void add(const Hash& hash) {
    const std::uint64_t low = sum.low + hash.low;
    sum = {sum.high + hash.high + (low < hash.low ? 1 : 0), low};
  }
};

class RecordedTables {
 public:
  /// Samples, and the faces of the meshes in them.
  void addRecords(const RunResults& results);
  /// Samples, and what is known when the run has ended. `step`: its last.
  void addAll(const RunResults& results, std::uint64_t step);
  /// One row: the values of all columns but the run's id [store/row_texts.h].
  void addRow(const SqlTable& table, std::uint64_t step, const std::vector<std::optional<std::string>>& values);
  /// Lines `column` of all tables that have rows, then lines `row`.
  std::vector<GoldenItem> items() const;

 private:
  struct Table {
    std::uint64_t rows = 0;
    std::vector<HashSum> columns;  // of all but the run's id
    std::vector<GoldenRow> byValue;
  };
  void addFaces(const RunResults& results);

  std::map<std::string, std::pair<const SqlTable*, Table>> tables_;
  std::map<int, Hash> faces_;  // by mesh
};

}  // namespace morula
