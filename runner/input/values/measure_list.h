#pragma once
// The tables of measures (core/observation/measures.h) for people and programs, and measured values as JSON.
#include <string>

#include "observation/measures.h"
#include "system/json.h"
#include "values/units.h"

namespace morula {

/// Returns the text of scenarios/MEASURES.md.
std::string measuresAsMarkdown();
/// Returns {"world": [{"name", "unit", "meaning", "needs", "sampled"}, …], "cell": …, "pair": …}.
std::string measuresAsJson();

struct Scenario;
/// Returns the part that a scenario lacks for measures with these needs: "bodies: add a physics block"; "" if it lacks
/// none.
std::string lackingFor(Needs needs, const Scenario& scenario);

/// Adds each value under its measure's name; null where it was not measured.
template <class Of>
void addMeasures(Json& json, const Measured<Of>& measured) {
  const auto rows = sampledMeasures<Of>();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Json& value = json[rows[i].name];
    const std::optional<double>& v = measured.values[i];
    if (!v) value = nullptr;
    else if (rows[i].isWhole) value = static_cast<std::int64_t>(*v);
    else value = *v;
  }
}

/// Units for pages, as {name: [unit, how many of it are one of the scene's]}: for sampled measures, for "time", for
/// Returns {"unit": "length³", "known_unit": {"name": "µm³", "factor": 19683}}: numbers in the unit of the scene, times
/// the factor, are in the known unit. Where `units` know none, `unit` stands alone.
Json unitJson(const Units& units, const std::string& unit);
/// Returns {"length": {"name": "µm", "factor": 27}, "time": …}, of those that `units` know.
Json knownUnits(const Units& units);

/// lengths of a "scale" bar and for areas of a "contact"; the latter two have no name in the scene's own units.
Json shownUnits(const Units& units);

}  // namespace morula
