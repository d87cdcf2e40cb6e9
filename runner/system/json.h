#pragma once
// JSON as all rooms of the runner write and read it: members stay in the order in which they were added.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace morula {

using Json = nlohmann::ordered_json;

template <class T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

/// JSON as text. What is not UTF-8 in it, which JSON cannot hold, becomes U+FFFD.
inline std::string jsonText(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace morula
