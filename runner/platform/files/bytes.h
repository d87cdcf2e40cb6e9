#pragma once
// Numbers as bytes, the least significant first on every machine.
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace morula {

template <class Unsigned>
void putNumber(std::string& bytes, Unsigned value) {
  for (std::size_t i = 0; i < sizeof value; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
}
inline void put8(std::string& bytes, std::uint8_t value) { bytes += static_cast<char>(value); }
inline void put16(std::string& bytes, std::uint16_t value) { putNumber(bytes, value); }
inline void put32(std::string& bytes, std::uint32_t value) { putNumber(bytes, value); }
inline void put32(std::string& bytes, std::int32_t value) { putNumber(bytes, static_cast<std::uint32_t>(value)); }
inline void put64(std::string& bytes, std::uint64_t value) { putNumber(bytes, value); }
inline void putFloat(std::string& bytes, float value) { putNumber(bytes, std::bit_cast<std::uint32_t>(value)); }
/// Adds the nearest float.
inline void putFloat(std::string& bytes, double value) { putFloat(bytes, static_cast<float>(value)); }
inline void putDouble(std::string& bytes, double value) { putNumber(bytes, std::bit_cast<std::uint64_t>(value)); }

/// Adds zeros until the length is a multiple of 4.
inline void fillBytes(std::string& bytes) {
  while (bytes.size() % 4 != 0) bytes += '\0';
}

/// Returns the number that begins at byte `at`.
template <class Unsigned>
Unsigned numberAt(std::string_view bytes, std::size_t at) {
  Unsigned value = 0;
  for (std::size_t i = 0; i < sizeof value; ++i)
    value = static_cast<Unsigned>(value | Unsigned{static_cast<std::uint8_t>(bytes[at + i])} << (8 * i));
  return value;
}

}  // namespace morula
