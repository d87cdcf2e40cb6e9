#include "system/json.h"

namespace morula {
namespace {

constexpr int maxDepth = 32;

}  // namespace

Json parseJson(std::string_view text) {
  using Event = Json::parse_event_t;
  return Json::parse(text, [](int depth, Event event, Json&) {  // depth: number of lists and objects around the value
    if (depth >= maxDepth && (event == Event::object_start || event == Event::array_start))
      throw Json::other_error::create(501, "lists and objects are nested more than 32 deep", nullptr);
    return true;
  });
}

Json tryParseJson(std::string_view text) {
  try {
    return parseJson(text);
  } catch (const Json::exception&) { return {}; }
}

std::string jsonText(const Json& json, int indent, JsonCharacters characters) {
  return json.dump(indent, ' ', characters == JsonCharacters::ascii, Json::error_handler_t::replace);
}

}  // namespace morula
