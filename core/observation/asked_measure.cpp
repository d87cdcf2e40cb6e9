
#include "observation/asked_measure.h"

#include <algorithm>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "biology/substance_pattern.h"
#include "observation/organism_measures.h"

namespace morula {
namespace {

constexpr std::string_view beforeSelection = " of ";

template <class Of>
void addRows(Scope scope, std::vector<AskedMeasure>& list) {
  for (const Measure<Of>& m : measures<Of>())
    list.push_back({.name = m.name,
                    .row = m.name,
                    .unit = m.unit,
                    .scope = scope,
                    .needs = m.needs,
                    .onDemand = m.taken == Taken::onDemand,
                    .followsNumber = m.followsNumber,
                    .ofClones = m.ofClones != nullptr});
}

std::string withScope(const AskedMeasure& m) { return std::string(name(m.scope)) + "." + m.row; }

std::vector<AskedMeasure> makeList() {
  std::vector<AskedMeasure> list;
  addRows<Observation>(Scope::world, list);
  addRows<CellContext>(Scope::cell, list);
  addRows<Touch>(Scope::pair, list);
  for (AskedMeasure& m : list)
    if (std::ranges::count(list, m.row, &AskedMeasure::row) > 1) m.name = withScope(m);
  return list;
}

/// Reads the name of a row. `hasCells`: a selection stands behind the name, so that a row of the organism is not meant.
AskedMeasure readRow(const std::string& text, bool hasCells, IfSeveral several) {
  std::string row = text;
  std::ranges::replace(row, '-', '_');
  std::vector<std::string> names, scopes;
  for (const AskedMeasure& m : allMeasures()) {
    const bool isFirst = several == IfSeveral::first && m.row == row;
    if (m.name == row || withScope(m) == row || (isFirst && !(hasCells && m.scope == Scope::world && !m.ofClones)))
      return m;
    names.push_back(m.row);
    if (m.row == row) scopes.push_back(m.name);
  }
  if (row == "count") throw InputError("'count' needs cells to count; say which, as count of skin");
  if (!scopes.empty()) {
    std::string remedy = "write " + scopes[0];
    for (std::size_t i = 1; i < scopes.size(); ++i) remedy += " or " + scopes[i];
    throw InputError("'" + text + "' is the name of several measures; " + remedy);
  }
  const std::string near = closest(row, names);
  throw InputError("there is no measure '" + text + "'; " +
                   (near.empty() ? "morula schema --measures lists all" : "did you mean " + near + "?"));
}

}  // namespace

std::string AskedMeasure::title() const {
  std::string text = isCount() ? "count" : row;
  std::ranges::replace(text, '_', ' ');
  if (of) text += std::string(beforeSelection) + of->text();
  return text;
}

const std::vector<AskedMeasure>& allMeasures() {
  static const std::vector<AskedMeasure> list = makeList();
  return list;
}

AskedMeasure readMeasure(const std::string& text, IfSeveral several) {
  const auto at = text.find(beforeSelection);
  if (at == text.npos) return readRow(text, false, several);
  const std::string measured = text.substr(0, at);
  AskedMeasure m = measured == "count" ? AskedMeasure{measured, "", "", Scope::world, Needs::nothing, true}
                                       : readRow(measured, true, several);
  if (!m.isCount() && m.scope == Scope::world && !m.ofClones)
    throw InputError("'" + measured +
                     "' measures the whole organism and takes no 'of'; measures of cells, pairs and clones take it, "
                     "and so does count");
  m.of = parseSelection(text.substr(at + beforeSelection.size()));
  if (m.ofClones && m.of->kind != CellSelection::Kind::generation)
    throw InputError("'" + measured +
                     "' is the mean over all clones; needs 'of generation N', which takes the clones of the cells N "
                     "divisions from the egg");
  m.name += std::string(beforeSelection) + m.of->text();
  return m;
}

std::optional<AskedMeasure> findMeasure(const std::string& text) {
  try {
    return readMeasure(text);
  } catch (const InputError&) { return std::nullopt; }
}

std::vector<AskedMeasure> eachClone(const AskedMeasure& measure) {
  if (!measure.of || measure.of->kind != CellSelection::Kind::clones) return {measure};
  std::vector<AskedMeasure> all;
  for (int clone = 0; clone < 1 << cloneDepth; ++clone) {
    std::string founder;
    for (int i = cloneDepth; i-- > 0;) founder += clone >> i & 1 ? 'B' : 'A';
    AskedMeasure& m = all.emplace_back(measure);
    m.name.replace(m.name.size() - m.of->text().size(), std::string::npos, founder + "*");
    m.of = parseSelection(founder + "*");
  }
  return all;
}

std::string unknownSubstance(const AskedMeasure& m, const std::vector<std::string>& substances) {
  if (!m.of || m.of->kind != CellSelection::Kind::substance ||
      std::ranges::any_of(substances, [&](const std::string& s) { return fits(m.of->substance, s); }))
    return "";
  const std::string near = closest(m.of->substance, substances);
  return "no cell ever holds a substance '" + m.of->substance + "'" +
         (near.empty() ? "; needs one of its DNA" : "; did you mean " + near + "?");
}

}  // namespace morula
