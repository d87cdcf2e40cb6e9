#include "scenes_by_chance.h"

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

#include "base/error.h"
#include "base/number_text.h"
#include "scenario/parameter_table.h"

namespace morula::chance {

using scenario::Parameter, scenario::parameterTable, scenario::Section;

namespace {

const std::string head = "morula: 1\nname: random\n";
const std::string divides = "dna: |\n  START: a\n  g1(a|a)\n  g2(divide|a)\n";
const std::string unlike =
    "dna: |\n  START: a\n  g1(b|a)\n  g2(divide|a)\n  g3(c|b, A)\n  g4(a|b, B)\n  g5(divide|b)\n  g6(c|c)\n";
const std::string mesh = "  mesh: {icosphere: 1}\n";

/// Small scenes that run well and together use all features; keys that are not given have their defaults.
const std::vector<std::string> bases = {
    // Four to sixteen shells in a sphere
    head + divides + "stop: {time: 3.9}\nphysics:\n  drag: 1\n  shell: {sphere: 1.2}\n  contact: {}\n" + mesh,
    // Free, with viscosity, unlike cells and random planes
    head + unlike + "stop: {time: 3.5}\nphysics:\n  drag: 0.5\n  contact: {viscosity: 0.3}\n" + mesh +
        "division: {plane: random}\n",
    // Without contact, the thesis' way
    head + unlike + "stop: {time: 2.5}\nphysics:\n  integrator: thesis-verlet\n" + mesh,
    // Balls in an ellipsoid
    head + divides +
        "stop: {time: 3.9}\nphysics:\n  drag: 2\n  cell: {model: sphere, radius: 0.9}\n  shell: {ellipsoid: [1.4, 1, "
        "1]}\n  contact: {}\ndivision: {plane: random}\n",
    // From rest to rest
    head + divides +
        "stop: {time: 2.9}\nphysics:\n  integrator: quasi-static\n  shell: {sphere: 1.2}\n"
        "  contact: {adhesion: 0.3}\n" +
        mesh,
    head + divides + "stop: {time: 2.9}\nphysics:\n  drag: 1\n  cell: {model: shape-matching}\n  contact: {}\n" + mesh,
    // Rules, names and growth
    head + "dna: |\n  START: a\n  g1(b|a, A)\n  g2(c|a, B)\n  g3(divide|a)\n  g4(a|b)\n  g5(c|c)\n  g6(grow|c)\n" +
        "stop: {time: 4.5}\nphysics:\n  drag: 2\n  growth: {rate: 0.2, until: 2}\n  contact: {}\n" + mesh +
        "division: {rules: [{of: a, axis: [1, 0.2, 0], share: 0.6}]}\nnames: {egg: P0, daughters: [l, r]}\n"
        "cycle: {per-substance: {b: 0.5}}\n",
    head + "dna: |\n  START: a, grow\n  g1(a|a)\n  g2(divide|a)\n  g3(grow|a)\n" +
        "stop: {time: 3}\ncycle: {length: 0.5}\nphysics:\n  drag: 1\n  growth: {rate: 0.5}\n  contact: {}\n" + mesh +
        "division: {size: {sizer: 1.2}}\n",
    // Closed: cells that fly at each other, and nothing is taken from them
    head + "dna: |\n  START: a\n  g1(a|a)\nstop: {time: 1.5}\nphysics:\n" + mesh +
        "  membrane: {damping: 0}\n  contact: {damping: 0}\ncells:\n  - {at: [-1.3, 0, 0], velocity: [0.8, 0, 0]}\n"
        "  - {at: [1.3, 0.4, 0], velocity: [-0.8, 0, 0]}\n  - {at: [0, 2, 0.3], scale: 0.7, velocity: [0, -1, 0]}\n",
    // Cells of two kinds that stick
    head + "dna: |\n  START: a\n  g1(a|a)\n  g2(b|b)\nstop: {time: 2}\nphysics:\n  drag: 2\n" + mesh +
        "  contact: {adhesion: {default: 0.3, pairs: [{of: [a, b], strength: 1}]}}\ncells:\n  - {at: [-1, 0, 0]}\n"
        "  - {at: [1, 0, 0], substances: [b]}\n  - {at: [0, 1.7, 0], substances: [b]}\n",
    // Connections, with springs and without
    head + "dna: |\n  START: a\n  g1(b|a)\n  g2(divide|a)\n  g3(a|b)\n  g4(connect|b)\n  g5(release|a, A)\n" +
        "stop: {time: 4.5}\nphysics:\n  drag: 1\n  contact: {}\n" + mesh +
        "connections: {make: both, on-division: both, release-age: 2, spring: {rest: 0.9}}\n",
    head + divides + "stop: {time: 3.5}\nphysics:\n  drag: 1\n  contact: {}\n" + mesh + "connections: {}\n",
    // Cells that crawl, and turn when they divide
    head + unlike + "stop: {time: 3.5}\nphysics:\n  drag: 5\n  motility: {speed: 0.2}\n  contact: {}\n" + mesh +
        "division: {plane: {polarity: [1, 2, 0]}, chirality: {angle: 30}}\n",
    // Cells that feel
    head + "dna: |\n  START: a\n  g1(a|a)\n  g2(divide|a, !b)\n  g3(c|b)\nstop: {time: 4}\ncycle: {length: 0.5}\n" +
        "physics:\n  drag: 1\n  shell: {sphere: 1.3}\n  contact: {}\n" + mesh +
        "senses: {b: {neighbours: {at-least: 4}}}\n",
    // Cells that die
    head +
        "dna: |\n  START: a\n  g1(a|a)\n  g2(divide|a)\n  g3(b|a, A)\n  g4(die|b, B)\nstop: {time: 5}\nphysics:\n"
        "  drag: 1\n  contact: {}\n" +
        mesh,
    head + divides +
        "stop: {time: 2.5}\nphysics:\n  integrator: xpbd\n  time_step: 0.0078125\n  drag: 1\n  contact: {}\n" + mesh,
    // Daughters with coarser meshes
    head + divides + "stop: {time: 1.2}\nphysics:\n  drag: 2\n  mesh: {icosphere: 3, coarsen: 0.4}\n  contact: {}\n",
    // Random variations by seed
    head + unlike +
        "seed: 5\nstop: {time: 3.2}\nphysics:\n  drag: 5\n  shell: {ellipsoid: [1.3, 1.1, 1.1]}\n  contact: {}\n" +
        mesh + "variation: {cycle: 0.1, share: 0.04, start: 0.05, tilt: 8}\n",
    // A closed shell around an egg that fills it, in single precision
    head + divides +
        "stop: {time: 3}\nphysics:\n  precision: single\n  drag: 2\n  shell: {ellipsoid: [2, 1, 1], fill: 0.7}\n"
        "  contact: {}\n" +
        mesh,
};

/// The folder that bases may name files in, and its meshes.
const std::string folder = MORULA_SOURCE_DIR "/scenarios/hard";
const std::vector<std::string> files = {"globe.obj", "lens.obj", "rod.obj"};
const std::vector<std::string> words = {"a", "b", "c", "a*", "A", "B"};

/// Rounds a number to three digits, as people write numbers.
double rounded(double value) { return std::stod(numberText(value, 3)); }

double drawReal(Draw& draw, const Json& schema, const Json& now) {
  const double infinity = INFINITY;
  const double least = schema.value("minimum", schema.value("exclusiveMinimum", -infinity)),
               most = schema.value("maximum", infinity);
  if (schema.contains("minimum") && draw.chance(0.05)) return least;
  if (schema.contains("maximum") && draw.chance(0.05)) return most;
  double middle = now.is_number() ? std::abs(now.get<double>()) : 1;
  if (middle == 0) middle = 1;
  if (std::isfinite(least) && std::isfinite(most) && draw.chance(0.5)) return rounded(draw.between(least, most));
  // Most values lie within a factor of four; one in twenty is far off.
  const double decades = draw.chance(0.05) ? 6 : draw.chance(0.3) ? 1.5 : 0.6;
  double value = middle * std::pow(10, draw.between(-decades, decades));
  if (least < 0 && draw.chance(0.5)) value = -value;
  return std::clamp(rounded(value), least, most);
}

Json drawValue(Draw& draw, const Json& schema, const Json& now);

Json drawMap(Draw& draw, const Json& schema, const Json& now) {
  Json map = Json::object();
  const Json required = schema.value("required", Json::array());
  const auto isRequired = [&](const std::string& key) {
    return std::ranges::find(required, Json(key)) != required.end();
  };
  const Json properties = schema.value("properties", Json::object());
  for (const auto& [key, value] : properties.items())
    if (isRequired(key) || draw.chance(0.4))
      map[key] = drawValue(draw, value, now.is_object() ? now.value(key, Json()) : Json());
  if (const Json others = schema.value("additionalProperties", Json()); others.is_object())
    for (std::uint64_t count = 1 + draw.bits() % 2; count > 0; --count)
      map[draw.one(words)] = drawValue(draw, others, {});
  return map;
}

/// Returns a value that the parameter's JSON schema allows. `now`: the present value or the default.
Json drawValue(Draw& draw, const Json& schema, const Json& now) {
  if (schema.contains("const")) return schema["const"];
  if (schema.contains("enum")) return draw.one(schema["enum"]);
  if (schema.contains("oneOf")) return drawValue(draw, draw.one(schema["oneOf"]), now);
  const std::string type = schema.value("type", "object");
  if (type == "boolean") return draw.chance(0.5);
  if (type == "number") return drawReal(draw, schema, now);
  if (type == "integer") return static_cast<std::int64_t>(drawReal(draw, schema, now));
  if (type == "string") {
    if (schema.value("pattern", "").starts_with("^#")) return "#4daf4a";
    return draw.one(words);
  }
  if (type == "array") {
    const std::uint64_t least = schema.value("minItems", 0),
                        most = std::min(schema.value("maxItems", least + 2), least + 2);
    Json list = Json::array();
    for (std::uint64_t count = least + draw.bits() % (most - least + 1); count > 0; --count)
      list.push_back(drawValue(draw, schema["items"], now.is_array() && !now.empty() ? now[0] : Json()));
    return list;
  }
  return drawMap(draw, schema, now);
}

Json drawDna(Draw& draw) {
  static const std::vector<std::string> makes = {"a",    "b",      "c",   "divide",  "divide",
                                                 "grow", "shrink", "die", "connect", "release"},
                                        reads = {"a", "b", "c"}, also = {"", "", ", A", ", B", ", !b"};
  std::string text = "START: a\ng0(a|a)\n";
  for (std::uint64_t gene = 1, genes = 2 + draw.bits() % 6; gene <= genes; ++gene)
    text += "g" + std::to_string(gene) + "(" + draw.one(makes) + "|" + draw.one(reads) + draw.one(also) + ")\n";
  return text;
}

/// Returns the JSON pointer of a key: "a.b" gives "/a/b".
Json::json_pointer placeOf(std::string path) {
  std::ranges::replace(path, '.', '/');
  return Json::json_pointer("/" + path);
}

const Json* find(const Json& scenario, const std::string& path) {
  const Json::json_pointer place = placeOf(path);
  return scenario.contains(place) ? &scenario[place] : nullptr;
}

Json drawParameter(Draw& draw, const Parameter& p, const Json& scenario) {
  static const Scenario defaults = scenario::allDefaults();
  if (p.path == "dna") return drawDna(draw);
  if (p.allowed.starts_with("a file")) return draw.one(files);
  const Json* now = find(scenario, p.path);
  return drawValue(draw, p.schema, now ? *now : p.write(defaults));
}

/// Returns the tree without the value at `place`.
Json without(Json tree, const Json::json_pointer& place) {
  Json& above = tree[place.parent_pointer()];
  if (above.is_array()) above.erase(std::stoul(place.back()));
  else above.erase(place.back());
  return tree;
}

/// Returns a base as a tree, without keys at their defaults.
Json treeOf(const std::string& text) {
  Json tree = parseJson(readScenario(text, sceneFile, folder).resolved);
  const Scenario defaults = scenario::allDefaults();
  for (const Parameter& p : parameterTable().parameters) {
    const Json* value = find(tree, p.path);
    if (value && !p.required && *value == p.write(defaults)) setKey(tree, p.path, nullptr);
  }
  for (auto section = parameterTable().sections.rbegin(); section != parameterTable().sections.rend(); ++section) {
    const Json* value = find(tree, section->path);
    if (value && value->empty() && !section->make) setKey(tree, section->path, nullptr);
  }
  return tree;
}

/// Returns the DNA without these lines, counted in the scenario's text.
std::string withoutLines(const Json& scenario, const std::set<int>& lines) {
  const std::string text = sceneText(scenario), before = text.substr(0, text.find("dna: |"));
  int line = static_cast<int>(std::ranges::count(before, '\n')) + 2;
  std::string kept;
  std::istringstream dna(scenario["dna"].get<std::string>());
  for (std::string gene; std::getline(dna, gene); ++line)
    if (!lines.contains(line)) kept += gene + "\n";
  return kept;
}

/// Removes the keys and genes that messages complain about. Returns true if it changed the scenario.
bool repair(Json& scenario, const std::string& messages) {
  static const std::regex complaint(R"(:(\d+):\d+: ([a-z][a-z_.-]*)[^\n]*)");
  bool changed = false;
  std::set<int> genes;
  for (std::sregex_iterator m(messages.begin(), messages.end(), complaint), end; m != end; ++m) {
    const std::string path = (*m)[2];
    const Parameter* p = parameterTable().parameter(path);
    if (path == "dna") genes.insert(std::stoi((*m)[1]));
    if ((p && p->required) || !find(scenario, path)) continue;
    setKey(scenario, path, nullptr);
    changed = true;
  }
  if (!genes.empty()) scenario["dna"] = withoutLines(scenario, genes);
  return changed || !genes.empty();
}

/// Limits the numbers of cells and vertices.
void keepSmall(Json& scenario) {
  constexpr int maxCells = 16, maxLevel = 1;
  const Json* cells = find(scenario, "stop.cells");
  setKey(scenario, "stop.cells", std::min(cells ? cells->get<std::int64_t>() : maxCells, std::int64_t{maxCells}));
  if (const Json* level = find(scenario, "physics.mesh.icosphere");
      level && *level > maxLevel && !find(scenario, "physics.mesh.coarsen"))
    setKey(scenario, "physics.mesh.icosphere", maxLevel);
}

}  // namespace

void setKey(Json& scenario, const std::string& path, const Json& value) {
  const Json::json_pointer place = placeOf(path);
  if (value.is_null()) {
    if (scenario.contains(place)) scenario = without(std::move(scenario), place);
    return;
  }
  Json& at = scenario[place.parent_pointer()];
  const std::size_t dot = path.rfind('.');
  const std::string above = path.substr(0, dot == path.npos ? 0 : dot);
  if (const Section* section = parameterTable().section(above);
      section && section->members == Section::Members::exactlyOne && at.is_object())
    for (const Parameter* other : parameterTable().parametersOf(above)) {
      const Parameter* own = parameterTable().parameter(path);
      if (own && own->needs.empty() && !own->joins && !own->beside && other != own && other->needs.empty() &&
          !other->joins && !other->beside)
        at.erase(other->key());
    }
  at[place.back()] = value;
}

Drawn drawScene(std::uint64_t seed) {
  static const std::vector<Json> trees = [] {
    std::vector<Json> all;
    for (const std::string& base : bases) all.push_back(treeOf(base));
    return all;
  }();
  Draw draw(seed);
  Drawn drawn{draw.one(trees), {}};
  setKey(drawn.scenario, "seed", seed % 1000);
  const auto& all = parameterTable().parameters;
  const auto set = [&](const Parameter& p, const Json& value) {
    setKey(drawn.scenario, p.path, value);
    drawn.keys.insert(p.path);
  };
  for (std::uint64_t count = 1 + draw.bits() % 5; count > 0;) {
    const Parameter& p = draw.one(all);
    // Most keys that change no result, such as formats, names, pictures and checks, are skipped.
    const bool matters = p.decides == scenario::Decides::results && !p.path.starts_with("check.");
    if (!matters && draw.chance(0.8)) continue;
    if (!p.parent().empty() && !find(drawn.scenario, p.parent()) && draw.chance(0.5)) continue;
    --count;
    const bool isGiven = find(drawn.scenario, p.path) != nullptr;
    set(p, isGiven && !p.required && draw.chance(0.2) ? Json() : drawParameter(draw, p, drawn.scenario));
    if (const Parameter* beside = parameterTable().parameter(p.parent() + "." + p.needs);
        beside && !p.needs.empty() && !find(drawn.scenario, beside->path))
      set(*beside, drawParameter(draw, *beside, drawn.scenario));
  }
  keepSmall(drawn.scenario);
  // One scene in ten is not repaired, so that it is refused.
  for (int turn = draw.chance(0.1) ? 6 : 0; turn < 6; ++turn) {
    try {
      readScene(sceneText(drawn.scenario));
      break;
    } catch (const InputError& e) {
      if (!repair(drawn.scenario, e.what())) break;
    }
  }
  std::erase_if(drawn.keys, [&](const std::string& key) { return !find(drawn.scenario, key); });
  return drawn;
}

std::string sceneText(const Json& scenario) {
  std::string text;
  for (const auto& [key, value] : scenario.items()) {
    text += key + ": ";
    if (key == "dna" && value.is_string()) {
      text += "|\n  ";
      std::string dna = value;
      if (dna.ends_with('\n')) dna.pop_back();
      for (const char c : dna) text += c == '\n' ? "\n  " : std::string(1, c);
      text += "\n";
    } else if (key == "physics" && value.is_object() && !value.empty()) {
      text += "\n";
      for (const auto& [inner, of] : value.items()) text += "  " + inner + ": " + jsonText(of) + "\n";
    } else {
      text += jsonText(value) + "\n";
    }
  }
  return text;
}

Scenario readScene(const std::string& text) { return readScenario(text, sceneFile, folder); }

namespace {

/// Collects all places in a tree, inner places after outer ones.
void collect(const Json& tree, const Json::json_pointer& at, std::vector<Json::json_pointer>& all) {
  if (!tree.is_structured()) return;
  for (const auto& [key, value] : tree.items()) {
    const auto here = tree.is_array() ? at / std::stoul(key) : at / key;
    all.push_back(here);
    collect(value, here, all);
  }
}

std::vector<Json::json_pointer> placesIn(const Json& tree) {
  std::vector<Json::json_pointer> all;
  collect(tree, Json::json_pointer(), all);
  return all;
}

/// Returns simpler replacements of a value, the simplest first.
std::vector<Json> simplerThan(const Json& value) {
  std::vector<Json> all;
  if (value.is_string()) {  // removes a gene
    const std::string text = value;
    for (std::size_t end = text.find('\n'); end != text.npos && end + 1 < text.size();) {
      const std::size_t next = std::min(text.find('\n', end + 1), text.size());
      all.push_back(text.substr(0, end) + text.substr(next));
      end = next;
    }
  }
  if (!value.is_number()) return all;
  const double number = value;
  for (const double simple : {1.0, std::stod(numberText(number, 1)), std::stod(numberText(number, 2))})
    if (simple != number && (simple == 1 ? std::abs(number) != 1 : true))
      all.push_back(value.is_number_integer() ? Json(static_cast<std::int64_t>(simple)) : Json(simple));
  return all;
}

}  // namespace

Json shrink(Json scenario, const std::function<bool(const Json&)>& fails) {
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (const auto& place : placesIn(scenario)) {
      if (!scenario.contains(place)) continue;
      std::vector<Json> tries{without(scenario, place)};
      for (const Json& simple : simplerThan(scenario[place])) (tries.emplace_back(scenario))[place] = simple;
      for (Json& attempt : tries) {
        if (!fails(attempt)) continue;
        scenario = std::move(attempt);
        smaller = true;
        break;
      }
    }
  }
  return scenario;
}

}  // namespace morula::chance
