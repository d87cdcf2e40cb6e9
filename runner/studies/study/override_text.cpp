#include "study/override_text.h"

#include <algorithm>

#include "system/json.h"

namespace morula {

using scenario::Node;

namespace {

/// JSON's strings are YAML's, too.
std::string jsonQuoted(const std::string& text) { return jsonText(Json(text)); }

/// Within brackets a text without quotes ends at these, and a text that begins so is something else.
bool staysPlain(const std::string& text) {
  constexpr std::string_view harmless = "_.+-/";
  return !text.empty() && std::ranges::all_of(text, [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           harmless.find(c) != harmless.npos;
  }) && text != "-";
}

std::string flow(const Node& node) {
  std::string text;
  switch (node.kind) {
    case Node::Kind::scalar: return node.isPlain() && staysPlain(node.text) ? node.text : jsonQuoted(node.text);
    case Node::Kind::sequence:
      for (const Node& item : node.items) text += (text.empty() ? "" : ", ") + flow(item);
      return "[" + text + "]";
    case Node::Kind::map:
      for (const auto& member : node.members)
        text += (text.empty() ? "" : ", ") + (staysPlain(member.key) ? member.key : jsonQuoted(member.key)) + ": " +
                flow(member.value);
      return "{" + text + "}";
    default: return "null";
  }
}

}  // namespace

std::string overrideText(const Node& node) {
  // Alone, a text without quotes reaches to the end, whatever it holds, unless it begins as something else does.
  if (node.isPlain() && !node.text.empty() && std::string_view("[{\"'").find(node.text[0]) == std::string_view::npos)
    return node.text;
  return flow(node);
}

}  // namespace morula
