#include "export/zip.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/error.h"
#include "files/bytes.h"

namespace morula {
namespace {

/// Returns the checksum of zip files: CRC-32 with the polynomial 0xedb88320.
std::uint32_t crc32Of(const std::string& bytes) {
  static const auto table = [] {
    std::array<std::uint32_t, 256> t{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t c = i;
      for (int bit = 0; bit < 8; ++bit) c = (c >> 1) ^ ((c & 1) != 0 ? 0xedb88320u : 0u);
      t[i] = c;
    }
    return t;
  }();
  std::uint32_t c = 0xffffffff;
  for (const char b : bytes) c = table[(c ^ static_cast<std::uint8_t>(b)) & 0xff] ^ (c >> 8);
  return ~c;
}

}  // namespace

std::string zipOf(const std::vector<std::pair<std::string, std::string>>& files, const std::string& remedy) {
  constexpr std::uint16_t version = 20,
                          day = 1 << 5 | 1;  // zip 2.0; a fixed date, so that the same run gives the same bytes
  const auto common = [&](std::string& out, const std::string& name, const std::string& bytes) {
    const bool isAscii = std::ranges::all_of(name, [](char c) { return static_cast<unsigned char>(c) < 128; });
    put16(out, version), put16(out, isAscii ? 0 : 1 << 11), put16(out, 0);  // names in UTF-8, no compression
    put16(out, 0), put16(out, day);
    put32(out, crc32Of(bytes));
    put32(out, static_cast<std::uint32_t>(bytes.size())), put32(out, static_cast<std::uint32_t>(bytes.size()));
    put16(out, static_cast<std::uint16_t>(name.size())), put16(out, 0);
  };
  std::string out, directory;
  if (files.size() > 0xffff) throw FileError("a zip holds at most 65535 files; " + remedy);
  for (const auto& [name, bytes] : files) {
    if (out.size() + bytes.size() > 4'000'000'000)
      throw FileError("more than 4 GB, which a zip cannot hold; " + remedy);
    const auto offset = static_cast<std::uint32_t>(out.size());
    put32(directory, std::uint32_t{0x02014b50});
    put16(directory, version);
    common(directory, name, bytes);
    put16(directory, 0), put16(directory, 0), put16(directory, 0);  // no comment, one disk, no kind
    put32(directory, std::uint32_t{0}), put32(directory, offset);
    directory += name;
    put32(out, std::uint32_t{0x04034b50});
    common(out, name, bytes);
    out += name + bytes;
  }
  const auto begin = static_cast<std::uint32_t>(out.size()), size = static_cast<std::uint32_t>(directory.size());
  const auto count = static_cast<std::uint16_t>(files.size());
  out += directory;
  put32(out, std::uint32_t{0x06054b50});
  put16(out, 0), put16(out, 0), put16(out, count), put16(out, count);
  put32(out, size), put32(out, begin);
  put16(out, 0);
  return out;
}

}  // namespace morula
