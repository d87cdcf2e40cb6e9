#pragma once
// Helpers of several regression tests: quick scenes, limits of the system, and bytes that must never reach a terminal.
#include <sys/resource.h>

#include <string>

#include "launch.h"

namespace morula::test {

/// A scene of two divisions without bodies.
inline const std::string smallScene =
    "morula: 1\nname: small\ndna: |\n  START: a0\n  g1(a1|a0)\n  g2(divide|a0)\n  g3(divide|a1)\n"
    "stop: {cycles: 3}\nrecord: {every: 1}\n";

/// A scene of one cell with a body.
inline const std::string smallBody =
    "morula: 1\nname: body\ndna: |\n  START: a0\n  g1(a1|a0)\nstop: {time: 0.03125}\n"
    "physics: {time_step: 0.0078125, mesh: {icosphere: 1}}\n";

/// Limits a resource of the programs that are started meanwhile.
class Limit {
 public:
  Limit(decltype(RLIMIT_AS) of, rlim_t bytes) : of_(of) {
    getrlimit(of_, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(of_, &limit);
  }
  ~Limit() { setrlimit(of_, &before_); }

 private:
  decltype(RLIMIT_AS) of_;
  rlimit before_{};
};

/// Returns the first byte that a terminal would obey, as text; "" if there is none. Line ends and tabs are allowed.
inline std::string harmfulByte(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    const auto third = static_cast<unsigned char>(i + 2 < text.size() ? text[i + 2] : 0);
    const bool c0 = (byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7F;
    const bool c1 = byte == 0xC2 && next >= 0x80 && next <= 0x9F;
    const bool direction = byte == 0xE2 && ((next == 0x80 && third >= 0xAA && third <= 0xAE) ||
                                            (next == 0x81 && third >= 0xA6 && third <= 0xA9));
    const bool noText = byte == 0xFF || byte == 0xFE || byte == 0xC0;
    if (c0 || c1 || direction || noText) return "byte " + std::to_string(byte) + " at " + std::to_string(i);
  }
  return "";
}

}  // namespace morula::test
