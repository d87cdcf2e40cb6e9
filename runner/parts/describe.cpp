// The prediction as people read it.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "parts/prediction.h"

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
  if (seconds < 2 * 3600) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 2 * 86400) return fmt::format("{:.0f} h", seconds / 3600);
  return fmt::format("{:.0f} d", seconds / 86400);
}

std::string plural(double count, const std::string& word) {
  return fmt::format("{:.0f} {}{}", count, word, count == 1 ? "" : "s");
}

/// Characters, not bytes: "µ" is one.
std::size_t lengthOf(const std::string& text) {
  return std::size_t(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width) {
  const std::size_t length = lengthOf(text);
  return text + std::string(length < width ? width - length : 1, ' ');
}

std::string right(const std::string& text, std::size_t width) {
  const std::size_t length = lengthOf(text);
  return std::string(length < width ? width - length : 0, ' ') + text;
}

std::string line(const Prediction& f, const PartCost& c) {
  const auto column = [](const std::optional<double>& value, auto&& textOf, std::size_t width) {
    return right(value ? textOf(*value) : "–", width);
  };
  const auto number = [](const char* format, double scale) {
    return [=](double value) { return fmt::format(fmt::runtime(format), scale * value); };
  };
  std::string text = "  " + padded(c.part.name, 13) + column(c.seconds, timeText, 9);
  text += column(c.share, number("{:.1f} %", 100), 9);
  if (f.vertices)
    text += column(c.nsPerVertexStep, number("{:.2f}", 1), 11) +
            column(c.bytesPerVertex, number("{:.1f}", 1), 10);
  text += column(c.bytes, memoryText, 11);
  return text + "  " + c.part.why + (c.part.what.empty() ? "" : " (" + c.part.what + ")") + "\n";
}

}  // namespace

std::string describe(const Prediction& f, const std::string& title) {
  std::string text = title + (f.life.whole ? ": up to " : ": at least ") + plural(double(f.cells), "cell");
  if (f.vertices)
    text += fmt::format(" of {} {}, {}", f.vertices, f.vertices == 1 ? "vertex" : "vertices",
                        plural(f.steps, "step"));
  text += fmt::format("\n  foreseen on one thread: {}, {} of arrays", timeText(f.seconds()),
                      memoryText(f.bytes()));
  if (f.vertices)
    text += f.triedWhole
                ? "; the whole run was rehearsed"
                : fmt::format("; rehearsed until time {:.4g} of {:.4g}", f.triedTime, f.life.eras.back().to);
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
