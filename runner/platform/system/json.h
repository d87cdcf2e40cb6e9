#pragma once
// JSON: nlohmann_json, with members in the order in which they were added. JSON that may come from strangers is read by
// parseJson or tryParseJson.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace morula {

using Json = nlohmann::ordered_json;

/// Reads JSON. Throws Json::exception if `text` is no JSON or, like YAML, nested over 32 deep, since code that writes,
/// copies or shows JSON recurses for each level.
Json parseJson(std::string_view text);
/// Reads JSON; returns null if parseJson throws.
Json tryParseJson(std::string_view text);

template <class T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

enum class JsonCharacters { unicode, ascii };

/// Writes JSON on one line, or with `indent`. Bytes that are not UTF-8, which JSON cannot hold, become U+FFFD.
std::string jsonText(const Json& json, int indent = -1, JsonCharacters characters = JsonCharacters::unicode);

}  // namespace morula
