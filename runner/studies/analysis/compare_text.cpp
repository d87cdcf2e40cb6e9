#include <fmt/format.h>

#include <algorithm>

#include "analysis/comparison.h"
#include "analysis/comparison_text.h"
#include "analysis/measure_words.h"
#include "files/text.h"

namespace morula {

namespace {

/// Columns as wide as their widest text, two blanks apart.
class Columns {
 public:
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  std::string text() const {
    std::vector<std::size_t> widths;
    for (const auto& row : rows_)
      for (std::size_t i = 0; i < row.size(); ++i) {
        if (i == widths.size()) widths.push_back(0);
        widths[i] = std::max(widths[i], letters(row[i]));
      }
    std::string text;
    for (const auto& row : rows_) {
      std::string line = "  ";
      for (std::size_t i = 0; i < row.size(); ++i) {
        line += row[i];
        if (i + 1 < row.size()) line += std::string(widths[i] - letters(row[i]) + 2, ' ');
      }
      text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
  }

 private:
  static std::size_t letters(const std::string& s) {
    return static_cast<std::size_t>(
        std::ranges::count_if(s, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
  }
  std::vector<std::vector<std::string>> rows_;
};

constexpr std::size_t mostTroubles = 20;  // lines

std::string header(const StudyComparison& c) {
  const StudyResults& r = c.results;
  const auto count = [&](const char* status) {
    return std::ranges::count(r.tasks, status, &ResultTask::status);
  };
  std::string text =
      fmt::format("{}: {} conditions, {} seed{}, {} of {} distinct runs done\n", r.name, r.conditions.size(),
                  r.seeds.size(), r.seeds.size() == 1 ? "" : "s", count("done"), r.tasks.size());
  if (!r.summary.empty()) text += r.summary + "\n";
  const auto troubles = troublesOf(r);
  for (std::size_t i = 0; i < troubles.size() && i < mostTroubles; ++i) text += "  " + troubles[i] + "\n";
  if (troubles.size() > mostTroubles)
    text += fmt::format("  … and {} more; --json lists them all\n", troubles.size() - mostTroubles);
  if (!c.seedless.empty()) {
    text += "seeds change nothing in these: one run each, and no interval\n";
    for (const std::size_t i : c.seedless) text += "  " + r.nameOf(r.conditions[i]) + "\n";
  }
  return text;
}

std::string conditionTable(const StudyComparison& c, std::size_t measure) {
  Columns columns;
  std::vector<std::string> titles;
  for (const ResultAxis& axis : c.results.axes) titles.push_back(axis.name);
  for (const char* title : {"n", "distinct", "mean", "95 % interval", "values"}) titles.push_back(title);
  columns.add(titles);
  for (const ConditionSummary& s : c.conditions) {
    if (s.measure != measure) continue;
    std::vector<std::string> cells;
    const auto& levels = c.results.conditions[s.condition].levels;
    for (std::size_t a = 0; a < levels.size(); ++a) cells.push_back(c.results.axes[a].labels[levels[a]]);
    std::string values;
    for (const double v : s.values) values += (values.empty() ? "" : " ") + numberText(v, 4);
    cells.insert(cells.end(),
                 {std::to_string(s.values.size()), std::to_string(s.distinct),
                  s.values.empty() ? "-" : numberText(s.mean, 4), intervalText(s.interval), values});
    columns.add(cells);
  }
  return columns.text();
}

std::string atText(const StudyComparison& c, const PairComparison& pair) {
  std::vector<std::string> fixed;
  for (std::size_t a = 0; a < pair.at.size(); ++a)
    if (pair.at[a]) fixed.push_back(c.results.axes[a].labels[*pair.at[a]]);
  return fixed.empty() ? "in the mean" : join(fixed);
}

std::string pairTable(const StudyComparison& c, std::size_t measure, std::size_t axis) {
  Columns columns;
  columns.add({"a − b", "of the others", "pairs", "difference", "95 % interval", "p", "Holm", "d_z", "g",
               "higher", "lower", "unpaired", "paired/unpaired"});
  bool any = false;
  for (const PairComparison& p : c.pairs) {
    if (p.measure != measure || p.axis != axis) continue;
    any = true;
    const auto& labels = c.results.axes[axis].labels;
    const bool estimated = p.known == Known::estimated;
    columns.add({labels[p.a] + " − " + labels[p.b], atText(c, p), std::to_string(p.of.size()),
                 numberText(p.paired.difference, 4),
                 estimated                 ? intervalText(p.paired.interval)
                 : p.known == Known::exact ? "exact"
                                           : "-",
                 estimated ? numberText(p.paired.p, 2) : "-", estimated ? numberText(p.corrected, 2) : "-",
                 orDash(p.effect.dz), orDash(p.effect.g), std::to_string(p.signs.higher),
                 std::to_string(p.signs.lower), p.unpaired ? intervalText(p.unpaired->interval) : "-",
                 orDash(p.intervalRatio(), 2)});
  }
  return any ? fmt::format("\n  by {}, seed by seed\n", c.results.axes[axis].name) + columns.text() : "";
}

std::string effectTable(const StudyComparison& c, const MeasureEffects& effects) {
  std::string text = "\n  main effects and interactions\n";
  Columns columns;
  columns.add({"", "η²", "F", "df", "p", "Holm", "means"});
  for (std::size_t i = 0; i < effects.analysis.effects.size(); ++i) {
    const FactorEffect& e = effects.analysis.effects[i];
    std::vector<std::string> names;
    for (const std::size_t f : e.factors) names.push_back(c.results.axes[effects.axes[f]].name);
    std::string means;
    if (e.factors.size() == 1) {
      const auto& axis = c.results.axes[effects.axes[e.factors[0]]];
      for (std::size_t l = 0; l < axis.labels.size(); ++l)
        means += (l ? ", " : "") + axis.labels[l] + " " + numberText(effects.means[e.factors[0]][l], 4);
    }
    columns.add(
        {join(names, " × "), numberText(e.share, 3), orDash(e.f),
         e.f ? fmt::format("{}, {}", e.degreesOfFreedom, effects.analysis.errorDegreesOfFreedom) : "-",
         orDash(e.p, 2), orDash(effects.corrected[i], 2), means});
  }
  text += columns.text();
  if (!effects.untested.empty()) text += "  no F test: " + effects.untested + "\n";
  return text;
}

/// A line a condition, with up to eight of the times.
std::string courseTable(const StudyComparison& c, std::size_t measure) {
  Columns columns;
  bool any = false;
  for (const TimeCourse& course : c.courses) {
    if (course.measure != measure) continue;
    const std::size_t count = course.points.size(), shown = std::min<std::size_t>(count, 8);
    const auto at = [&](std::size_t i) { return shown < 2 ? 0 : i * (count - 1) / (shown - 1); };
    std::vector<std::string> cells{"time"};
    for (std::size_t i = 0; i < shown; ++i) cells.push_back(numberText(course.points[at(i)].time, 4));
    if (!any) columns.add(cells);
    any = true;
    cells = {c.results.nameOf(c.results.conditions[course.condition])};
    for (std::size_t i = 0; i < shown; ++i) cells.push_back(numberText(course.points[at(i)].mean, 4));
    columns.add(cells);
  }
  return any ? "\n  means over time\n" + columns.text() : "";
}

std::string equivalenceTable(const StudyComparison& c, std::size_t measure) {
  Columns columns;
  columns.add({"a, b", "of the others", "difference", "90 % interval", "margin", "p", "Holm", "verdict"});
  bool any = false;
  for (const PairComparison& p : c.pairs) {
    if (p.measure != measure || !p.equivalence) continue;
    any = true;
    const auto& labels = c.results.axes[p.axis].labels;
    const auto& same = *p.equivalence;
    columns.add({labels[p.a] + ", " + labels[p.b], atText(c, p), numberText(p.paired.difference, 4),
                 intervalText(same.test.interval), "±" + numberText(same.test.margin, 4),
                 numberText(same.test.p, 2), numberText(same.corrected, 2), name(same.verdict)});
  }
  return any ? "\n  equivalence, two one-sided tests\n" + columns.text() : "";
}

}  // namespace

std::string describe(const StudyComparison& c) {
  std::string text = header(c);
  const auto verdicts = verdictsOf(c);
  if (!verdicts.empty()) text += "\n";
  for (const std::string& line : verdicts) text += line + "\n";
  for (const std::size_t m : c.measures) {
    const bool any = std::ranges::any_of(
        c.conditions, [&](const ConditionSummary& s) { return s.measure == m && !s.values.empty(); });
    if (!any) continue;
    const std::string unit = unitOfMeasure(c.measureName(m));
    text += fmt::format("\n{}{}\n", c.measureName(m), unit.empty() ? "" : " [" + unit + "]");
    text += conditionTable(c, m);
    for (const std::size_t axis : c.by) text += pairTable(c, m, axis);
    text += equivalenceTable(c, m);
    for (const MeasureEffects& e : c.effects)
      if (e.measure == m) text += effectTable(c, e);
    text += courseTable(c, m);
  }
  return text;
}

}  // namespace morula
