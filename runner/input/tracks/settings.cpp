#include "tracks/settings.h"

#include "base/number_text.h"
#include "files/text.h"
#include "scenario/scenario.h"
#include "tracks/wording.h"
#include "yaml/node.h"

namespace morula::tracks {
namespace {

using scenario::Node;

/// Returns a node in YAML's flow notation.
std::string flowText(const Node& node) {
  std::vector<std::string> parts;
  for (const Node& item : node.items) parts.push_back(flowText(item));
  for (const auto& member : node.members) parts.push_back(word(member.key) + ": " + flowText(member.value));
  switch (node.kind) {
    case Node::Kind::map: return flow(parts, '{', '}');
    case Node::Kind::sequence: return flow(parts, '[', ']');
    case Node::Kind::scalar: return node.isPlain() && isMadeOf(node.text, "-+_.") ? node.text : yamlText(node.text);
    default: return "null";
  }
}

/// Lines of a text, [begin, end).
struct Span {
  std::size_t begin, end;
};

std::size_t indentOf(const std::string& line) { return std::min(line.find_first_not_of(' '), line.size()); }

/// Finds the lines of a key that is indented by `indent`, among the lines of `where`. Empty, at their end: there is none.
Span spanOf(const std::string& key, std::size_t indent, const std::vector<std::string>& lines, const Span& where) {
  const std::string start = std::string(indent, ' ') + key + ":";
  Span found{where.begin, where.end};
  while (found.begin < where.end && !lines[found.begin].starts_with(start)) ++found.begin;
  if (found.begin == where.end) return found;
  found.end = found.begin + 1;
  const auto goesOn = [&](const std::string& line) {
    const std::size_t at = indentOf(line);
    return at > indent || (at < line.size() && (line[at] == ']' || line[at] == '}'));
  };
  while (found.end < where.end && !lines[found.end].empty() && goesOn(lines[found.end])) ++found.end;
  return found;
}

/// Writes a setting into the lines, as the tree has it.
void write(const Node& root, const std::string& path, std::vector<std::string>& lines) {
  const auto dot = std::min(path.find('.'), path.size());
  const std::string section = path.substr(0, dot);
  const auto* member = root.find(section);
  std::string key = section;
  Span at = spanOf(section, 0, lines, {0, lines.size()});
  std::size_t indent = 0;
  if (member && dot < path.size() && at.begin < at.end && lines[at.begin] == section + ":") {
    key = path.substr(dot + 1, std::min(path.find('.', dot + 1), path.size()) - dot - 1);
    indent = 2;
    member = member->value.find(key);
    at = spanOf(key, indent, lines, {at.begin + 1, at.end});
  }
  lines.erase(lines.begin() + static_cast<long>(at.begin), lines.begin() + static_cast<long>(at.end));
  if (member)
    lines.insert(lines.begin() + static_cast<long>(at.begin),
                 std::string(indent, ' ') + word(key) + ": " + flowText(member->value));
}

std::string quoted(const std::string& argument) {
  std::string text;
  for (const char c : argument) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return isMadeOf(argument, "-_.,=/µ") ? argument : "'" + text + "'";
}

std::string unit(const std::string& name, double factor) { return (factor == 1 ? "" : numberText(factor, 12)) + name; }

}  // namespace

std::string withSettings(const std::string& text, const std::vector<std::string>& settings,
                         scenario::Problems& problems) {
  if (settings.empty()) return text;
  const scenario::SourceText source(text, problems);
  Node root = readYaml(source, problems);
  std::vector<std::string> lines = linesOf(text);
  for (const std::string& setting : settings) {
    const Override change = parseOverride(setting);
    if (change.removes) remove(root, change.path);
    else assign(root, change.path, scenario::readYamlValue(change.value, change.place, problems));
    write(root, change.path, lines);
  }
  std::string result;
  for (const std::string& line : lines) result += line + "\n";
  return result;
}

std::string commandComment(const EmbryoOptions& options, const std::string& stem, const std::string& table) {
  std::vector<std::string> words{"morula init " + quoted(stem + ".yaml") + " --from " + quoted(table)};
  const auto add = [&](const std::string& option, const std::string& value) {
    words.push_back(option + " " + quoted(value));
  };
  const Units& units = options.units;
  if (!units.length.empty())
    add("--units", unit(units.length, units.perLength) + "," + unit(units.time, units.perTime));
  if (const auto& axes = options.shell)
    add("--shell", numberText((*axes)[0], 12) + "," + numberText((*axes)[1], 12) + "," + numberText((*axes)[2], 12));
  std::string columns;
  for (const auto& [name, header] : options.columns) columns += (columns.empty() ? "" : ",") + name + "=" + header;
  if (!columns.empty()) add("--columns", columns);
  if (!options.root.empty()) add("--root", options.root);
  if (options.areSpheres) add("--model", "sphere");
  if (options.perTime) add("--per-time", numberText(*options.perTime, 12));
  for (const std::string& setting : options.settings) add("--set", setting);
  std::string text;
  for (const std::string& one : words) text += (text.empty() ? "# " : " \\\n#   ") + one;
  return text + "\n";
}

}  // namespace morula::tracks
