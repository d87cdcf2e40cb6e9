// The prediction for people and for other programs.
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

template <class Text>
Cell valued(const std::optional<double>& value, const Text& textOf) {
  return value ? Cell(*value, textOf(*value)) : exact({});
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

Table costTable(const Prediction& f) {
  using Row = PartCost;
  const auto fixed = [](int digits, double scale, const char* unit) {
    return [=](double value) { return fmt::format("{:.{}f}{}", scale * value, digits, unit); };
  };
  const auto ofBodies = [&](const char* title) { return f.vertices ? title : ""; };  // only bodies have vertices
  const std::vector<FieldOf<Row>> fields{
      {{"part", "", "part"}, [](const Row& c) { return c.part.name; }},
      {{"engaged", "", ""}, [](const Row&) { return exact(true); }},
      {{"how", "", ""}, [](const Row& c) { return c.part.what; }},
      {{"why", "", ""}, [](const Row& c) { return c.part.why; }},
      {{"seconds", "", "time"}, [](const Row& c) { return valued(c.seconds, timeText); }},
      {{"share", "", "share"}, [=](const Row& c) { return valued(c.share, fixed(1, 100, " %")); }},
      {{"ns_per_vertex_step", "", ofBodies("ns/v·step")},
       [=](const Row& c) { return valued(c.nsPerVertexStep, fixed(2, 1, "")); }},
      {{"bytes_per_vertex", "", ofBodies("B/vertex")},
       [=](const Row& c) { return valued(c.bytesPerVertex, fixed(1, 1, "")); }},
      {{"bytes", "", "memory"}, [](const Row& c) { return valued(c.bytes, memoryText); }},
      {{"", "", "asked for by"},
       [](const Row& c) { return c.part.why + (c.part.what.empty() ? "" : " (" + c.part.what + ")"); }},
  };
  return tableOf("Cost of each part", fields, f.costs);
}

Table absentTable(const Prediction& f) {
  const std::vector<FieldOf<Part>> fields{
      {{"part", "", "part"}, [](const Part& part) { return part.name; }},
      {{"engaged", "", ""}, [](const Part&) { return exact(false); }},
      {{"needs", "", "needs"}, [](const Part& part) { return part.why; }},
  };
  return tableOf("Absent parts", fields, f.absent);
}

Document describe(const Prediction& f, const std::string& title) {
  std::string size =
      title + (f.life.whole ? ": up to " : ": at least ") + counted(static_cast<std::uint64_t>(f.cells), "cell");
  std::string cost =
      fmt::format("predicted on one thread: {}, {} of arrays", timeText(f.seconds()), memoryText(f.bytes()));
  if (f.vertices) {
    size += fmt::format(" of {} {}, {}", f.vertices, f.vertices == 1 ? "vertex" : "vertices",
                        counted(static_cast<std::uint64_t>(f.steps), "step"));
    cost += f.triedWhole ? "; the whole run was rehearsed"
                         : fmt::format("; rehearsed until time {:.4g} of {:.4g}", f.triedTime, f.life.eras.back().to);
  }
  PlainList lines{{cost}};
  if (f.binding)
    lines.list.push_back(fmt::format("{} bounds the time step: without it steps could be {:.1f} times as long",
                                     f.binding->part, f.binding->factor));
  Document text;
  text.say(size).add(lines).heading("cost of each part").add(costTable(f));
  text.heading("absent parts, which cost nothing").add(absentTable(f));
  for (const std::string& remark : f.remarks) text.heading(remark);
  return text;
}

}  // namespace morula
