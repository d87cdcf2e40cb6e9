#include "base/fields.h"

#include <bit>
#include <cmath>
#include <cstring>

#include "base/error.h"

namespace morula {
namespace {

static_assert(std::endian::native == std::endian::little, "values lie in the file as they lie in memory");

// Kinds
constexpr char number = 'u', real = 'd', single = 'f', text = 't';

template <class T>
void append(std::string& bytes, const T* values, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

void append(std::string& bytes, std::uint64_t value) { append(bytes, &value, 1); }

template <class T>
std::vector<T> asValues(std::string_view bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

}  // namespace

void FieldWriter::begin(std::string_view name, char kind, std::size_t count) {
  append(bytes_, std::uint64_t{name.size()});
  bytes_ += name;
  bytes_ += kind;
  append(bytes_, std::uint64_t{count});
}

void FieldWriter::add(std::string_view name, std::span<const std::uint64_t> values) {
  begin(name, number, values.size());
  append(bytes_, values.data(), values.size());
}

void FieldWriter::add(std::string_view name, std::span<const double> values, Precision precision) {
  for (double a : values) MORULA_CHECK(!std::isnan(a), "what is kept is a number: " + std::string(name));
  begin(name, precision == Precision::binary64 ? real : single, values.size());
  if (precision == Precision::binary64) return append(bytes_, values.data(), values.size());
  const std::vector<float> floats(values.begin(), values.end());
  append(bytes_, floats.data(), floats.size());
}

void FieldWriter::add(std::string_view name, std::span<const std::string> values) {
  begin(name, text, values.size());
  for (const std::string& value : values) {
    append(bytes_, std::uint64_t{value.size()});
    bytes_ += value;
  }
}

void FieldReader::refuse(const std::string& why) const { throw InputError(what_ + ": " + why); }

std::string_view FieldReader::take(std::size_t bytes) {
  if (bytes > rest_.size())
    refuse("the data end in the middle: " + std::to_string(bytes) + " more bytes are announced, " +
           std::to_string(rest_.size()) + " are there");
  const std::string_view taken = rest_.substr(0, bytes);
  rest_.remove_prefix(bytes);
  return taken;
}

std::uint64_t FieldReader::takeNumber() { return asValues<std::uint64_t>(take(sizeof(std::uint64_t)))[0]; }

FieldReader::Header FieldReader::open(std::string_view name, std::string_view kinds) {
  if (rest_.empty()) refuse("the field '" + std::string(name) + "' is missing");
  const std::string_view found = take(takeNumber());
  if (found != name) refuse("the field '" + std::string(name) + "' is missing where it should be");
  const char kind = take(1)[0];
  if (kinds.find(kind) == kinds.npos) refuse("the field '" + std::string(name) + "' holds values of another kind");
  const std::uint64_t count = takeNumber();
  if (count > rest_.size())  // no value is shorter than a byte
    refuse("the field '" + std::string(name) + "' announces more values than there are bytes");
  return {kind, static_cast<std::size_t>(count)};
}

std::vector<std::uint64_t> FieldReader::numbers(std::string_view name) {
  const Header header = open(name, {&number, 1});
  return asValues<std::uint64_t>(take(header.count * sizeof(std::uint64_t)));
}

std::vector<double> FieldReader::reals(std::string_view name) {
  const char kinds[] = {real, single};
  const Header header = open(name, {kinds, 2});
  std::vector<double> values;
  if (header.kind == real) {
    values = asValues<double>(take(header.count * sizeof(double)));
  } else {
    const std::vector<float> floats = asValues<float>(take(header.count * sizeof(float)));
    values.assign(floats.begin(), floats.end());
  }
  for (double a : values)
    if (std::isnan(a)) refuse("the field '" + std::string(name) + "' holds what is not a number");
  return values;
}

std::vector<std::string> FieldReader::texts(std::string_view name) {
  const Header header = open(name, {&text, 1});
  std::vector<std::string> values;
  for (std::size_t i = 0; i < header.count; ++i) values.emplace_back(take(takeNumber()));
  return values;
}

void FieldReader::end() const {
  if (!rest_.empty()) refuse(std::to_string(rest_.size()) + " bytes follow its last field");
}

}  // namespace morula
