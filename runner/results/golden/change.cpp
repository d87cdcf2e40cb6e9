#include "golden/change.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "files/text.h"
#include "golden/read_number.h"
#include "golden/toleranced_numbers.h"

namespace morula {
namespace {

constexpr const char* absent = "not given";
constexpr std::size_t maxLines = 9;  // max number of lines of one kind

std::string line(const std::string& heading, const std::string& text) {
  return "  " + heading + std::string(heading.size() < 10 ? 10 - heading.size() : 1, ' ') + text + '\n';
}

std::string lines(const std::string& heading, const std::vector<std::string>& texts, const std::string& what) {
  std::string all;
  for (std::size_t i = 0; i < std::min(maxLines, texts.size()); ++i) all += line(i ? "" : heading, texts[i]);
  if (texts.size() > maxLines) all += line("", "and " + std::to_string(texts.size() - maxLines) + " more " + what);
  return all;
}

std::string keysInWords(const GoldenData& before, const GoldenData& after) {
  const auto changes = changedKeys(before, after);
  std::vector<std::string> texts;
  for (const KeyChange& c : changes) texts.push_back(c.key + ": " + c.before + " → " + c.after);
  if (texts.empty() && before.scenarioHash != after.scenarioHash)
    texts.push_back(before.parameters.empty()
                        ? "not known: the golden is older than the record of parameters in goldens"
                        : "none: this program interprets the same values differently, or makes another mesh of them");
  return lines("changed", texts, "keys");
}

/// Returns the items of one kind by the value of their member `key`.
template <class Item, class Key>
std::map<Key, const Item*> byKey(const GoldenData& data, Key Item::*key) {
  std::map<Key, const Item*> items;
  for (const Item* item : all<Item>(data)) items.emplace(item->*key, item);
  return items;
}

std::string nameOf(const CellPath& cell) { return cellName(cell.text()); }

std::string lifeOf(const GoldenCell& cell) {
  return cell.ended ? std::string(name(cell.fate)) + " at time " + exactText(*cell.ended) : "alive at the end";
}

std::string cellChange(const GoldenCell* a, const GoldenCell* b) {
  const std::string who = nameOf((a ? a : b)->path) + ": ";
  const auto birth = [](const GoldenCell& cell) { return "born at time " + exactText(cell.born); };
  if (!b) return who + birth(*a) + " → never born";
  if (!a) return who + "never born → " + birth(*b);
  if (a->born != b->born) return who + birth(*a) + " → " + exactText(b->born);
  if (lifeOf(*a) != lifeOf(*b)) return who + lifeOf(*a) + " → " + lifeOf(*b);
  if (a->state != b->state) return who + "substances '" + a->state.text + "' → '" + b->state.text + "'";
  return who + "the same times at other steps";
}

struct Event {
  double time = 0;  // [time] the earlier of the two results' times
  int depth = 0;    // generation of the cell: a mother comes before her daughters
  std::string text;
};

std::vector<std::string> lineageChanges(const GoldenData& before, const GoldenData& after) {
  const auto a = byKey(before, &GoldenCell::path), b = byKey(after, &GoldenCell::path);
  std::vector<Event> events;
  const auto note = [&](const GoldenCell* x, const GoldenCell* y) {
    const auto when = [](const GoldenCell* cell) { return cell ? cell->ended.value_or(cell->born) : HUGE_VAL; };
    events.push_back({std::min(when(x), when(y)), (x ? x : y)->path.depth(), cellChange(x, y)});
  };
  for (const auto& [path, cell] : a) {
    const auto found = b.find(path);
    if (found == b.end()) note(cell, nullptr);
    else if (!agree(GoldenItem(*found->second), GoldenItem(*cell))) note(cell, found->second);
  }
  for (const auto& [path, cell] : b)
    if (!a.contains(path)) note(nullptr, cell);
  std::stable_sort(events.begin(), events.end(), [](const Event& x, const Event& y) {
    return x.time != y.time ? x.time < y.time : x.depth < y.depth;
  });
  std::vector<std::string> texts;
  for (Event& e : events) texts.push_back(std::move(e.text));

  const auto h = byKey(after, &GoldenGeneration::number);
  for (const auto* was : all<GoldenGeneration>(before)) {
    const auto is = h.find(was->number);
    if (is == h.end() || agree(GoldenItem(*is->second), GoldenItem(*was))) continue;
    const std::string cells = std::to_string(was->cells), now = std::to_string(is->second->cells);
    texts.push_back("generation " + std::to_string(was->number) + ": " +
                    (cells == now ? "different lives of " + cells + " cells" : cells + " → " + now + " cells"));
  }
  return texts;
}

using Values = std::map<ValueName, double>;

Values endOf(const GoldenData& data) {
  Values values;
  for (const auto* value : all<GoldenValue>(data))
    if (!value->name.time && value->value) values[value->name] = *value->value;
  return values;
}

/// Returns the measure of the cell, or of the organism if `cell` is absent.
std::optional<double> valueIn(const Values& values, const std::optional<CellPath>& cell, const char* measure) {
  const auto found = values.find({{}, cell, measure});
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

/// Returns the radius of the egg [length]; that of a ball with the organism's volume if the result does not record it.
double radiusOf(const GoldenData& data, const Values& end) {
  for (const auto& [key, value] : data.parameters)
    if (key == "physics.cell.radius")
      if (const auto radius = readReal(value); radius && *radius > 0) return *radius;
  return std::cbrt(3 * valueIn(end, {}, "volume").value_or(0) / (4 * M_PI));
}

/// Writes a number in three digits, which are enough to weigh a difference.
std::string brief(double value) {
  return value >= 1000 && value < 1e15 ? std::to_string(std::llround(value)) : numberText(value, 3);
}

struct Largest {
  double size = 0;
  CellPath who;
  void see(double value, const CellPath& cell) {
    if (!(value <= size)) size = value, who = cell;  // NaN counts as the largest
  }
};

/// Returns "+2.3 % in the mean, " if the organism's value of this name has changed; "" if it has not, or was 0.
std::string meanChange(const Values& a, const Values& b, const char* measure, const char* of) {
  const auto was = valueIn(a, {}, measure), is = valueIn(b, {}, measure);
  if (!was || !is || *was == 0 || *was == *is) return {};
  const double percent = 100 * (*is - *was) / std::abs(*was);
  return (percent < 0 ? "−" : "+") + brief(std::abs(percent)) + " % " + of + ", ";
}

std::string movementInWords(const GoldenData& before, const GoldenData& after) {
  const Values a = endOf(before), b = endOf(after);
  const double radius = radiusOf(before.parameters.empty() ? after : before, a);
  Largest moved, volume, pressure;
  for (const auto& [name, was] : a) {
    const auto is = valueIn(b, name.cell, name.measure.c_str());
    if (!is || !name.cell) continue;
    const double change = was == *is ? 0 : 100 * std::abs(*is - was) / std::abs(was);
    if (name.measure == "volume") volume.see(change, *name.cell);
    if (name.measure == "pressure") pressure.see(change, *name.cell);
    if (name.measure != "x") continue;
    double squares = 0;
    for (const char* axis : {"x", "y", "z"}) {
      const auto p = valueIn(a, name.cell, axis), q = valueIn(b, name.cell, axis);
      if (p && q) squares += (*q - *p) * (*q - *p);
    }
    moved.see(std::sqrt(squares), *name.cell);
  }
  std::string text;
  if (moved.size != 0 && radius > 0)
    text += line("moved", nameOf(moved.who) + " the farthest: " + brief(moved.size / radius) + " radii of the egg");
  if (volume.size != 0)
    text += line("volume",
                 meanChange(a, b, "volume", "in all") + nameOf(volume.who) + " the most: " + brief(volume.size) + " %");
  if (pressure.size != 0)
    text += line("pressure", meanChange(a, b, "mean_pressure", "in the mean") + nameOf(pressure.who) +
                                 " the most: " + brief(pressure.size) + " %");
  return text;
}

/// Returns "contact: area, contact_duration of 12 rows", for each recorded table that differs.
std::vector<std::string> recordChanges(const GoldenData& before, const GoldenData& after) {
  const auto a = byKey(before, &GoldenColumn::name), b = byKey(after, &GoldenColumn::name);
  std::map<std::string, std::string> tables;
  if (a.empty() || b.empty()) return {};
  for (const auto& [name, was] : a) {
    const auto is = b.find(name);
    if (is != b.end() && agree(GoldenItem(*was), GoldenItem(*is->second))) continue;
    const std::string table = tableOf(name), rows = std::to_string(was->rows);
    const std::string now = is == b.end() ? "0" : std::to_string(is->second->rows);
    std::string& text = tables[table];
    if (now != rows) text = rows + " → " + now + " rows";
    else text += (text.empty() ? "different values in " : ", ") + name.substr(table.size() + 1);
  }
  for (const auto& [name, is] : b)
    if (!a.contains(name)) tables.try_emplace(tableOf(name), "0 → " + std::to_string(is->rows) + " rows");
  std::vector<std::string> texts;
  for (const auto& [table, text] : tables) texts.push_back(table + ": " + text);
  return texts;
}

std::string sentencePart(const ChangeLine& line) {
  if (line.heading == "changed") return line.text;
  if (line.heading == "lineage" && line.text == "the same") return "same lineage";
  std::string text = line.text;
  if (const auto at = text.find(" the farthest: "); line.heading == "moved" && at != text.npos)
    return text.replace(at, std::string(" the farthest: ").size(), " moved farthest, by ");
  return line.heading + ": " + text;
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
  if (keys.empty() && movement.empty() && lineage.empty()) {
    // Changed tables are told only if nothing else differs: nearly every table changes with the state.
    const auto recorded = recordChanges(before, after);
    return recorded.empty() ? "" : line("state", "the same") + lines("recorded", recorded, "tables");
  }
  return keys + (lineage.empty() ? line("lineage", "the same") : lines("lineage", lineage, "cells")) + movement;
}

std::vector<ChangeLine> linesOfChange(const std::string& change) {
  std::vector<ChangeLine> lines;
  for (const std::string& line : linesOf(change)) {
    const auto begin = line.find_first_not_of(' ');
    if (begin == line.npos) continue;
    const auto gap = begin == 2 ? line.find("  ", begin) : line.npos;
    const auto text = begin == 2 ? line.find_first_not_of(' ', std::min(gap, line.size())) : begin;
    if (text == line.npos) lines.push_back({"", line.substr(begin)});
    else lines.push_back({begin == 2 ? line.substr(2, gap - 2) : "", line.substr(text)});
  }
  return lines;
}

std::string changeSentence(const std::string& change) {
  std::string sentence;
  std::size_t more = 0;  // number of lines left out under the last heading
  const auto endHeading = [&] {
    if (more) sentence += " and " + std::to_string(more) + " more";
    more = 0;
  };
  for (const ChangeLine& line : linesOfChange(change)) {
    if (line.heading.empty()) {
      ++more;
      continue;
    }
    endHeading();
    sentence += (sentence.empty() ? "" : "; ") + sentencePart(line);
  }
  endHeading();
  return sentence;
}

}  // namespace morula
