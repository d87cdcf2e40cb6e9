#pragma once
// The tables of measures (core/simulation/measures.h) for people and programs, and measured values as JSON.
#include <string>

#include "simulation/measures.h"
#include "system/json.h"

namespace morula {

/// scenarios/MEASURES.md
std::string measuresAsMarkdown();
/// {"world": [{"name", "unit", "meaning", "needs", "sampled"}, …], "cell": …, "pair": …}
std::string measuresAsJson();

struct Scenario;
/// What a scenario must get so that measures with these needs find something: "bodies: add a physics block"; "" if it has
/// all that it takes.
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

}  // namespace morula
