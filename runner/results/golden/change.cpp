#include "golden/change.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "golden/number_text.h"

namespace morula {

namespace {

constexpr const char* absent = "not given";
constexpr std::size_t mostLines = 9;  // lines of one kind

std::string line(const std::string& heading, const std::string& text) {
  return "  " + heading + std::string(heading.size() < 10 ? 10 - heading.size() : 1, ' ') + text + '\n';
}

std::string lines(const std::string& heading, const std::vector<std::string>& texts,
                  const std::string& what) {
  std::string all;
  for (std::size_t i = 0; i < std::min(mostLines, texts.size()); ++i) all += line(i ? "" : heading, texts[i]);
  if (texts.size() > mostLines)
    all += line("", "and " + std::to_string(texts.size() - mostLines) + " more " + what);
  return all;
}

std::string keysInWords(const GoldenData& before, const GoldenData& after) {
  const auto changes = changedKeys(before, after);
  std::vector<std::string> texts;
  for (const KeyChange& c : changes) texts.push_back(c.key + ": " + c.before + " → " + c.after);
  if (texts.empty() && before.scenarioHash != after.scenarioHash)
    texts.push_back(before.parameters.empty()
                        ? "not known: the golden was accepted before goldens recorded what decides the result"
                        : "none: the same values have another meaning to this program, or make another mesh");
  return lines("changed", texts, "keys");
}

/// The lines `cell` and `generation`, by key.
using Items = std::map<std::string, const GoldenItem*>;

Items itemsOf(const GoldenData& data, const std::string& kind) {
  Items items;
  for (const GoldenItem& item : data.items)
    if (item.kind == kind) items.emplace(item.key, &item);
  return items;
}

// Fields of a line `cell`.
enum CellField { born, bornStep, ended, endedStep, fate, state };

std::string cellName(const std::string& key) { return key == "egg" ? "the egg" : "cell " + key; }

std::string lifeOf(const GoldenItem& cell) {
  return cell.fields[ended] == "-" ? "alive at the end"
                                   : cell.fields[fate] + " at time " + cell.fields[ended];
}

std::string cellChange(const GoldenItem* a, const GoldenItem* b) {
  const std::string who = cellName((a ? a : b)->key) + ": ";
  if (!b) return who + "born at time " + a->fields[born] + " → never born";
  if (!a) return who + "never born → born at time " + b->fields[born];
  if (a->fields[born] != b->fields[born])
    return who + "born at time " + a->fields[born] + " → " + b->fields[born];
  if (lifeOf(*a) != lifeOf(*b)) return who + lifeOf(*a) + " → " + lifeOf(*b);
  if (a->fields[state] != b->fields[state])
    return who + "substances '" + a->fields[state] + "' → '" + b->fields[state] + "'";
  return who + "the same times in other steps";
}

struct Event {
  double time = 0;        // the earlier of the two
  std::size_t depth = 0;  // of the cell: a mother comes before her daughters
  std::string text;
};

std::vector<std::string> lineageChanges(const GoldenData& before, const GoldenData& after) {
  const Items a = itemsOf(before, "cell"), b = itemsOf(after, "cell");
  std::vector<Event> events;
  const auto note = [&](const GoldenItem* x, const GoldenItem* y) {
    const auto when = [](const GoldenItem* cell) {
      if (!cell) return HUGE_VAL;
      return readReal(cell->fields[cell->fields[ended] == "-" ? born : ended]).value_or(HUGE_VAL);
    };
    const std::string& path = (x ? x : y)->key;
    events.push_back({std::min(when(x), when(y)), path == "egg" ? 0 : path.size(), cellChange(x, y)});
  };
  for (const auto& [key, item] : a) {
    const auto found = b.find(key);
    if (found == b.end()) note(item, nullptr);
    else if (found->second->fields != item->fields) note(item, found->second);
  }
  for (const auto& [key, item] : b)
    if (!a.contains(key)) note(nullptr, item);
  std::stable_sort(events.begin(), events.end(), [](const Event& x, const Event& y) {
    return x.time != y.time ? x.time < y.time : x.depth < y.depth;
  });
  std::vector<std::string> texts;
  for (Event& e : events) texts.push_back(std::move(e.text));

  const Items g = itemsOf(before, "generation"), h = itemsOf(after, "generation");
  for (const auto& [key, item] : g) {
    const auto found = h.find(key);
    if (found == h.end() || found->second->fields == item->fields) continue;
    const std::string was = item->fields[0], is = found->second->fields[0];
    texts.push_back("generation " + key + ": " +
                    (was == is ? "other lives of " + was + " cells" : was + " → " + is + " cells"));
  }
  return texts;
}

/// "final/AB/x" → its number.
using Values = std::map<std::string, double>;

Values endOf(const GoldenData& data) {
  Values values;
  for (const GoldenItem& item : data.items)
    if (item.kind == "value" && item.key.starts_with("final/"))
      if (const auto v = readReal(item.fields[1])) values[item.key] = *v;
  return values;
}

/// [length] Of the egg; of a ball with the organism's volume where the result does not say.
double radiusOf(const GoldenData& data, const Values& end) {
  for (const auto& [key, value] : data.parameters)
    if (key == "physics.cell.radius")
      if (const auto radius = readReal(value); radius && *radius > 0) return *radius;
  const auto volume = end.find("final/organism/volume");
  return volume == end.end() ? 0 : std::cbrt(3 * volume->second / (4 * M_PI));
}

/// Three digits are enough to weigh a difference.
std::string brief(double value) {
  if (value >= 1000 && value < 1e15) return std::to_string(std::llround(value));
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 3).ptr};
}

