#include "values/units.h"

#include <utility>

#include "base/number_text.h"
#include "values/value_types.h"

namespace morula {

ShownUnit shownUnit(const Units& units, std::string_view unit) {
  const ShownUnit own{1, std::string(unit)};
  if (!units.any()) return own;
  ShownUnit shown;
  for (bool divides = false; !unit.empty();) {
    const std::size_t end = unit.find_first_of("/\xC2");  // · ² ³ begin with that byte
    const std::string_view part = unit.substr(0, end);
    unit.remove_prefix(part.size());
    int power = 1;
    for (const auto& [sign, n] : {std::pair<std::string_view, int>{"²", 2}, {"³", 3}})
      if (unit.starts_with(sign)) power = n, unit.remove_prefix(sign.size());
    const std::string& name = part == "length" ? units.length : units.time;
    if (part != "1" && ((part != "length" && part != "time") || name.empty())) return own;
    shown.name += part == "1" ? "1" : name + (power == 2 ? "²" : power == 3 ? "³" : "");
    for (int i = 0; i < power && part != "1"; ++i) {
      const double factor = part == "length" ? units.perLength : units.perTime;
      shown.factor = divides ? shown.factor / factor : shown.factor * factor;
    }
    if (unit.empty()) break;
    divides = divides || unit.front() == '/';
    const std::size_t sign = unit.front() == '/' ? 1 : 2;  // [byte]
    shown.name += unit.substr(0, sign);
    unit.remove_prefix(sign);
  }
  return shown;
}

std::string timeLabel(const Units& units) {
  return units.time.empty() ? "time" : shownUnit(units, "time").after("time");
}

std::string shownTime(const Units& units, double time, int digits) {
  const ShownUnit shown = shownUnit(units, "time");
  return numberText(time * shown.factor, digits) + (units.time.empty() ? "" : " " + shown.name);
}

namespace scenario {

Parameter unitName(std::string path, std::string meaning, Field<std::string> field) {
  Parameter p = presented(std::move(path), nameAllowed, "the scene's own", std::move(meaning));
  p.schema = {{"type", "string"}, {"minLength", 1}, {"maxLength", 40}};
  p.read = [field, path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    const auto value = readText(node, path, allowed, reading.problems);
    if (!value) return;
    if (isCellName(*value)) field(s) = *value;
    else reading.problems.add(node.place, path, describe(node) + " is no name of a unit", "needs " + allowed);
  };
  p.write = [field](const Scenario& s) {
    const auto& name = field(const_cast<Scenario&>(s));
    return name.empty() ? Json() : Json(name);
  };
  return p;
}

}  // namespace scenario

}  // namespace morula
