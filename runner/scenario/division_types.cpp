// How cells divide: the plane, and the rules for some cells.
#include <algorithm>

#include "base/did_you_mean.h"
#include "scenario/value_types.h"

namespace morula::scenario {

namespace {

/// "a or b"; "a, b, or c".
std::string inWords(const std::vector<std::string>& choices) {
  std::string text;
  for (std::size_t i = 0; i < choices.size(); ++i)
    text += (i == 0 ? "" : i + 1 < choices.size() ? ", " : i > 1 ? ", or " : " or ") + choices[i];
  return text;
}

std::string spell(const DivisionPlaneKind& kind) {
  if (kind.takes == Takes::nothing) return kind.name;
  return std::string("{") + kind.name + (kind.takes == Takes::axis ? ": [x, y, z]}" : ": a0}");
}

Json axisSchema() {
  return {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 3}, {"maxItems", 3}};
}

Json planeSchema() {
  Json words = Json::array(), forms = Json::array();
  for (const DivisionPlaneKind& kind : divisionPlanes()) {
    if (kind.takes == Takes::nothing) words.push_back(kind.name);
    else
      forms.push_back(
          {{"type", "object"},
           {"properties", {{kind.name, kind.takes == Takes::axis ? axisSchema() : Json{{"type", "string"}}}}},
           {"required", {kind.name}},
           {"additionalProperties", false}});
  }
  forms.insert(forms.begin(), {{"enum", words}});
  return {{"oneOf", forms}};
}

std::optional<Vector> readAxis(const Node& node, const std::string& path, Problems& problems) {
  const auto axis = readTriple(node, {}, path, "three numbers, not all 0, as [1, 0, 0]", problems);
  if (!axis || *axis != Vector{}) return axis;
  problems.add(node.place, path, "has length 0", "needs at least one number other than 0");
  return {};
}

/// What stands behind the name of a plane that takes something.
std::optional<PlaneChoice> readTaken(const DivisionPlaneKind& kind, const Node& node, const std::string& path,
                                     Reading& reading) {
  PlaneChoice choice{.plane = kind.plane};
  if (kind.takes == Takes::axis) {
    const auto axis = readAxis(node, path, reading.problems);
    if (!axis) return {};
    choice.axis = *axis;
    return choice;
  }
  const auto name = readPattern(node, path, reading);
  if (!name) return {};
  choice.substance = *name;
  return choice;
}

std::optional<PlaneChoice> readPlane(const Node& node, const std::string& path, Reading& reading) {
  const std::string allowed = planesAllowed();
  std::vector<std::string> words, keys;
  for (const DivisionPlaneKind& kind : divisionPlanes()) {
    (kind.takes == Takes::nothing ? words : keys).push_back(kind.name);
    if (kind.takes == Takes::nothing && node.kind == Node::Kind::scalar && node.text == kind.name)
      return PlaneChoice{.plane = kind.plane};
  }
  if (node.kind == Node::Kind::map) {
    const Member* taken = readOnly(node, path, keys, allowed, reading.problems);
    if (!taken) return {};
    const auto& kind = *std::ranges::find(divisionPlanes(), taken->key, &DivisionPlaneKind::name);
    return readTaken(kind, taken->value, path + "." + taken->key, reading);
  }
  if (node.kind == Node::Kind::broken) return {};
  const auto near = node.kind == Node::Kind::scalar ? closest(node.text, words) : "";
  reading.problems.add(node.place, path,
                       node.kind == Node::Kind::null     ? "is empty"
                       : node.kind == Node::Kind::scalar ? describe(node) + " is not known here"
                                                         : "is " + describe(node),
                       near.empty() ? "needs " + allowed : "did you mean " + near + "? Needs " + allowed);
  return {};
}

Json writePlane(const PlaneChoice& choice) {
  const DivisionPlaneKind& kind = kindOf(choice.plane);
  if (kind.takes == Takes::nothing) return Json(kind.name);
  if (kind.takes == Takes::substance) return Json{{kind.name, choice.substance}};
  return Json{{kind.name, {choice.axis.x, choice.axis.y, choice.axis.z}}};
}

}  // namespace

std::string planesAllowed(bool ofSpheres) {
  std::vector<std::string> allowed;
  for (const DivisionPlaneKind& kind : divisionPlanes())
    if (!(ofSpheres && kind.needsShape)) allowed.push_back(spell(kind));
  return inWords(allowed);
}

Parameter divisionPlane() {
  Parameter p;
  p.path = "division.plane";
  p.allowed = planesAllowed();
  std::vector<std::string> meanings;
  for (const DivisionPlaneKind& kind : divisionPlanes())
    meanings.push_back(std::string(kind.meaning) + " (" + kind.name + ")");
  p.meaning = "Cells divide across " + inWords(meanings);
  p.schema = planeSchema();
  p.read = [path = p.path](Scenario& s, const Node& node, Reading& reading) {
    if (const auto choice = readPlane(node, path, reading)) s.scene.mechanics->division.otherwise = *choice;
  };
  p.write = [](const Scenario& s) { return writePlane(s.scene.mechanics->division.otherwise); };
  return p;
}

}  // namespace morula::scenario
