#include "analysis/measure_words.h"

#include <algorithm>
#include <array>
#include <optional>

#include "simulation/measures.h"

namespace morula {

namespace {

struct KnownWords {
  const char *measure, *subject, *more, *less;
};

constexpr std::array known{
    KnownWords{"sister_contact", "sister adjacency", "higher", "lower"},
    KnownWords{"cousin_contact", "cousin adjacency", "higher", "lower"},
    KnownWords{"clone_contact", "contact within clones", "more", "less"},
    KnownWords{"homotypic_contact", "contact between cells of one kind", "more", "less"},
    KnownWords{"clone_radius", "clones", "wider", "tighter"},
    KnownWords{"clone_components", "pieces of a clone", "more", "fewer"},
    KnownWords{"mixing_index", "clones", "more mixed", "less mixed"},
    KnownWords{"lineage_space", "correlation of lineage and space", "higher", "lower"},
    KnownWords{"sphericity", "cells", "rounder", "less round"},
    KnownWords{"elongation", "cells", "longer", "shorter"},
    KnownWords{"organism_elongation", "organism", "longer", "shorter"},
    KnownWords{"extent", "organism", "wider", "narrower"},
    KnownWords{"neighbours", "neighbours of a cell", "more", "fewer"},
    KnownWords{"cells", "cells", "more", "fewer"},
    KnownWords{"volume", "volume", "larger", "smaller"},
    KnownWords{"cell.volume", "cells", "larger", "smaller"},
    KnownWords{"area", "area of contacts", "larger", "smaller"},
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

Row rowOf(const std::string& measure) {
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
  for (const KnownWords& w : known) {
    if (measure != w.measure) continue;
    const bool spokenOf = std::string(w.subject).ends_with("adjacency");
    return {spokenOf ? w.subject : plain, w.subject, w.more, w.less};
  }
  return {plain, plain, "higher", "lower"};
}

std::string unitOfMeasure(const std::string& measure) { return rowOf(measure).unit; }

std::string titleOfMeasure(const std::string& measure) {
  std::string title = wordsOfMeasure(measure).noun;
  if (!title.empty() && title[0] >= 'a' && title[0] <= 'z')
    title[0] = static_cast<char>(title[0] - 'a' + 'A');
  const std::string unit = unitOfMeasure(measure);
  return title + (unit.empty() ? "" : " [" + unit + "]");
}

std::size_t placeOfMeasure(const std::string& measure) { return rowOf(measure).place; }

}  // namespace morula
