#pragma once
// One description per parameter feeds the loader, the schema for editors, the list for people and the
// resolved form.
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "scenario/scenario.h"
#include "system/json.h"
#include "yaml/node.h"

namespace morula::scenario {

/// A substance named outside of the DNA: to be looked up once the DNA is read.
struct SubstanceUse {
  std::string name;
  Place place;
  std::string path;
  bool isPattern = false;  // the beginning of names and '*'
};

/// Where the DNA's text comes from. Parsed after everything else is read.
struct DnaSource {
  std::optional<Node> text;  // the scalar in the scenario
  std::optional<std::string> file;
  Place place;
};

/// Where a cell got its name.
struct NameUse {
  CellPath path;
  Place place;         // in the scenario, of the name or of the file that it stands in
  std::string key;     // "names.cells.AB", "names.file"
  std::string inFile;  // "names.txt:3:1"; "": it stands in the scenario itself
};

/// What check.reference says, to be read once cells have their names.
struct ReferenceSource {
  std::optional<Node> contacts, positions, file;
};

/// What reading the values needs and leaves behind besides the Scenario.
struct Reading {
  Problems& problems;
  std::vector<SubstanceUse> substances;
  DnaSource dna;
  std::vector<Place> startCells;  // where each of `cells` stands
  std::vector<NameUse> names{};
  std::optional<std::pair<std::string, Place>> namesFile{};
  std::vector<Place> rules{};     // where each of `division.rules` stands
  std::set<std::string>
      senses{};  // substances that `senses` names, whether or not their conditions could be read
  std::optional<ReferenceSource> reference{};
};

enum class Decides {
  results,       // part of Scenario::meaning
  presentation,  // names, colours, pictures
};

struct Parameter {
  std::string path{};     // "physics.membrane.stiffness"
  std::string unit{};     // "force/length"; empty: a pure number or no number
  std::string allowed{};  // for people: "a number > 0", "longest or random"
  std::string meaning{};  // one line
  bool required = false;
  Decides decides = Decides::results;
  Json schema{};         // JSON Schema of the value
  std::string absent{};  // for people: what holds if an optional value is not given
  std::string needs{};   // the key of a neighbour that it refines and makes no sense without
  bool joins = false;    // where exactly one of its section is wanted, it may stand beside that one, or alone
  bool later = false;    // joined when there were goldens: at its default it is no part of the meaning
  std::function<void(Scenario&, const Node&, Reading&)> read{};
  std::function<Json(const Scenario&)> write{};  // null: not given

  std::string key() const { return path.substr(path.rfind('.') + 1); }
  std::string parent() const { return path.substr(0, path.rfind('.') == path.npos ? 0 : path.rfind('.')); }
};

/// A map of parameters. Absent: its parameters have their defaults, or the part that it describes does not
/// exist.
struct Section {
  enum class Members { any, atLeastOne, exactlyOne };  // not counting what refines another
  std::string path{};                                  // "" is the whole file
  std::string meaning{};
  std::string absent{};  // for people: what holds without it
  bool required = false;
  Members members = Members::any;
  Decides decides = Decides::results;
  std::string needs{};                    // the path of a section without which this one makes no sense
  bool later = false;                     // as of a parameter: with nothing in it no part of the meaning
  std::function<void(Scenario&)> make{};  // called when the section is given
  std::function<bool(const Scenario&)> exists{};  // absent: always
  // Of a section whose keys are the user's own, such as substances: all of them, as one map.
  std::optional<Parameter> entries{};
  std::string details{};  // Markdown that stands below the section's meaning

  std::string key() const { return path.substr(path.rfind('.') + 1); }
  std::string parent() const { return path.substr(0, path.rfind('.') == path.npos ? 0 : path.rfind('.')); }
};

struct ParameterTable {
  std::vector<Section> sections;      // a section before those inside it
  std::vector<Parameter> parameters;  // in the order in which people should meet them

  const Section* section(std::string_view path) const;
  const Parameter* parameter(std::string_view path) const;
  /// The parameters and sections directly inside a section.
  std::vector<const Parameter*> parametersOf(std::string_view section) const;
  std::vector<const Section*> sectionsOf(std::string_view section) const;
};

/// The table (parameter_table.cpp).
const ParameterTable& parameterTable();

/// A Scenario with all defaults, in which every section exists.
Scenario allDefaults();

// What is done by the table, in the order in which a file is read.

/// Fills the scenario from the document. Everything the table does not allow becomes a problem.
void readTable(const Node& root, Scenario& scenario, Reading& reading);

/// Where named files are looked for.
struct Places {
  std::filesystem::path folder;          // "": nowhere, only what is stored
  const std::vector<NamedFile>& stored;  // first, by role
  bool allowOutside;                     // of the folder
};

/// Parses the DNA and builds the mesh, from the scenario itself or from files. What is wrong in them is
/// reported with their own lines.
void readReferences(Scenario& scenario, Reading& reading, const Node& root, const Places& places);

/// Names that a file gives to cells, one "PATH NAME" a line, "egg" for the egg's path (cell_name_types.cpp). What is
/// wrong is reported with the file's lines.
void readCellNames(const std::string& text, const std::string& file, const Place& place, Scenario& scenario,
                   Reading& reading);
/// Cells with one and the same name, and rules that name nobody.
void checkCellNames(const Scenario& scenario, Reading& reading, const Node& root);

/// What check.reference says, in the scenario and in the file that it names, if any (reference_types.cpp).
void readReference(const NamedFile* file, Scenario& scenario, Reading& reading);

/// Sizes the shell by physics.shell.fill, and stretches the egg to an ellipsoid's shape (fitting_shell.cpp).
void fitShell(Scenario& scenario);

/// Substances that the DNA does not know, an egg that does not fit its shell, pictures without bodies.
void crossCheck(const Scenario& scenario, Reading& reading, const Node& root);

/// How cells divide: rules that no cell follows, shares and tilts that cannot be.
void checkDivision(const Scenario& scenario, Reading& reading, const Node& root);

/// The place of a parameter's value, or of the innermost map that is given.
Place placeOf(const Node& root, const std::string& path);

/// Every parameter of every part that exists, in the table's order. Itself a scenario: reading it gives the
/// same again.
Json resolve(const Scenario& scenario);

/// Every parameter that decides results, as `hashMeaning` takes them.
Json resolveMeaning(const Scenario& scenario);

/// The hash of all that decides results, the mesh's vertices among it.
Hash hashMeaning(const Scenario& scenario);

/// JSON with two spaces per level and numbers as std::to_chars writes them, the same on every machine.
std::string writeJson(const Json& value);

}  // namespace morula::scenario
