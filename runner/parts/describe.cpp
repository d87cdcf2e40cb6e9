// The forecast as people read it.
#include <fmt/format.h>

#include <algorithm>

#include "parts/forecast.h"

namespace morula {

namespace {

std::string memoryText(double bytes) {
  if (bytes < 1024) return fmt::format("{:.0f} B", bytes);
  if (bytes < 1024 * 1024) return fmt::format("{:.1f} KiB", bytes / 1024);
  if (bytes < 1024.0 * 1024 * 1024) return fmt::format("{:.1f} MiB", bytes / (1024 * 1024));
  return fmt::format("{:.1f} GiB", bytes / (1024.0 * 1024 * 1024));
}

std::string timeText(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.0f} µs", 1e6 * seconds);
  if (seconds < 1) return fmt::format("{:.0f} ms", 1e3 * seconds);
  if (seconds < 600) return fmt::format("{:.1f} s", seconds);
  return fmt::format("{:.0f} min", seconds / 60);
}

std::string plural(double count, const std::string& word) {
  return fmt::format("{:.0f} {}{}", count, word, count == 1 ? "" : "s");
}

/// Left-aligned; counts characters, not bytes: "µ" is one.
std::string padded(const std::string& text, std::size_t width) {
  const auto length =
      std::size_t(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
  return text + std::string(length < width ? width - length : 1, ' ');
}

std::string right(const std::string& text, std::size_t width) {
  const auto length =
      std::size_t(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
  return std::string(length < width ? width - length : 0, ' ') + text;
}

std::string line(const Forecast& f, const PartCost& c) {
  const auto or_ = [](const auto& value, auto&& text) { return value ? text(*value) : std::string("–"); };
  const double vertices = f.vertices ? double(f.vertices) * double(f.cells) : 0;
  std::string text = "  " + padded(c.part.name, 13);
  text += right(or_(c.seconds, timeText), 9);
  text +=
      right(c.afterwards || !c.seconds ? "–" : fmt::format("{:.1f} %", 100 * *c.seconds / f.seconds()), 9);
  if (f.vertices) {
    text +=
        right(c.afterwards || !c.seconds ? "–" : fmt::format("{:.2f}", 1e9 * *c.seconds / f.vertexSteps), 11);
    text += right(c.bytes ? fmt::format("{:.1f}", *c.bytes / vertices) : "–", 10);
  }
  text += right(or_(c.bytes, memoryText), 11);
  return text + "  " + c.part.why + (c.part.what.empty() ? "" : " (" + c.part.what + ")") + "\n";
}

}  // namespace

std::string describe(const Forecast& f, const std::string& title) {
  std::string text = title + ": up to " + plural(double(f.cells), "cell");
  if (f.vertices) text += fmt::format(" of {} vertices, {}", f.vertices, plural(f.steps, "step"));
  text += fmt::format("\n  foreseen on one thread: {}, {} of arrays", timeText(f.seconds()),
                      memoryText(f.bytes()));
  if (f.vertices)
    text += f.rehearsed ? "; the whole run was rehearsed"
                        : fmt::format("; rehearsed until time {:.4g} of {:.4g}", f.rehearsedTime,
                                      f.life.eras.back().to);
  text += "\n\n  " + padded("part", 13) + right("time", 9) + right("share", 9);
  if (f.vertices) text += right("ns/v·step", 11) + right("B/vertex", 10);
  text += right("memory", 11) + "  asked for by\n";
  for (const PartCost& c : f.costs) text += line(f, c);
  text += "\n  absent, and free:\n";
  for (const Part& part : f.absent) text += "  " + padded(part.name, 13) + "needs " + part.why + "\n";
  for (const std::string& remark : f.remarks) text += "\n  " + remark + "\n";
  return text;
}

}  // namespace morula
