#pragma once
// A golden's lines on recorded tables: for each column the number of rows and a hash over all values, and the rows of
// small tables. Rows may come in any order and in parts, so a run need not keep them.
#include <map>
#include <string>
#include <vector>

#include "golden/item.h"
#include "store/records.h"

namespace morula {

struct SqlTable;

/// Max number of rows of a table that a golden holds by value.
inline constexpr std::size_t goldenRowLimit = 64;

/// A sum of hashes, which does not depend on their order.
struct HashSum {
  Hash sum;
  void add(const Hash& hash) {
    const std::uint64_t low = sum.low + hash.low;
    sum = {sum.high + hash.high + (low < hash.low ? 1 : 0), low};
  }
};

class RecordedTables {
 public:
  /// Adds samples, and the faces of the meshes in them.
  void addRecords(const RunResults& results);
  /// Adds samples, and the results that are known when the run has ended. `step`: the last step.
  void addAll(const RunResults& results, std::uint64_t step);
  /// Adds a row: the values of all columns but the run's id [store/row_texts.h].
  void addRow(const SqlTable& table, std::uint64_t step, const std::vector<std::optional<std::string>>& values);
  /// Returns lines `column` of all tables that have rows, then lines `row`.
  std::vector<GoldenItem> items() const;

 private:
  struct Table {
    std::uint64_t rows = 0;
    std::vector<HashSum> columns;  // hashes of all columns but the run's id
    std::vector<GoldenRow> byValue;
  };
  void addFaces(const RunResults& results);

  std::map<std::string, std::pair<const SqlTable*, Table>> tables_;
  std::map<int, Hash> faces_;  // hashes of faces, by mesh
};

}  // namespace morula
