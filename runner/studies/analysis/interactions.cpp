// Two axes that interact, as one small table: the means at all their levels, and which of them differ.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "analysis/compare_parts.h"
#include "analysis/measure_words.h"
#include "base/number_text.h"
#include "files/text.h"

namespace morula {
namespace {

/// Pairs of levels that a cell of a table names at most; --json and the tables of pairs name all.
constexpr std::ptrdiff_t namedInTables = 2;

struct LevelMeans {
  Interaction interaction;
  std::size_t measure, axis, other;                       // `other` is that of the interaction
  std::vector<std::vector<std::optional<double>>> means;  // [level of axis][level of other]
};

std::vector<const PairComparison*> pairsAt(const StudyComparison& c, std::size_t measure, std::size_t axis,
                                           std::size_t other, std::size_t level) {
  std::vector<const PairComparison*> pairs;
  for (const PairComparison& p : c.split)
    if (p.measure == measure && p.axis == axis && p.at[other] == level) pairs.push_back(&p);
  return pairs;
}

/// Returns a table's subject for each measure and two axes of which one or both are compared at each level of the other.
std::vector<LevelMeans> interactionsOf(const StudyComparison& c) {
  std::vector<LevelMeans> all;
  for (const std::size_t m : c.measures)
    for (const std::size_t axis : comparedAxes(c)) {
      const auto interaction = interactionOf(c, m, axis);
      if (!interaction || std::ranges::any_of(all, [&](const LevelMeans& k) {
            return k.measure == m && k.axis == interaction->other && k.other == axis;
          }))
        continue;
      const std::size_t other = interaction->other, columns = c.results.axes[other].labels.size();
      LevelMeans found{*interaction, m, axis, other, {}};
      found.means.assign(c.results.axes[axis].labels.size(), std::vector<std::optional<double>>(columns));
      for (std::size_t l = 0; l < columns; ++l)
        for (const PairComparison* p : pairsAt(c, m, axis, other, l))
          found.means[p->a][l] = p->meanA, found.means[p->b][l] = p->meanB;
      all.push_back(std::move(found));
    }
  return all;
}

/// Returns "every two", "none shown (±0.2)" or "1 and 3, 2 and 3" of the levels of an axis at a level of the other one;
/// where more pairs differ than are to be named, "9 of 15 pairs"; absent where its levels are not compared there.
std::optional<std::string> differing(const StudyComparison& c, const LevelMeans& of, bool rows, std::size_t level,
                                     std::ptrdiff_t named = std::numeric_limits<std::ptrdiff_t>::max()) {
  const std::size_t axis = rows ? of.axis : of.other, other = rows ? of.other : of.axis;
  const auto pairs = pairsAt(c, of.measure, axis, other, level);
  if (pairs.empty()) return std::nullopt;
  const std::string which = levelsThatDiffer(c, pairs);
  const auto count = std::ranges::count_if(pairs, [](const PairComparison* p) { return isDifferent(*p); });
  if (count > named && count < std::ssize(pairs)) return fmt::format("{} of {} pairs", count, pairs.size());
  if (!which.empty()) return which;
  double most = 0;
  for (const PairComparison* p : pairs)
    if (const auto& i = p->paired.interval) most = std::max({most, -i->low, i->high});
  return "none shown" + (most > 0 ? " (±" + numberText(most, 2) + ")" : std::string());
}

Json shareJson(const LevelMeans& of) {
  const FactorEffect& e = of.interaction.of->analysis.effects[of.interaction.effect];
  return {{"eta_squared", e.share},
          {"partial_eta_squared", orNull(e.partial)},
          {"p_holm", orNull(of.interaction.of->corrected[of.interaction.effect])}};
}

}  // namespace

std::string levelsThatDiffer(const StudyComparison& c, const std::vector<const PairComparison*>& pairs) {
  std::vector<std::string> differ;
  for (const PairComparison* p : pairs) {
    const auto& labels = c.results.axes[p->axis].labels;
    if (isDifferent(*p)) differ.push_back(labels[p->a] + " and " + labels[p->b]);
  }
  return differ.size() > 1 && differ.size() == pairs.size() ? "every two" : join(differ);
}

Document interactionTables(const StudyComparison& c) {
  Document text;
  for (const LevelMeans& of : interactionsOf(c)) {
    const ResultAxis &axis = c.results.axes[of.axis], &other = c.results.axes[of.other];
    const std::string name = c.measureName(of.measure);
    const double share = of.interaction.of->analysis.effects[of.interaction.effect].share;
    const std::string title =
        fmt::format("{} by {} and {}, interaction η² {}", shownUnit(c.units, unitOfMeasure(name)).after(name),
                    axis.name, other.name, shareText(share));
    Table table{title, {axis.name}};
    std::vector<Cell> last{"differ"};
    bool anyRow = false, anyColumn = false;
    for (std::size_t l = 0; l < other.labels.size(); ++l) {
      table.columns.push_back(other.name + " " + other.labels[l]);
      const auto which = differing(c, of, true, l, namedInTables);
      anyRow = anyRow || which;
      last.push_back(Cell(which.value_or("")));
    }
    for (std::size_t k = 0; k < axis.labels.size(); ++k) {
      std::vector<Cell> row{axis.labels[k]};
      for (const auto& mean : of.means[k]) row.push_back(number(mean, 3));
      const auto which = differing(c, of, false, k, namedInTables);
      anyColumn = anyColumn || which;
      row.push_back(Cell(which.value_or("")));
      table.rows.push_back(std::move(row));
    }
    if (anyRow) table.rows.push_back(std::move(last));
    if (anyColumn) table.columns.push_back("differ");
    for (auto& row : table.rows) row.resize(table.columns.size(), Cell(""));
    text.heading(title).add(std::move(table));
  }
  return text;
}

Json interactionsJson(const StudyComparison& c) {
  Json list = Json::array();
  for (const LevelMeans& of : interactionsOf(c)) {
    const ResultAxis &axis = c.results.axes[of.axis], &other = c.results.axes[of.other];
    Json means = Json::object(), rows = Json::object(), columns = Json::object();
    for (std::size_t k = 0; k < axis.labels.size(); ++k) {
      for (std::size_t l = 0; l < other.labels.size(); ++l)
        means[axis.labels[k]][other.labels[l]] = orNull(of.means[k][l]);
      if (const auto which = differing(c, of, false, k)) columns[axis.labels[k]] = *which;
    }
    for (std::size_t l = 0; l < other.labels.size(); ++l)
      if (const auto which = differing(c, of, true, l)) rows[other.labels[l]] = *which;
    Json one{{"measure", c.measureName(of.measure)}, {"axis", axis.name}, {"other", other.name}};
    one.update(shareJson(of));
    one.update(Json{{"means", means}, {"levels_that_differ", rows}, {"others_that_differ", columns}});
    list.push_back(std::move(one));
  }
  return list;
}

}  // namespace morula
