#pragma once
// The kinds of values that parameters have. Each function makes a Parameter that reads, writes and describes one field.
#include "base/error.h"
#include "observation/asked_measure.h"
#include "values/parameter.h"
#include "yaml/numbers.h"

namespace morula::scenario {

template <class T>
using Field = T& (*)(Scenario&);

/// The largest whole number that SQLite and most other programs hold.
inline constexpr std::uint64_t largestNatural = 0x7FFFFFFFFFFFFFFF;

/// Makes a parameter of one field. `take(node, path, allowed, problems)` returns its value, or adds a problem and
/// returns none.
template <class T, class Take>
Parameter ofField(Parameter p, Field<T> field, Take take) {
  p.read = [field, take, path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    if (auto value = take(node, path, allowed, reading.problems)) field(s) = std::move(*value);
  };
  p.write = [field](const Scenario& s) {
    const T& value = field(const_cast<Scenario&>(s));
    if constexpr (requires { value.has_value(); }) return orNull(value);
    else return Json(value);
  };
  return p;
}

struct NaturalRange {
  std::uint64_t low = 0, high = largestNatural;
};

Parameter real(std::string path, std::string unit, Range range, std::string meaning, Field<double> field);
/// `absent`: what holds if the parameter is not given. `word`: a text that stands for absence, such as "auto"; or "".
Parameter optionalReal(std::string path, std::string unit, Range range, std::string word, std::string absent,
                       std::string meaning, Field<std::optional<double>> field);
Parameter natural(std::string path, NaturalRange range, std::string meaning, Field<std::uint64_t> field);
Parameter optionalNatural(std::string path, NaturalRange range, std::string absent, std::string meaning,
                          Field<std::optional<std::uint64_t>> field);
/// Parameters of free text of one line, and of names made of letters, digits, '-' and '_'.
Parameter text(std::string path, std::string meaning, Field<std::string> field);
Parameter name(std::string path, std::string meaning, Field<std::string> field);
Parameter optionalFile(std::string path, std::string meaning, Field<std::optional<std::string>> field);
Parameter timePerSubstance(std::string path, std::string meaning, Field<std::map<std::string, double>> field);
Parameter colours();

Parameter optionalBounds(std::string path, std::string meaning, Field<std::optional<Bounds>> field);
/// A list of texts; an empty list counts as not given.
Parameter texts(std::string path, std::string meaning, Field<std::vector<std::string>> field);

/// Makes a parameter whose value is one of several names; `get` and `set` use the name's index in the list.
Parameter oneOf(std::string path, std::vector<std::string> names, std::string meaning,
                std::function<int(Scenario&)> get, std::function<void(Scenario&, int)> set);
/// An enumeration, by its rows [base/choice.h].
template <class E>
Parameter choice(std::string path, Field<E> field) {
  std::vector<std::string> names;
  std::string meaning;
  for (const auto& row : choices<E>) {
    names.push_back(row.name);
    meaning += (meaning.empty() ? "" : "; ") + names.back() + ": " + row.meaning;
  }
  return oneOf(
      std::move(path), std::move(names), std::move(meaning),
      [field](Scenario& s) { return static_cast<int>(field(s)); },
      [field](Scenario& s, int value) { field(s) = choices<E>[value].value; });
}

// Parameters that are one of a kind.
Parameter dna();
Parameter timeStep();
/// A damping: a constant, or {ratio: ζ}.
Parameter damping(const char* path, const char* meaning, Field<Damping> field);
Parameter shellSphere();
Parameter shellEllipsoid();
Parameter shellMesh();
Parameter shellFill();
Parameter divisionSize();
Parameter divisionPlane();
/// The range of angles [degree]: more than a turn is probably a slip.
constexpr Range chiralAngle{-360, 360};
/// Reads {angle: 20, time: 0.5} of a rule.
std::optional<Chirality> readChirality(const Node& node, const std::string& path, Problems& problems);
Json writeChirality(const Chirality& chirality);
Json chiralitySchema();
Parameter divisionRules();
/// Describes the values of division.plane in words.
std::string planesAllowed(bool ofSpheres = false);
Parameter startCells();
Parameter experiments();
Parameter stopWhen();
Parameter adhesion();
Parameter makeConnections();
/// The section `senses`, and the tables that explain it.
Parameter senses();
std::string sensesAsMarkdown();
Parameter unitName(std::string path, std::string meaning, Field<std::string> field);
Parameter saneEnd();
Parameter nameOfEgg();
Parameter namesOfDaughters();
Parameter namesOfCells();
Parameter namesFile();
Parameter referenceContacts();
Parameter referencePositions();
Parameter referenceFile();
Parameter recordAtCells();
Parameter recordMeasures();
Parameter becauseText();

// Functions that the kinds of parameters share.
/// Makes a parameter that is no part of a scenario's meaning; its schema, `read` and `write` are still to be set.
Parameter presented(std::string path, std::string allowed, std::string absent, std::string meaning);
/// Returns the schema of a list of these measures; measures of cells may name some cells alone.
Json measuresSchema(const std::vector<AskedMeasure>& known);
/// Adds the error of readMeasure as a problem.
void addReadError(const Place& place, const std::string& path, const InputError& error, Problems& problems);

/// Adds the problem that the node is empty or of another kind than is allowed; nothing if the node could not be read,
/// which has been reported.
void refuse(const Node& node, const std::string& path, const std::string& allowed, Problems& problems);
/// Reads a map that has exactly one key, of `keys`; null and a problem otherwise.
const Member* readOnly(const Node& node, const std::string& path, const std::vector<std::string>& keys,
                       const std::string& allowed, Problems& problems);
/// Adds a problem for each key of a map that is not in `keys`.
void refuseUnknown(const Node& node, const std::string& path, const std::vector<std::string>& keys, Problems& problems);
/// Returns true for a list with an entry at least, and adds a problem for anything else.
bool expectEntries(const Node& node, const std::string& path, const std::string& allowed, Problems& problems);
std::string numberAllowed(const Range& range, const std::string& unit);
Json numberSchema(const Range& range);
/// Returns the schema of a list of `count` items.
Json listSchema(const Json& items, int count);
/// Returns the schema of a map with these members and no others; `required` must be there.
Json mapSchema(const Json& members, const std::vector<std::string>& required);
/// Returns the schema of a map with this one member.
Json onlySchema(const std::string& key, const Json& value);
std::optional<double> readReal(const Node& node, const Range& range, const std::string& path,
                               const std::string& allowed, Problems& problems);
/// Returns the number that a map has under this key, if any.
std::optional<double> readMember(const Node& map, const std::string& key, const Range& range, const std::string& unit,
                                 const std::string& path, Problems& problems);
std::optional<std::uint64_t> readNatural(const Node& node, const NaturalRange& range, const std::string& path,
                                         const std::string& allowed, Problems& problems);
/// Reads a list of `count` numbers.
std::optional<std::vector<double>> readReals(const Node& node, std::size_t count, const Range& range,
                                             const std::string& path, const std::string& allowed, Problems& problems);
std::optional<Vector> readTriple(const Node& node, const Range& range, const std::string& path,
                                 const std::string& allowed, Problems& problems);

/// Reads three numbers, not all 0.
std::optional<Vector> readAxis(const Node& node, const std::string& path, Problems& problems);

/// Reads a text, which may be quoted, and may look like a number.
std::optional<std::string> readText(const Node& node, const std::string& path, const std::string& allowed,
                                    Problems& problems);
/// Reads a text that is not empty.
std::optional<std::string> readWords(const Node& node, const std::string& path, const std::string& allowed,
                                     Problems& problems);

/// Reads a substance, or the beginning of some and '*'. The DNA's substances are checked later.
std::optional<std::string> readPattern(const Node& node, const std::string& path, Reading& reading);

}  // namespace morula::scenario
