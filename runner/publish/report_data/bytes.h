#pragma once
// Numbers as bytes, little-endian, on any machine.
#include <bit>
#include <cstdint>
#include <string>

namespace morula {

inline void putBytes(std::string& bytes, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(number >> shift);
}

inline void putBytes(std::string& bytes, float number) {
  putBytes(bytes, std::bit_cast<std::uint32_t>(number));
}

inline void putBytes(std::string& bytes, std::uint16_t number) {
  bytes += static_cast<char>(number), bytes += static_cast<char>(number >> 8);
}

/// Zeros until the length is a multiple of 4.
inline void fillBytes(std::string& bytes) {
  while (bytes.size() % 4 != 0) bytes += '\0';
}

}  // namespace morula
