// The prediction as people read it.
#include <fmt/format.h>

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

std::string plural(double count, const std::string& word) {
  return fmt::format("{:.0f} {}{}", count, word, count == 1 ? "" : "s");
}

/// A column's value, or "–" where there is none.
template <class Text>
std::string column(const std::optional<double>& value, const Text& textOf) {
  return value ? textOf(*value) : "–";
}

std::string line(const Prediction& f, const PartCost& c) {
  const auto fixed = [](int digits, double scale, const char* unit) {
    return [=](double value) { return fmt::format("{:.{}f}{}", scale * value, digits, unit); };
  };
  std::string text = fmt::format("  {:<12} {:>9}{:>9}", c.part.name, column(c.seconds, timeText),
                                 column(c.share, fixed(1, 100, " %")));
  if (f.vertices)
    text += fmt::format("{:>11}{:>10}", column(c.nsPerVertexStep, fixed(2, 1, "")),
                        column(c.bytesPerVertex, fixed(1, 1, "")));
  text += fmt::format("{:>11}  {}", column(c.bytes, memoryText), c.part.why);
  return text + (c.part.what.empty() ? "" : " (" + c.part.what + ")") + "\n";
}

}  // namespace

std::string timeText(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.0f} µs", 1e6 * seconds);
  if (seconds < 1) return fmt::format("{:.0f} ms", 1e3 * seconds);
  if (seconds < 600) return fmt::format("{:.1f} s", seconds);
  if (seconds < 2 * 3600) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 2 * 86400) return fmt::format("{:.0f} h", seconds / 3600);
  return fmt::format("{:.0f} d", seconds / 86400);
}

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
  text += fmt::format("\n\n  {:<12} {:>9}{:>9}", "part", "time", "share");
  if (f.vertices) text += fmt::format("{:>11}{:>10}", "ns/v·step", "B/vertex");
  text += fmt::format("{:>11}  asked for by\n", "memory");
  for (const PartCost& c : f.costs) text += line(f, c);
  text += "\n  absent, and free:\n";
  for (const Part& part : f.absent) text += fmt::format("  {:<12} needs {}\n", part.name, part.why);
  for (const std::string& remark : f.remarks) text += "\n  " + remark + "\n";
  return text;
}

}  // namespace morula
