#pragma once
// JSON: nlohmann_json, with members in the order in which they were added. What programs may have been given by
// strangers is read by parseJson or tryParseJson.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace morula {

using Json = nlohmann::ordered_json;

/// Throws Json::exception where `text` is no JSON, or nested more than 32 deep as YAML may not be either: what writes,
/// copies or shows JSON calls itself for each level.
Json parseJson(std::string_view text);
/// Null where parseJson throws.
Json tryParseJson(std::string_view text);

template <class T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

enum class JsonCharacters { unicode, ascii };

/// JSON as text, on one line or with that indent. What is not UTF-8 in it, which JSON cannot hold, becomes U+FFFD.
std::string jsonText(const Json& json, int indent = -1, JsonCharacters characters = JsonCharacters::unicode);

}  // namespace morula
