// check.reference: contacts and positions to compare the organism with, in the scenario or in a file.
#include <algorithm>

#include "base/error.h"
#include "observation/measures.h"
#include "values/value_types.h"
#include "values/word_file.h"

namespace morula::scenario {
namespace {

constexpr const char* contactsAllowed = "a list of pairs of cells, by names or paths, as [[ABa, ABp], [ABa, EMS]]";
constexpr const char* positionsAllowed = "a map of cells, by names or paths, to centres, as {ABa: [1, 0, 0]}";
constexpr const char* lineAllowed = "needs a line 'contact CELL CELL' or 'position CELL X Y Z'";

/// Reads the parts once all else is read, since they call cells by name.
class ReferenceReader {
 public:
  ReferenceReader(Scenario& scenario, Reading& reading) : scenario_(scenario), reading_(reading) {}

  void readContacts(const Node& node) {
    const std::string path = "check.reference.contacts";
    if (!expectEntries(node, path, contactsAllowed, reading_.problems)) return;
    for (const Node& pair : node.items) {
      if (pair.kind != Node::Kind::sequence || pair.items.size() != 2) {
        if (pair.kind != Node::Kind::broken)
          reading_.problems.add(pair.place, path, "is not a pair of cells", std::string("needs ") + contactsAllowed);
        continue;
      }
      const auto one = readText(pair.items[0], path, "a cell", reading_.problems);
      const auto other = readText(pair.items[1], path, "a cell", reading_.problems);
      if (one && other) complain(pair.place, path, [&] { addContact(*one, *other); });
    }
  }

  void readPositions(const Node& node) {
    const std::string path = "check.reference.positions";
    if (node.kind != Node::Kind::map) return refuse(node, path, positionsAllowed, reading_.problems);
    for (const Member& member : node.members) {
      if (member.key.empty()) continue;
      const auto place =
          readTriple(member.value, {}, path + "." + member.key, "three numbers, as [1, 0, 0]", reading_.problems);
      if (place) complain(member.place, path + "." + member.key, [&] { addPosition(member.key, *place); });
    }
  }

  /// Reads lines 'contact CELL CELL' and 'position CELL X Y Z'; '#' begins a comment.
  void readFile(const std::string& text, const std::string& file, const Place& place) {
    for (const auto& [line, column, words] : readWordFile(text, file, place, reading_.problems)) try {
        addLine(words);
      } catch (const InputError& error) {
        reading_.problems.addForeign(place, file + ":" + std::to_string(line) + ":1: " + error.what());
      }
  }

 private:
  void addLine(const std::vector<std::string>& words) {
    if (words[0] == "contact" && words.size() == 3) return addContact(words[1], words[2]);
    if (words[0] != "position" || words.size() != 5) throw InputError(std::string("is not understood; ") + lineAllowed);
    double xyz[3];
    for (int i = 0; i < 3; ++i) {
      const std::string& word = words[2 + static_cast<std::size_t>(i)];
      const auto number = parseReal(word);
      if (!number.wrong.empty()) throw InputError("'" + word + "' " + number.wrong + "; " + lineAllowed);
      xyz[i] = number.value;
    }
    addPosition(words[1], {xyz[0], xyz[1], xyz[2]});
  }

  /// Calls `call` and reports its InputError at `place`.
  template <class Call>
  void complain(const Place& place, const std::string& path, Call call) {
    try {
      call();
    } catch (const InputError& error) { reading_.problems.add(place, path, error.what()); }
  }

  CellPath cell(const std::string& text) const { return cellCalled(scenario_.names, text, ""); }

  void addContact(const std::string& a, const std::string& b) {
    const auto [one, other] = std::minmax({cell(a), cell(b)});
    if (one == other || one.isAncestorOf(other))
      throw InputError("'" + a + "' and '" + b +
                       "' never live together; needs two cells of which neither descends from the other");
    if (!scenario_.check.reference->contacts.insert({one, other}).second)
      throw InputError("'" + a + "' and '" + b + "' are given twice; remove one");
  }

  void addPosition(const std::string& name, const Point& place) {
    if (!scenario_.check.reference->positions.emplace(cell(name), place).second)
      throw InputError("'" + name + "' has a place already; remove one");
  }

  Scenario& scenario_;
  Reading& reading_;
};

/// Writes a path so that it always means the path, whatever names a scenario gives.
std::string written(const CellPath& path) { return "/" + path.text(); }

Node& keep(std::optional<Node> ReferenceSource::*part, const Node& node, Reading& reading) {
  if (!reading.reference) reading.reference.emplace();
  return ((*reading.reference).*part).emplace(node);
}

}  // namespace

Parameter referenceContacts() {
  auto p =
      presented("check.reference.contacts", contactsAllowed, "none",
                "Pairs of cells that touch, for contact_jaccard and contact_f1: all contacts that their cells have "
                "among them");
  p.schema = {{"type", "array"}, {"items", listSchema({{"type", "string"}}, 2)}, {"minItems", 1}};
  p.read = [](Scenario&, const Node& node, Reading& reading) { keep(&ReferenceSource::contacts, node, reading); };
  p.write = [](const Scenario& s) {
    Json list = Json::array();
    for (const auto& [a, b] : s.check.reference->contacts) list.push_back({written(a), written(b)});
    return list.empty() ? Json() : list;
  };
  return p;
}

Parameter referencePositions() {
  auto p = presented("check.reference.positions", positionsAllowed, "none",
                     "Centres of at least three cells in any frame, for position_rmsd and position_shape_rmsd");
  p.schema = {{"type", "object"}, {"additionalProperties", listSchema({{"type", "number"}}, 3)}};
  p.read = [](Scenario&, const Node& node, Reading& reading) { keep(&ReferenceSource::positions, node, reading); };
  p.write = [](const Scenario& s) {
    Json map = Json::object();
    for (const auto& [path, place] : s.check.reference->positions) map[written(path)] = {place.x, place.y, place.z};
    return map.empty() ? Json() : map;
  };
  return p;
}

Parameter referenceFile() {
  auto p = presented("check.reference.file", "a file, relative to the scenario's folder", "none",
                     "More contacts and positions, one 'contact CELL CELL' or 'position CELL X Y Z' a line; '#' "
                     "begins a comment");
  p.schema = {{"type", "string"}, {"minLength", 1}};
  p.read = [path = p.path, allowed = p.allowed](Scenario&, const Node& node, Reading& reading) {
    if (readWords(node, path, allowed, reading.problems)) keep(&ReferenceSource::file, node, reading);
  };
  p.write = [](const Scenario&) { return Json(); };  // written as the two others
  return p;
}

void readReference(const NamedFile* file, Scenario& scenario, Reading& reading) {
  if (!reading.reference || !scenario.check.reference) return;
  ReferenceReader reader(scenario, reading);
  if (reading.reference->contacts) reader.readContacts(*reading.reference->contacts);
  if (reading.reference->positions) reader.readPositions(*reading.reference->positions);
  if (file) reader.readFile(file->content, file->path, reading.reference->file->place);
}

}  // namespace morula::scenario
