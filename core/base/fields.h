#pragma once
// Data on file as named fields, one after the other, never as raw structs. Values are read back bit for bit as they
// were written, on every machine, and a missing field is reported by its name.
//
//   name (length, bytes) · kind (one byte) · count (eight bytes) · values, little-endian
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/precision.h"

namespace morula {

class FieldWriter {
 public:
  void add(std::string_view name, std::span<const std::uint64_t> values);
  /// Adds numbers. With binary32 each number is stored as a float, which must hold it exactly.
  void add(std::string_view name, std::span<const double> values, Precision precision = Precision::binary64);
  void add(std::string_view name, std::span<const std::string> values);

  const std::string& bytes() const { return bytes_; }

 private:
  void begin(std::string_view name, char kind, std::size_t count);

  std::string bytes_;
};

/// Reads fields in the order in which they were written. Throws InputError for anything else, with the field and what
/// was expected.
class FieldReader {
 public:
  /// `what` names the whole in messages: "checkpoint".
  FieldReader(std::string_view bytes, std::string what) : rest_(bytes), what_(std::move(what)) {}

  std::vector<std::uint64_t> numbers(std::string_view name);
  /// Returns real numbers, none of which is NaN.
  std::vector<double> reals(std::string_view name);
  std::vector<std::string> texts(std::string_view name);
  /// Throws InputError if bytes are left behind the last field.
  void end() const;

 private:
  struct Header {
    char kind;
    std::size_t count;
  };
  Header open(std::string_view name, std::string_view kinds);
  std::string_view take(std::size_t bytes);
  std::uint64_t takeNumber();
  [[noreturn]] void refuse(const std::string& text) const;

  std::string_view rest_;
  std::string what_;
};

}  // namespace morula
