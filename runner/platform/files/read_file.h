#pragma once
// Reads files; all other code uses these functions. A name from a user or a scenario may be anything: a folder, a pipe
// that never answers, a device that never ends, a file of /proc that cannot be read.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace morula {

inline constexpr std::uint64_t maxInputBytes = std::uint64_t{64} << 20;  // a scenario, DNA, a mesh, a golden

/// Returns all bytes of a regular file, without waiting. Throws FileError with the path and the reason if the file does
/// not exist, is not regular, cannot be read, or holds more than `maxBytes`.
std::string readFile(const std::filesystem::path& file, std::uint64_t maxBytes = maxInputBytes);

/// Reads a file of any size, piece by piece.
void readPieces(const std::filesystem::path& file, const std::function<void(std::string_view)>& take);

/// Returns up to `count` first bytes. Throws FileError if the file is not regular or cannot be read.
std::string readBeginning(const std::filesystem::path& file, std::size_t count);

/// Returns the first `count` bytes of a file; "" if it does not exist or is not regular.
std::string readHead(const std::filesystem::path& file, std::size_t count);

/// Throws FileError if the name leads to something other than a regular file.
void requireRegularFile(const std::filesystem::path& file);

}  // namespace morula
