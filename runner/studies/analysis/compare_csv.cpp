#include "analysis/comparison.h"
#include "base/number_text.h"
#include "files/text.h"

namespace morula {

namespace {

/// A row by the names of its columns; what is not set is empty.
class Table {
 public:
  explicit Table(std::vector<std::string> columns) : columns_(std::move(columns)) { addLine(columns_); }

  class Row {
   public:
    Row(Table& table, const std::string& kind, const std::string& measure)
        : table_(table), cells_(table.columns_.size()) {
      set("kind", kind).set("measure", measure);
    }
    ~Row() { table_.addLine(cells_); }
    Row(const Row&) = delete;
    Row& operator=(const Row&) = delete;

    Row& set(const std::string& column, const std::string& text) {
      for (std::size_t i = 0; i < cells_.size(); ++i)
        if (table_.columns_[i] == column) cells_[i] = text;
      return *this;
    }
    Row& set(const std::string& column, double value) { return set(column, exactText(value)); }
    Row& set(const std::string& column, std::size_t value) { return set(column, std::to_string(value)); }
    Row& set(const std::string& column, const std::optional<double>& value) {
      return value ? set(column, *value) : *this;
    }
    Row& set(const std::optional<Interval>& i) { return i ? set("low", i->low).set("high", i->high) : *this; }
    Row& labels(const StudyResults& r, const std::vector<std::size_t>& levels) {
      for (std::size_t a = 0; a < r.axes.size(); ++a)
        set("axis:" + r.axes[a].name, r.axes[a].labels[levels[a]]);
      return *this;
    }

   private:
    Table& table_;
    std::vector<std::string> cells_;
  };

  const std::string& text() const { return text_; }

 private:
  void addLine(const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) text_ += (i ? "," : "") + quoted(cells[i]);
    text_ += "\n";
  }

  static std::string quoted(const std::string& cell) {
    if (cell.find_first_of(",\"\r\n") == cell.npos) return cell;
    std::string text = "\"";
    for (const char c : cell) text += c == '"' ? std::string("\"\"") : std::string(1, c);
    return text + '"';
  }

  std::vector<std::string> columns_;
  std::string text_;
};

void add(Table& table, const StudyComparison& c, const ConditionSummary& s) {
  const auto& levels = c.results.conditions[s.condition].levels;
  for (std::size_t i = 0; i < s.values.size(); ++i)
    Table::Row(table, "value", c.measureName(s.measure))
        .labels(c.results, levels)
        .set("seed", std::to_string(s.seeds[i]))
        .set("value", s.values[i]);
  Table::Row row(table, "condition", c.measureName(s.measure));
  row.labels(c.results, levels).set("n", s.values.size()).set("distinct", s.distinct).set(s.interval);
  if (!s.values.empty()) row.set("value", s.mean);
}

void add(Table& table, const StudyComparison& c, const PairComparison& p) {
  const ResultAxis& axis = c.results.axes[p.axis];
  Table::Row row(table, "pair", c.measureName(p.measure));
  for (std::size_t a = 0; a < p.at.size(); ++a)
    if (p.at[a]) row.set("axis:" + c.results.axes[a].name, c.results.axes[a].labels[*p.at[a]]);
  row.set("by", axis.name).set("a", axis.labels[p.a]).set("b", axis.labels[p.b]);
  row.set("n", p.of.size()).set("value", p.paired.difference);
  row.set("effect", p.effect.dz)
      .set("g", p.effect.g)
      .set("higher", p.signs.higher)
      .set("lower", p.signs.lower);
  row.set("interval_ratio", p.intervalRatio());
  if (p.known == Known::estimated)
    row.set(std::optional(p.paired.interval)).set("p", p.paired.p).set("p_holm", p.corrected);
  if (p.unpaired)
    row.set("unpaired_low", p.unpaired->interval.low).set("unpaired_high", p.unpaired->interval.high);
  if (p.equivalence)
    row.set("margin", p.equivalence->test.margin)
        .set("p_equivalent_holm", p.equivalence->corrected)
        .set("equivalent", std::string(name(p.equivalence->verdict)));
}

void add(Table& table, const StudyComparison& c, const MeasureEffects& effects) {
  for (std::size_t i = 0; i < effects.analysis.effects.size(); ++i) {
    const FactorEffect& e = effects.analysis.effects[i];
    std::vector<std::string> names;
    for (const std::size_t f : e.factors) names.push_back(c.results.axes[effects.axes[f]].name);
    Table::Row(table, "effect", c.measureName(effects.measure))
        .set("by", join(names, " x "))
        .set("value", e.share)
        .set("effect", e.f)
        .set("p", e.p)
        .set("p_holm", effects.corrected[i])
        .set("n", effects.seeds);
  }
}

void add(Table& table, const StudyComparison& c, const TimeCourse& course) {
  for (const auto& p : course.points)
    Table::Row(table, "course", c.measureName(course.measure))
        .labels(c.results, c.results.conditions[course.condition].levels)
        .set("time", p.time)
        .set("n", p.n)
        .set("value", p.mean)
        .set(p.interval);
}

}  // namespace

std::string toCsv(const StudyComparison& c) {
  std::vector<std::string> columns{"kind", "measure"};
  for (const ResultAxis& axis : c.results.axes) columns.push_back("axis:" + axis.name);
  for (const char* name : {"by",
                           "a",
                           "b",
                           "seed",
                           "time",
                           "n",
                           "distinct",
                           "value",
                           "low",
                           "high",
                           "p",
                           "p_holm",
                           "effect",
                           "g",
                           "higher",
                           "lower",
                           "unpaired_low",
                           "unpaired_high",
                           "interval_ratio",
                           "margin",
                           "p_equivalent_holm",
                           "equivalent"})
    columns.push_back(name);
  Table table(columns);
  for (const auto& s : c.conditions) add(table, c, s);
  for (const auto& p : c.pairs) add(table, c, p);
  for (const auto& e : c.effects) add(table, c, e);
  for (const auto& course : c.courses) add(table, c, course);
  return table.text();
}

}  // namespace morula
