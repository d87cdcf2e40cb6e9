#pragma once
// The differences of two stored runs: their differing rows and values, table by table.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace morula {

/// One value that is not as expected. Numbers are written so that they read back with the same bits.
struct ValueDifference {
  std::string table;
  std::string row;     // its key: "time 0.25, path AB"
  std::string column;  // "" if one of the two runs lacks the row
  std::string stored, recomputed;
};

struct TableDifference {
  std::string table;
  std::uint64_t rows = 0, recomputedRows = 0;
  std::uint64_t differing = 0;           // rows that differ or that one of the runs lacks
  std::optional<ValueDifference> first;  // in the order of the table's key
  std::vector<std::string> missing{};    // columns of newer measures, which the stored table lacks
};

}  // namespace morula
