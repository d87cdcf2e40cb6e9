#include "analysis/measure_words.h"

#include <algorithm>
#include <array>
#include <optional>

#include "simulation/measures.h"
#include "study_store/study_tables.h"

namespace morula {

namespace {

struct KnownWords {
  const char *measure, *more, *less;
};

constexpr std::array known{
    KnownWords{"clone_contact", "more", "less"},
    KnownWords{"homotypic_contact", "more", "less"},
    KnownWords{"clone_radius", "wider", "tighter"},
    KnownWords{"clone_components", "more", "fewer"},
    KnownWords{"mixing_index", "more mixed", "less mixed"},
    KnownWords{"sphericity", "rounder", "less round"},
    KnownWords{"elongation", "longer", "shorter"},
    KnownWords{"organism_elongation", "longer", "shorter"},
    KnownWords{"extent", "wider", "narrower"},
    KnownWords{"neighbours", "more", "fewer"},
    KnownWords{"cells", "more", "fewer"},
    KnownWords{"volume", "larger", "smaller"},
    KnownWords{"cell.volume", "larger", "smaller"},
    KnownWords{"area", "larger", "smaller"},
};

struct Row {
  std::size_t place;
  std::string unit;
};

template <class Of>
std::optional<Row> rowIn(const std::string& scope, const std::string& measure, std::size_t& before) {
  const auto rows = measures<Of>();
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (measure == rows[i].name || measure == scope + "." + rows[i].name)
      return Row{before + i, rows[i].unit};
  before += rows.size();
  return std::nullopt;
}

Row rowOf(const std::string& name) {
  const std::string measure = withoutSelection(name);
  std::size_t before = 0;
  if (const auto row = rowIn<Observation>("world", measure, before)) return *row;
  if (const auto row = rowIn<CellContext>("cell", measure, before)) return *row;
  if (const auto row = rowIn<Touch>("pair", measure, before)) return *row;
  return {before, ""};
}

}  // namespace

MeasureWords wordsOfMeasure(const std::string& measure) {
  std::string plain = measure;
  std::ranges::replace(plain, '_', ' ');
  std::ranges::replace(plain, '.', ' ');
  const std::string row = withoutSelection(measure);
  for (const KnownWords& w : known)
    if (row == w.measure) return {plain, w.more, w.less};
  return {plain, "higher", "lower"};
}

std::string unitOfMeasure(const std::string& measure) { return rowOf(measure).unit; }

std::string titleOfMeasure(const std::string& measure, const Units& units) {
  std::string title = wordsOfMeasure(measure).noun;
  if (!title.empty() && title[0] >= 'a' && title[0] <= 'z')
    title[0] = static_cast<char>(title[0] - 'a' + 'A');
  return shownUnit(units, unitOfMeasure(measure)).after(title);
}

std::size_t placeOfMeasure(const std::string& measure) { return rowOf(measure).place; }

}  // namespace morula
