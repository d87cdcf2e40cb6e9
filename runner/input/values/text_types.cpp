// Texts: free ones, names, files, words of a list.
#include <algorithm>

#include "base/did_you_mean.h"
#include "values/former_words.h"
#include "values/value_types.h"

namespace morula::scenario {
namespace {

bool isName(const std::string& text) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  };
  return !text.empty() && text.size() <= 100 && text[0] != '-' && std::all_of(text.begin(), text.end(), fits);
}

}  // namespace

std::optional<std::string> readText(const Node& node, const std::string& path, const std::string& allowed,
                                    Problems& problems) {
  if (node.kind == Node::Kind::scalar) return node.text;
  refuse(node, path, allowed, problems);
  return {};
}

std::optional<std::string> readWords(const Node& node, const std::string& path, const std::string& allowed,
                                     Problems& problems) {
  auto value = readText(node, path, allowed, problems);
  if (!value || !value->empty()) return value;
  problems.add(node.place, path, "is empty", "needs " + allowed);
  return {};
}

Parameter text(std::string path, std::string meaning, Field<std::string> field) {
  return ofField(
      {.path = std::move(path), .allowed = "a text", .meaning = std::move(meaning), .schema = {{"type", "string"}}},
      field, readText);
}

Parameter name(std::string path, std::string meaning, Field<std::string> field) {
  return ofField({.path = std::move(path),
                  .allowed = "a name made of letters, digits, '-' and '_', at most 100 of them",
                  .meaning = std::move(meaning),
                  .schema = {{"type", "string"}, {"pattern", "^[A-Za-z0-9_][A-Za-z0-9_-]{0,99}$"}}},
                 field, [](const Node& node, auto& path, auto& allowed, Problems& problems) {
                   auto value = readText(node, path, allowed, problems);
                   if (!value || isName(*value)) return value;
                   problems.add(node.place, path, describe(node) + " is not a name", "needs " + allowed);
                   return std::optional<std::string>();
                 });
}

Parameter optionalFile(std::string path, std::string meaning, Field<std::optional<std::string>> field) {
  return ofField({.path = std::move(path),
                  .allowed = "a file, relative to the scenario's folder",
                  .meaning = std::move(meaning),
                  .schema = {{"type", "string"}, {"minLength", 1}},
                  .absent = "none"},
                 field, readWords);
}

Parameter oneOf(std::string path, std::vector<std::string> names, std::string meaning,
                std::function<int(Scenario&)> get, std::function<void(Scenario&, int)> set) {
  Parameter p;
  p.path = std::move(path);
  for (const auto& name : names) p.allowed += (p.allowed.empty() ? "" : &name == &names.back() ? " or " : ", ") + name;
  p.meaning = std::move(meaning);
  p.schema = {{"enum", names}};
  p.read = [set, names, path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    const auto value = readText(node, path, allowed, reading.problems);
    if (!value) return;
    const auto found = std::find(names.begin(), names.end(), *value);
    if (found != names.end()) return set(s, static_cast<int>(found - names.begin()));
    if (const FormerWord* former = formerValue(path, *value))
      return reading.problems.add(node.place, path,
                                  describe(node) + " is " + std::string(former->now) +
                                      " now: " + std::string(former->reason),
                                  std::string(former->remedy));
    const auto near = closest(*value, names);
    reading.problems.add(node.place, path, describe(node) + " is not known here",
                         near.empty() ? "needs " + allowed : "did you mean " + near + "? Needs " + allowed);
  };
  p.write = [get, names](const Scenario& s) { return Json(names[get(const_cast<Scenario&>(s))]); };
  return p;
}

}  // namespace morula::scenario
