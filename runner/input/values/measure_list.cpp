#include "values/measure_list.h"

#include "values/scenario_data.h"

namespace morula {
namespace {

template <class Of>
Json rowsAsJson() {
  Json rows = Json::array();
  for (const Measure<Of>& m : measures<Of>())
    rows.push_back({{"name", m.name},
                    {"unit", m.unit},
                    {"meaning", m.meaning},
                    {"needs", name(m.needs)},
                    {"follows_number", m.followsNumber},
                    {"of_clones", m.ofClones != nullptr},
                    {"sampled", m.taken == Taken::withSamples}});
  return rows;
}

std::string tableOf(const char* title, const char* about, const Json& rows) {
  std::string text = std::string("## ") + title + "\n\n" + about +
                     "\n\n| name | unit | needs | number of cells | meaning |\n|---|---|---|---|---|\n";
  for (const Json& row : rows) {
    const auto sampled = row.at("sampled").get<bool>();
    text += "| `" + row.at("name").get<std::string>() + "`" + (sampled ? "" : " (on demand)") + " | " +
            row.at("unit").get<std::string>() + " | " + row.at("needs").get<std::string>() + " | " +
            (row.at("follows_number").get<bool>() ? "follows" : "") + " | " + row.at("meaning").get<std::string>() +
            " |\n";
  }
  return text + "\n";
}

}  // namespace

std::string measuresAsMarkdown() {
  std::string text =
      "# Measures\n\n"
      "Written by `morula schema --measures --markdown` from the tables that they are measured with; do not edit.\n"
      "Units are the scene's own: a length, a mass and a time; a force is mass·length/time².\n\n"
      "A measure is a column of the database, a value of goldens (`when/who/name`) and a key of `morula run --json`\n"
      "under its name, at every time that `record` names. Those on demand are taken where a check asks for them, "
      "and\nwhere `record: {measures: [...]}` names them: each value is then a row of the table `measure` and of "
      "`measure` in JSON.\n"
      "What a scene does not have is not measured: NULL in the database, null in JSON, 0 in a golden.\n\n"
      "Where a measure may stand (`record.measures`, `measures` of a study, `chart`, `--colour` of cells), it may be "
      "of some cells\nalone, `MEASURE of SELECTOR`; pairs are then those with one of these cells at least. Such a "
      "value has this name.\n\n"
      "| selector | cells |\n|---|---|\n"
      "| `cell ABa` | the cell of this name (`names` of the scenario) |\n"
      "| `clone ABa` | that cell and all that descend from it |\n"
      "| `path AAA` | the cell with this path, A and B from the egg on; `path AAA*` with all that descend from it |\n"
      "| `generation 3` | all cells three divisions from the egg |\n"
      "| `substance s*` | all cells that hold the substance, or one that begins so |\n"
      "| `clones` | the descendants of each cell two divisions from the egg; in a study one measure for each, of AA*, "
      "AB*, BA* and BB* |\n\n"
      "A word alone, as `ABa`, `AAA*` or `skin`, is a cell's name, a path or a substance; it is refused if it could "
      "mean two of them.\n\n"
      "| measure | value |\n|---|---|\n"
      "| `count of SELECTOR` | the number of these cells |\n"
      "| `distance SELECTOR SELECTOR` | the distance between the mean centres of two selections: `distance cell ABa "
      "cell P2` |\n"
      "| `MEASURE / MEASURE`, `MEASURE - MEASURE` | the ratio or the difference of two of all these, each in the mean "
      "over its cells or pairs; no value where one of them has none, or the divisor is 0 |\n\n"
      "A study takes the mean over the cells. Measures of clones (`clone_` and\n`mixing_index`) take `generation N` "
      "alone: their clones are then those of the cells N divisions from the egg.\n\n"
      "Number of cells: what `follows` it changes with how many cells there are, or how small, though nothing else "
      "differs. Compare\nit between organisms of as many cells, or take another: `clone_spread` for "
      "`clone_radius`.\n\n";
  text += tableOf("Measures of the organism", "Table `sample`, in goldens `organism`.", rowsAsJson<Observation>());
  text += tableOf("Measures of a cell", "Table `cell_sample`; what needs bodies alone is in `bullet_sample`, too.",
                  rowsAsJson<CellContext>());
  text += tableOf("Measures of two cells that touch", "Table `contact`.", rowsAsJson<Touch>());
  text.pop_back();
  return text;
}

std::string measuresAsJson() {
  const Json all{
      {"world", rowsAsJson<Observation>()}, {"cell", rowsAsJson<CellContext>()}, {"pair", rowsAsJson<Touch>()}};
  return jsonText(all, 2) + "\n";
}

std::string lackingFor(Needs needs, const Scenario& scenario) {
  const auto& mechanics = scenario.scene.mechanics;
  const auto& reference = scenario.check.reference;
  const auto unless = [](bool has, const char* what) { return has ? std::string() : what; };
  switch (needs) {
    case Needs::nothing: return "";
    case Needs::bodies: return unless(mechanics.has_value(), "bodies: add a physics block");
    case Needs::contact:
      return unless(mechanics && mechanics->contact, "cells that touch: add 'contact: {}' to physics");
    case Needs::shell: return unless(mechanics && mechanics->physics.shell, "a shell: add physics.shell");
    case Needs::referenceContacts:
      return unless(mechanics && mechanics->contact && reference && !reference->contacts.empty(),
                    "bodies that touch and check.reference.contacts to compare with");
    case Needs::referencePositions:
      return unless(mechanics && reference && reference->positions.size() >= 3,
                    "bodies and check.reference.positions to compare with, three at least");
  }
  return "";
}

Json unitJson(const Units& units, const std::string& unit) {
  Json json{{"unit", unit}};
  const ShownUnit known = shownUnit(units, unit);
  if (!unit.empty() && known.name != unit) json["known_unit"] = {{"name", known.name}, {"factor", known.factor}};
  return json;
}

Json knownUnits(const Units& units) {
  Json json = Json::object();
  for (const char* unit : {"length", "time"})
    if (Json one = unitJson(units, unit); one.contains("known_unit")) json[unit] = one["known_unit"];
  return json;
}

Json shownUnits(const Units& units) {
  Json json = Json::object();
  const auto add = [&](const std::string& what, std::string_view unit) {
    const ShownUnit shown = shownUnit(units, unit);
    json[what] = {shown.name, shown.factor};
  };
  for (const auto& m : sampledMeasures<CellContext>()) add(m.name, m.unit);
  for (const auto& m : sampledMeasures<Observation>()) add(m.name, m.unit);
  add("time", units.time.empty() ? "" : "time");
  add("scale", units.length.empty() ? "" : "length");
  add("contact", units.length.empty() ? "" : "length²");
  return json;
}

}  // namespace morula
