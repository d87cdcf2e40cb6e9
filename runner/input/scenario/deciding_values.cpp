#include "scenario/deciding_values.h"

#include "scenario/loading.h"
#include "yaml/numbers.h"

namespace morula {
namespace {

constexpr std::size_t longestValue = 160;  // [character] max that people take in on one line
constexpr std::size_t longestList = 16;    // max items of a list that is given item by item

std::string oneLine(const Json& value) {
  if (value.is_number_float()) return exactText(value.get<double>());
  std::string inside;
  const auto append = [&](const std::string& item) { inside += (inside.empty() ? "" : ", ") + item; };
  if (value.is_object()) {
    for (const auto& [key, member] : value.items()) append(key + ": " + oneLine(member));
    return '{' + inside + '}';
  }
  if (value.is_array()) {
    for (const Json& item : value) append(oneLine(item));
    return '[' + inside + ']';
  }
  if (!value.is_string()) return jsonText(value);
  const std::string& text = value.get_ref<const std::string&>();
  const auto plain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-' || c == '_' ||
           c == '.';
  };
  const bool isWord = !text.empty() && std::all_of(text.begin(), text.end(), plain);
  return isWord ? text : jsonText(value, -1, JsonCharacters::ascii);
}

std::string digest(const std::string& text) {
  return std::to_string(text.size()) + " characters, hash " + Hasher().add(text).digest().text();
}

void add(const std::string& path, const Json& value, std::vector<std::pair<std::string, std::string>>& list) {
  if (value.is_object()) {
    for (const auto& [key, member] : value.items()) add(path.empty() ? key : path + '.' + key, member, list);
    if (value.empty()) list.emplace_back(path, "{}");
    return;
  }
  std::string text = oneLine(value);
  if (text.size() > longestValue && value.is_array() && value.size() <= longestList) {
    for (std::size_t i = 0; i < value.size(); ++i) add(path + '[' + std::to_string(i) + ']', value[i], list);
    return;
  }
  list.emplace_back(path, text.size() > longestValue ? digest(text) : std::move(text));
}

}  // namespace

std::vector<std::pair<std::string, std::string>> decidingValues(const Scenario& s) {
  std::vector<std::pair<std::string, std::string>> list;
  const Json meaning = scenario::resolveMeaning(s);
  if (!meaning.empty()) add("", meaning, list);
  for (const NamedFile& file : s.files)
    if (file.role == "mesh") list.emplace_back("physics.mesh.file.content", digest(file.content));
    else if (file.role == "shell") list.emplace_back("physics.shell.mesh.content", digest(file.content));
  return list;
}

}  // namespace morula
