#pragma once
// The description of one parameter, and the state of reading values.
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "system/json.h"
#include "values/scenario_data.h"
#include "yaml/node.h"

namespace morula::scenario {

/// A substance named outside of the DNA: to be looked up once the DNA is read.
struct SubstanceUse {
  std::string name;
  Place place;
  std::string path;
  bool isPattern = false;  // the beginning of names and '*'
};

/// The source of the DNA's text, which is parsed after everything else is read.
struct DnaSource {
  std::optional<Node> text;  // the scalar in the scenario
  std::optional<std::string> file;
  Place place;
};

/// The place at which a cell got its name.
struct NameUse {
  CellPath path;
  Place place;         // in the scenario, of the name or of the file with the name
  std::string key;     // "names.cells.AB", "names.file"
  std::string inFile;  // "names.txt:3:1"; "": the name stands in the scenario itself
};

/// The nodes of check.reference, which are read once cells have their names.
struct ReferenceSource {
  std::optional<Node> contacts, positions, file;
};

/// Cells of a division rule that are called by names or paths, which are read once cells have their names.
struct RuleCells {
  std::size_t rule;  // its place in the list
  std::string text;  // "cell EMS"
  Place place;
  std::string path;  // "division.rules[2].of"
};

/// A colour of cells that are called by names or paths, which is read once cells have their names.
struct WrittenColour {
  std::string cells;  // "clone ABp"
  std::string colour;
  Place place;
  std::string path;  // "colours.clone ABp"
};

/// The state of reading: all that values need and produce besides the Scenario.
struct Reading {
  Problems& problems;
  std::vector<SubstanceUse> substances;
  DnaSource dna;
  std::vector<Place> startCells;  // the places of `cells`
  std::optional<std::pair<std::string, Place>> cellsFile{};
  std::vector<NameUse> names{};
  std::optional<std::pair<std::string, Place>> namesFile{};
  std::vector<Place> rules{};  // the places of `division.rules`
  std::vector<RuleCells> ruleCells{};
  std::vector<WrittenColour> cellColours{};
  std::set<std::string> senses{};  // substances that `senses` names, whether or not their conditions could be read
  std::optional<ReferenceSource> reference{};
  std::vector<Node> measures{};         // the entries of `record.measures`, read once cells have their names
  std::vector<std::string> measured{};  // substances that measures may read: words that may also be names of cells
  std::vector<Node> stopWhen{};         // the entries of `stop.when`, read then, too
  std::vector<Node> experiments{};      // the entries of `experiments`, which are read once cells have their names
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
  std::string needs{};   // the key of a neighbour that this one refines and needs
  bool joins = false;    // in a section of exactly one key: may stand beside that key, or alone
  bool beside = false;   // in a section of exactly one key: is not counted, and may stand beside any
  bool later = false;    // joined the format when there were goldens: no part of the meaning at its default
  std::function<void(Scenario&, const Node&, Reading&)> read{};
  std::function<Json(const Scenario&)> write{};  // returns null if not given

  std::string key() const { return path.substr(path.rfind('.') + 1); }
  std::string parent() const { return path.substr(0, path.rfind('.') == path.npos ? 0 : path.rfind('.')); }
};

/// Gives the name to the cell. Reports a cell that has one (cell_name_types.cpp).
void nameCell(const NameUse& use, const std::string& name, Scenario& scenario, Reading& reading);
/// Reads names that a file gives to cells, one "PATH NAME" a line, "egg" for the egg's path (cell_name_types.cpp).
/// Mistakes are reported with the file's lines.
void readCellNames(const std::string& text, const std::string& file, const Place& place, Scenario& scenario,
                   Reading& reading);
/// Reports cells that share a name, and endings for daughters (names.daughters) in a scenario without names of cells.
void checkCellNames(const Scenario& scenario, Reading& reading, const Node& root);

/// Reads the table of `cells: {file: …}`, one cell a row (start_cell_table.cpp). Mistakes are reported with the table's
/// lines.
void readStartCellTable(const std::string& text, const std::string& file, const Place& place, Scenario& scenario,
                        Reading& reading);

/// Reads check.reference, in the scenario and in the file that it names, if any (reference_types.cpp).
void readReference(const NamedFile* file, Scenario& scenario, Reading& reading);

/// Finds the cells that division rules call by names (division_types.cpp).
void readRuleCells(Scenario& scenario, Reading& reading);

/// Reads the colours of cells that are called by names or paths.
void readCellColours(Scenario& scenario, Reading& reading);

/// Reads the entries of `record.measures` (record_types.cpp).
void readRecordMeasures(Scenario& scenario, Reading& reading);

/// Reads the entries of `stop.when` (stop_types.cpp).
void readStopWhen(Scenario& scenario, Reading& reading);
/// Returns a condition for people, with the names of cells: "{touch: [cell ABa, cell P2]}".
std::string stopText(const StopWhen& when, const CellNames& names);

/// Reads the entries of `experiments` (experiment_types.cpp).
void readExperiments(Scenario& scenario, Reading& reading);

}  // namespace morula::scenario
