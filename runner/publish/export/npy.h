#pragma once
// Arrays as NumPy reads them: .npy files in an uncompressed zip (.npz).
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace morula {

class NpzWriter {
 public:
  // Arrays of these shapes; the values fill the last axis first.
  void add(const std::string& name, const std::vector<double>& values, const std::vector<std::size_t>& shape);
  void add(const std::string& name, const std::vector<std::int64_t>& values, const std::vector<std::size_t>& shape);
  void add(const std::string& name, const std::vector<std::int32_t>& values, const std::vector<std::size_t>& shape);
  /// One axis, UTF-32 (<U…).
  void add(const std::string& name, const std::vector<std::string>& texts);

  /// Throws FileError for more than 4 GB, which such a zip cannot hold.
  std::string file() const;

 private:
  void addArray(const std::string& name, const std::string& type, const std::vector<std::size_t>& shape,
                const std::string& bytes);
  std::vector<std::pair<std::string, std::string>> files_;  // name, bytes
};

/// The checksum of zip files: CRC-32 with the polynomial 0xedb88320.
std::uint32_t crc32Of(const std::string& bytes);

}  // namespace morula
