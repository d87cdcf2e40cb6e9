#pragma once
// One table of all sections and parameters, from which the loader, the schema for editors, the list for people and the
// resolved form are made.
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "values/parameter.h"

namespace morula::scenario {

/// A map of parameters. If absent, its parameters have their defaults, or the part that it describes does not exist.
struct Section {
  enum class Members { any, atLeastOne, exactlyOne };  // keys that refine others do not count
  std::string path{};                                  // "" is the whole file
  std::string meaning{};
  std::string absent{};  // for people: what holds if the section is absent
  bool required = false;
  Members members = Members::any;
  Decides decides = Decides::results;
  std::string needs{};                            // path of a section without which this one makes no sense
  bool later = false;                             // as Parameter::later: while empty, no part of the meaning
  std::function<void(Scenario&)> make{};          // called when the section is given
  std::function<bool(const Scenario&)> exists{};  // absent: the section always exists
  // The entries of a section whose keys are the user's own, such as substances: all of them, as one map.
  std::optional<Parameter> entries{};
  std::string details{};  // Markdown that stands below the section's meaning

  bool existsIn(const Scenario& scenario) const { return !exists || exists(scenario); }
  std::string key() const { return path.substr(path.rfind('.') + 1); }
  std::string parent() const { return path.substr(0, path.rfind('.') == path.npos ? 0 : path.rfind('.')); }
};

struct ParameterTable {
  std::vector<Section> sections;      // each before the sections inside it
  std::vector<Parameter> parameters;  // in the order in which people should meet them

  const Section* section(std::string_view path) const;
  const Parameter* parameter(std::string_view path) const;
  /// Return the parameters and sections directly inside a section.
  std::vector<const Parameter*> parametersOf(std::string_view section) const;
  std::vector<const Section*> sectionsOf(std::string_view section) const;
};

/// The table (parameter_table.cpp).
const ParameterTable& parameterTable();

/// Returns all sections of the table (section_table.cpp), each before the sections inside it.
std::vector<Section> sections();

/// Returns a Scenario with all defaults, in which every section exists.
Scenario allDefaults();

}  // namespace morula::scenario