struct Largest {
  double size = 0;
  std::string who;
  void see(double value, const std::string& cell) {
    if (!(value <= size)) size = value, who = cell;  // not a number is the largest of all
  }
};

/// "+2.3 % in the mean, " where the organism's value of this name has changed; "" where it has not, or was 0.
std::string meanChange(const Values& a, const Values& b, const std::string& name, const char* of) {
  const auto was = a.find("final/organism/" + name), is = b.find("final/organism/" + name);
  if (was == a.end() || is == b.end() || was->second == 0 || was->second == is->second) return {};
  const double percent = 100 * (is->second - was->second) / std::abs(was->second);
  return (percent < 0 ? "−" : "+") + brief(std::abs(percent)) + " % " + of + ", ";
}

std::string movementInWords(const GoldenData& before, const GoldenData& after) {
  const Values a = endOf(before), b = endOf(after);
  const double radius = radiusOf(before.parameters.empty() ? after : before, a);
  Largest moved, volume, pressure;
  for (const auto& [key, was] : a) {
    const std::size_t slash = key.rfind('/');
    const std::string cell = key.substr(6, slash - 6), what = key.substr(slash + 1);
    const auto is = b.find(key);
    if (is == b.end() || cell == "organism") continue;
    const auto change = [before = was, after = is->second] {
      return before == after ? 0 : 100 * std::abs(after - before) / std::abs(before);
    };
    if (what == "volume") volume.see(change(), cell);
    if (what == "pressure") pressure.see(change(), cell);
    if (what != "x") continue;
    double squares = 0;
    for (const char* axis : {"x", "y", "z"}) {
      const std::string at = "final/" + cell + '/' + axis;
      const auto p = a.find(at), q = b.find(at);
      if (p != a.end() && q != b.end()) squares += (q->second - p->second) * (q->second - p->second);
    }
    moved.see(std::sqrt(squares), cell);
  }
  std::string text;
  if (moved.size != 0 && radius > 0)
    text += line("moved",
                 cellName(moved.who) + " the farthest: " + brief(moved.size / radius) + " radii of the egg");
  if (volume.size != 0)
    text += line("volume", meanChange(a, b, "volume", "in all") + cellName(volume.who) +
                               " the most: " + brief(volume.size) + " %");
  if (pressure.size != 0)
    text += line("pressure", meanChange(a, b, "mean_pressure", "in the mean") + cellName(pressure.who) +
                                 " the most: " + brief(pressure.size) + " %");
  return text;
}

}  // namespace

std::vector<KeyChange> changedKeys(const GoldenData& before, const GoldenData& after) {
  std::vector<KeyChange> changes;
  if (before.parameters.empty() || after.parameters.empty()) return changes;
  const std::map<std::string, std::string> was(before.parameters.begin(), before.parameters.end()),
      is(after.parameters.begin(), after.parameters.end());
  for (const auto& [key, value] : before.parameters) {
    const auto now = is.find(key);
    if (now == is.end()) changes.push_back({key, value, absent});
    else if (now->second != value) changes.push_back({key, value, now->second});
  }
  for (const auto& [key, value] : after.parameters)
    if (!was.contains(key)) changes.push_back({key, absent, value});
  return changes;
}

std::string changeInWords(const GoldenData& before, const GoldenData& after) {
  const std::string keys = keysInWords(before, after), movement = movementInWords(before, after);
  const auto lineage = lineageChanges(before, after);
  if (keys.empty() && movement.empty() && lineage.empty()) return {};
  return keys + (lineage.empty() ? line("lineage", "the same") : lines("lineage", lineage, "cells")) +
         movement;
}

}  // namespace morula
