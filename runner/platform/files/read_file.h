#pragma once
// The one way to read a file. What a user or a scenario names may be anything: a folder, a pipe that never answers, a
// device that never ends, a file of /proc that cannot be read.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace morula {

inline constexpr std::uint64_t maxInputBytes = std::uint64_t{64} << 20;  // of a scenario, DNA, a mesh, a golden

/// All bytes of a regular file. Throws FileError with the path and the reason: it is not there, is no regular file,
/// cannot be read, or holds more than `maxBytes`. Never waits.
std::string readFile(const std::filesystem::path& file, std::uint64_t maxBytes = maxInputBytes);

/// Reads a file of any size, piece by piece.
void readPieces(const std::filesystem::path& file, const std::function<void(std::string_view)>& take);

/// The first `count` bytes, or as many as there are. Throws FileError if it is no regular file, or cannot be read.
std::string readBeginning(const std::filesystem::path& file, std::size_t count);

/// Reads the first `count` bytes of a file; "" if it is not there, or no regular file.
std::string readHead(const std::filesystem::path& file, std::size_t count);

/// Throws FileError if there is something else than a regular file.
void requireRegularFile(const std::filesystem::path& file);

}  // namespace morula
