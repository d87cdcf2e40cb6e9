
#include "observation/asked_measure.h"

#include <algorithm>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "biology/substance_pattern.h"
#include "observation/organism_measures.h"

namespace morula {
namespace {

constexpr std::string_view beforeSelection = " of ", distanceWord = "distance ", divided = " / ", minus = " - ";

using Form = AskedMeasure::Form;

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
  const auto isMeant = [&](const AskedMeasure& m) {
    return m.row == row && !(hasCells && m.scope == Scope::world && !m.ofClones);
  };
  const bool takesFirst =
      several == IfSeveral::first || (hasCells && std::ranges::count_if(allMeasures(), isMeant) == 1);
  for (const AskedMeasure& m : allMeasures()) {
    if (m.name == row || withScope(m) == row || (takesFirst && isMeant(m))) return m;
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

/// Returns the name in results.
std::string nameOf(const AskedMeasure& m) {
  const std::string ofCells = m.of ? std::string(beforeSelection) + m.of->text() : "";
  switch (m.form) {
    case Form::count: return "count" + ofCells;
    case Form::distance: return std::string(distanceWord) + m.of->text() + " " + m.to->text();
    case Form::ratio: return m.parts[0].name + std::string(divided) + m.parts[1].name;
    case Form::difference: return m.parts[0].name + std::string(minus) + m.parts[1].name;
    case Form::row: break;
  }
  const auto isRow = [&](const AskedMeasure& known) { return known.row == m.row && known.scope == m.scope; };
  return std::ranges::find_if(allMeasures(), isRow)->name + ofCells;
}

/// Takes the first selection from `text`, with the space behind it.
AskedCells takeSelection(std::string& text) {
  auto end = text.find(' ');
  if (end != text.npos && std::ranges::find(selectionWords, text.substr(0, end)) != selectionWords.end())
    end = text.find(' ', end + 1);
  const AskedCells selection = parseSelection(text.substr(0, end));
  if (selection.kind == CellSelection::Kind::clones)
    throw InputError("a distance is between two selections of cells, and 'clones' are several; name one, as AA*");
  text = end == text.npos ? "" : text.substr(end + 1);
  return selection;
}

AskedMeasure readDistance(std::string text) {
  const std::string whole = text;
  text = text.substr(distanceWord.size());
  AskedMeasure m{"", "", "length", Scope::world, Needs::bodies, true};
  m.form = Form::distance;
  m.of = takeSelection(text);
  if (text.empty()) throw InputError("'" + whole + "' names one selection of cells; needs two, as distance AA AB");
  m.to = takeSelection(text);
  if (!text.empty())
    throw InputError("'" + whole + "' names more than two selections of cells; needs two, as distance AA AB");
  m.name = nameOf(m);
  return m;
}

/// Returns the unit of a quotient: "length³/length²" for a volume over an area, "" for two of one unit.
std::string unitOfRatio(const std::string& above, const std::string& below) {
  if (above == below) return "";
  if (below.empty()) return above;
  const bool isSimple = below.find('/') == below.npos && below.find("·") == below.npos;
  return (above.empty() ? "1" : above) + "/" + (isSimple ? below : "(" + below + ")");
}

AskedMeasure readPair(const std::string& text, std::size_t at, IfSeveral several) {
  const auto read = [&](const std::string& part) {
    AskedMeasure m = readMeasure(part, several);
    if (!m.parts.empty()) throw InputError("'" + text + "' has more than one / or -; needs two measures with one");
    if (m.of && m.of->kind == CellSelection::Kind::clones)
      throw InputError("'" + part + "' is several measures, one for each clone; name one clone, as AA*");
    return m;
  };
  const bool isRatio = text.compare(at, divided.size(), divided) == 0;
  AskedMeasure m{"", "", "", Scope::world, Needs::nothing, true};
  m.form = isRatio ? Form::ratio : Form::difference;
  m.parts = {read(text.substr(0, at)), read(text.substr(at + divided.size()))};
  const std::string &above = m.parts[0].unit, &below = m.parts[1].unit;
  if (!isRatio && above != below)
    throw InputError("'" + m.parts[0].name + "' is in " + (above.empty() ? "no unit" : above) + " and '" +
                     m.parts[1].name + "' in " + (below.empty() ? "no unit" : below) +
                     "; a difference needs two measures in one unit");
  m.unit = isRatio ? unitOfRatio(above, below) : above;
  m.followsNumber = m.parts[0].followsNumber || m.parts[1].followsNumber;
  m.name = nameOf(m);
  return m;
}

}  // namespace

std::string AskedMeasure::title() const {
  if (!parts.empty()) return parts[0].title() + std::string(form == Form::ratio ? divided : minus) + parts[1].title();
  if (form == Form::distance) return name;
  std::string text = form == Form::count ? "count" : row;
  std::ranges::replace(text, '_', ' ');
  if (of) text += std::string(beforeSelection) + of->text();
  return text;
}

const std::vector<AskedMeasure>& allMeasures() {
  static const std::vector<AskedMeasure> list = makeList();
  return list;
}

AskedMeasure readMeasure(const std::string& text, IfSeveral several) {
  if (const auto pair = std::min(text.find(divided), text.find(minus)); pair != text.npos)
    return readPair(text, pair, several);
  if (text.starts_with(distanceWord)) return readDistance(text);
  const auto at = text.find(beforeSelection);
  if (at == text.npos) return readRow(text, false, several);
  const std::string measured = text.substr(0, at);
  const bool isCount = measured == "count";
  AskedMeasure m =
      isCount ? AskedMeasure{"", "", "", Scope::world, Needs::nothing, true} : readRow(measured, true, several);
  if (isCount) m.form = Form::count;
  else if (m.scope == Scope::world && !m.ofClones)
    throw InputError("'" + measured +
                     "' measures the whole organism and takes no 'of'; measures of cells, pairs and clones take it, "
                     "and so does count");
  m.of = parseSelection(text.substr(at + beforeSelection.size()));
  if (m.ofClones && m.of->kind != CellSelection::Kind::generation)
    throw InputError("'" + measured +
                     "' is the mean over all clones; needs 'of generation N', which takes the clones of the cells N "
                     "divisions from the egg");
  m.name = nameOf(m);
  return m;
}

std::optional<AskedMeasure> findMeasure(const std::string& text) {
  try {
    return readMeasure(text);
  } catch (const InputError&) { return std::nullopt; }
}

std::optional<double> combined(Form form, std::optional<double> a, std::optional<double> b) {
  if (!a || !b || (form == Form::ratio && *b == 0)) return std::nullopt;
  return form == Form::ratio ? *a / *b : *a - *b;
}

AskedMeasure withSelections(AskedMeasure m, const std::function<AskedCells(const AskedCells&)>& replace) {
  for (AskedMeasure& part : m.parts) part = withSelections(part, replace);
  if (m.of) m.of = replace(*m.of);
  if (m.to) m.to = replace(*m.to);
  m.name = nameOf(m);
  return m;
}

std::vector<AskedMeasure> eachClone(const AskedMeasure& measure) {
  if (!measure.of || measure.of->kind != CellSelection::Kind::clones) return {measure};
  std::vector<AskedMeasure> all;
  for (int clone = 0; clone < 1 << cloneDepth; ++clone) {
    std::string founder;
    for (int i = cloneDepth; i-- > 0;) founder += clone >> i & 1 ? 'B' : 'A';
    all.push_back(withSelections(measure, [&](const AskedCells&) { return parseSelection(founder + "*"); }));
  }
  return all;
}

std::string unknownSubstance(const AskedMeasure& m, const std::vector<std::string>& substances) {
  for (const AskedMeasure& part : m.parts)
    if (const std::string unknown = unknownSubstance(part, substances); !unknown.empty()) return unknown;
  for (const auto& cells : {m.of, m.to}) {
    if (!cells || cells->kind != CellSelection::Kind::substance ||
        std::ranges::any_of(substances, [&](const std::string& s) { return fits(cells->substance, s); }))
      continue;
    const std::string near = closest(cells->substance, substances);
    return "no cell ever holds a substance '" + cells->substance + "'" +
           (near.empty() ? "; needs one of its DNA" : "; did you mean " + near + "?");
  }
  return "";
}

}  // namespace morula
