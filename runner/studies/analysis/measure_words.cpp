#include "analysis/measure_words.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/number_text.h"
#include "observation/asked_measure.h"

namespace morula {
namespace {

struct KnownWords {
  const char *measure, *more, *less;
  double zero = 0;  // as MeasureWords::zero
};

constexpr std::array known{
    KnownWords{"clone_contact", "more", "less"},
    KnownWords{"homotypic_contact", "more", "less"},
    KnownWords{"clone_radius", "wider", "tighter"},
    KnownWords{"clone_spread", "more spread out", "more compact"},
    KnownWords{"clone_components", "more", "fewer"},
    KnownWords{"mixing_index", "more mixed", "less mixed"},
    KnownWords{"sphericity", "rounder", "less round", 1},
    KnownWords{"elongation", "longer", "shorter"},
    KnownWords{"organism_elongation", "longer", "shorter"},
    KnownWords{"extent", "wider", "narrower"},
    KnownWords{"neighbours", "more", "fewer"},
    KnownWords{"cells", "more", "fewer"},
    KnownWords{"volume", "larger", "smaller"},
    KnownWords{"cell.volume", "larger", "smaller"},
    KnownWords{"area", "larger", "smaller"},
};

/// Returns "shell_share" for "shell_share of AAA*".
std::string rowOf(const std::string& measure) { return measure.substr(0, measure.find(" of ")); }

template <class Of>
std::string meaningIn(const std::string& row) {
  for (const Measure<Of>& m : measures<Of>())
    if (row == m.name) return m.meaning;
  return "";
}

}  // namespace

MeasureWords wordsOfMeasure(const std::string& measure) {
  std::string plain = measure;
  std::ranges::replace(plain, '_', ' ');
  std::ranges::replace(plain, '.', ' ');
  const std::string row = rowOf(measure);
  const auto asked = findMeasure(measure);
  if (asked && asked->form == AskedMeasure::Form::distance) return {plain, "larger", "smaller", 0, ""};
  if (!asked || asked->parts.empty())
    for (const KnownWords& w : known)
      if (row == w.measure)
        return {plain, w.more, w.less, w.zero, w.zero == 0 ? "" : numberText(w.zero) + " − " + plain};
  return {plain, "higher", "lower", 0, ""};
}

std::string unitOfMeasure(const std::string& measure) {
  try {
    return readMeasure(measure, IfSeveral::first).unit;
  } catch (const InputError&) { return ""; }
}

std::string meaningOfMeasure(const std::string& measure) {
  try {
    const AskedMeasure asked = readMeasure(measure, IfSeveral::first);
    if (asked.scope == Scope::cell) return meaningIn<CellContext>(asked.row);
    return asked.scope == Scope::pair ? meaningIn<Touch>(asked.row) : meaningIn<Observation>(asked.row);
  } catch (const InputError&) { return ""; }
}

std::string titleOfMeasure(const std::string& measure, const Units& units) {
  std::string title = wordsOfMeasure(measure).noun;
  if (!title.empty() && title[0] >= 'a' && title[0] <= 'z') title[0] = static_cast<char>(title[0] - 'a' + 'A');
  return shownUnit(units, unitOfMeasure(measure)).after(title);
}

std::size_t placeOfMeasure(const std::string& measure) {
  const auto& all = allMeasures();
  const auto asked = findMeasure(measure);
  const auto known = findMeasure(rowOf(asked && !asked->parts.empty() ? asked->parts[0].name : measure));
  return std::ranges::find(all, known ? known->name : "", &AskedMeasure::name) - all.begin();
}

}  // namespace morula
