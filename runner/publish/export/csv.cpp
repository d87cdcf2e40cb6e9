#include "export/csv.h"

#include <cmath>

#include "base/number_text.h"
#include "files/quote.h"

namespace morula {

CsvTable::CsvTable(const std::vector<std::string>& columns) {
  for (const std::string& c : columns) add(std::string_view(c));
  endRow();
}

void CsvTable::separate() {
  if (!isFirst_) text_ += ',';
  isFirst_ = false;
}

CsvTable& CsvTable::add(std::string_view text) {
  separate();
  text_ += csvField(text);
  return *this;
}

CsvTable& CsvTable::add(std::int64_t number) {
  separate();
  text_ += std::to_string(number);
  return *this;
}

CsvTable& CsvTable::add(std::optional<double> number) {
  separate();
  if (number && !std::isnan(*number)) text_ += exactText(*number);
  return *this;
}

CsvTable& CsvTable::add(const TableValue& value) {
  if (const auto* number = std::get_if<std::int64_t>(&value)) return add(*number);
  if (const auto* real = std::get_if<double>(&value)) return add(std::optional(*real));
  if (const auto* text = std::get_if<std::string>(&value)) return add(std::string_view(*text));
  return add(std::optional<double>());
}

void CsvTable::endRow() {
  text_ += "\r\n";
  isFirst_ = true;
}

}  // namespace morula
