// Kinds of values that checks have: bounds, and texts that a failure must name.
#include "values/value_types.h"

namespace morula::scenario {

Parameter optionalBounds(std::string path, std::string meaning, Field<std::optional<Bounds>> field) {
  Parameter p =
      presented(std::move(path), "two numbers ≥ 0, min and max, as [0.9, 1.1]", "not checked", std::move(meaning));
  p.schema = listSchema(numberSchema(notNegative), 2);
  p.read = [field, path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    const auto bounds = readReals(node, 2, notNegative, path, allowed, reading.problems);
    if (!bounds) return;
    const double least = bounds->front(), most = bounds->back();
    if (least <= most) field(s) = Bounds{least, most};
    else
      reading.problems.add(node.place, path, "min is above max",
                           "write [" + exactText(most) + ", " + exactText(least) + "]");
  };
  p.write = [field](const Scenario& s) {
    const auto& bounds = field(const_cast<Scenario&>(s));
    return bounds ? Json{bounds->least, bounds->most} : Json();
  };
  return p;
}

Parameter texts(std::string path, std::string meaning, Field<std::vector<std::string>> field) {
  Parameter p = presented(std::move(path), "a list of texts, as [physics.time_step, springs]", "the run must end well",
                          std::move(meaning));
  p.schema = {{"type", "array"}, {"items", {{"type", "string"}, {"minLength", 1}}}, {"minItems", 1}};
  p.read = [field, path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    if (!expectEntries(node, path, allowed, reading.problems)) return;
    for (const auto& item : node.items) {
      const auto value = readText(item, path, "a text", reading.problems);
      if (value && value->empty())
        reading.problems.add(item.place, path, "an empty text", "needs a text with letters, or remove it");
      else if (value) field(s).push_back(*value);
    }
  };
  p.write = [field](const Scenario& s) {
    const auto& values = field(const_cast<Scenario&>(s));
    return values.empty() ? Json() : Json(values);
  };
  return p;
}

Parameter saneEnd() {
  Parameter p =
      presented("check.sane", "false, with a key because; without this key: true",
                "the end must be sane: no cell is crushed, inside out, within another cell, out of its shell or out "
                "of sight",
                "Sanity of the end; false: this scene is about an end that is not sane, and the run still passes");
  p.schema = {{"type", "boolean"}};
  p.read = [path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    const auto value = readText(node, path, allowed, reading.problems);
    if (!value) return;
    if (*value == "true" || *value == "false") s.check.sane = *value == "true";
    else reading.problems.add(node.place, path, "is " + describe(node), "needs true or false");
  };
  p.write = [](const Scenario& s) { return s.check.sane ? Json() : Json(false); };
  return p;
}

Parameter becauseText() {
  Parameter p = presented("check.because", "a text", "the end must be sane",
                          "Reason why the end is not sane, for readers of the results");
  p.needs = "sane";
  p.schema = {{"type", "string"}, {"minLength", 1}};
  p.read = [path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    const auto value = readText(node, path, allowed, reading.problems);
    if (!value) return;
    if (value->empty()) reading.problems.add(node.place, path, "is empty", "give the reason why the end is not sane");
    else s.check.because = *value;
  };
  p.write = [](const Scenario& s) { return s.check.because.empty() ? Json() : Json(s.check.because); };
  return p;
}

}  // namespace morula::scenario
