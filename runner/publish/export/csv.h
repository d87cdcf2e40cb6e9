#pragma once
// Tables as comma-separated values, by RFC 4180: UTF-8, lines end in CR LF, a header line, quotes where a text needs them.
// What is not there (NULL, not a number) is an empty field; an empty text is "". Numbers are the shortest that read back as
// the same.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "store/table_rows.h"

namespace morula {

class CsvTable {
 public:
  explicit CsvTable(const std::vector<std::string>& columns);

  CsvTable& add(std::string_view text);
  CsvTable& add(std::int64_t number);
  CsvTable& add(std::optional<double> number);
  CsvTable& add(const TableValue& value);
  /// The next row begins.
  void endRow();

  const std::string& text() const { return text_; }

 private:
  void separate();
  std::string text_;
  bool isFirst_ = true;  // in its row
};

}  // namespace morula
