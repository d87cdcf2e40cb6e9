#include "study/study_measures.h"

#include <algorithm>

#include "base/error.h"
#include "study_store/study_tables.h"

namespace morula {

namespace {

template <class Of>
void addRows(Scope scope, std::vector<StudyMeasure>& list) {
  for (const Measure<Of>& m : measures<Of>())
    list.push_back({.name = m.name,
                    .row = m.name,
                    .unit = m.unit,
                    .scope = scope,
                    .needs = m.needs,
                    .onDemand = m.taken == Taken::onDemand});
}

std::string withScope(const StudyMeasure& m) { return std::string(name(m.scope)) + "." + m.row; }

std::vector<StudyMeasure> makeList() {
  std::vector<StudyMeasure> list;
  addRows<Observation>(Scope::world, list);
  addRows<CellContext>(Scope::cell, list);
  addRows<Touch>(Scope::pair, list);
  for (StudyMeasure& m : list)
    if (std::ranges::count(list, m.row, &StudyMeasure::row) > 1) m.name = withScope(m);
  return list;
}

}  // namespace

const std::vector<StudyMeasure>& studyMeasures() {
  static const std::vector<StudyMeasure> list = makeList();
  return list;
}

namespace {

std::optional<StudyMeasure> findRow(std::string text) {
  std::ranges::replace(text, '-', '_');
  const auto& list = studyMeasures();
  const auto found = std::ranges::find_if(
      list, [&](const StudyMeasure& m) { return m.name == text || withScope(m) == text; });
  return found == list.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

std::optional<StudyMeasure> findStudyMeasure(const std::string& text) {
  const auto at = text.find(beforeSelection);
  if (at == text.npos) return findRow(text);
  const std::string measured = text.substr(0, at);
  std::optional<StudyMeasure> m;
  if (measured == "count") m = StudyMeasure{measured, "", "", Scope::cell, Needs::bodies, false};
  else m = findRow(measured);
  if (!m) return std::nullopt;
  if (m->scope == Scope::world)
    throw InputError("'" + measured +
                     "' is of the organism as a whole and takes no 'of'; measures of cells and pairs do, "
                     "and count");
  m->of = parseSelection(text.substr(at + beforeSelection.size()));
  m->name += std::string(beforeSelection) + m->of->text();
  return m;
}

}  // namespace morula
