#include "system/json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace morula {

namespace {

using Library = nlohmann::ordered_json;

Json fromLibrary(const Library& from) {
  switch (from.type()) {
    case Library::value_t::boolean:
      return from.get<bool>();
    case Library::value_t::number_integer:
      return from.get<std::int64_t>();
    case Library::value_t::number_unsigned:
      return from.get<std::uint64_t>();
    case Library::value_t::number_float:
      return from.get<double>();
    case Library::value_t::string:
      return from.get_ref<const std::string&>();
    case Library::value_t::array: {
      Json list = Json::array();
      for (const Library& item : from) list.push_back(fromLibrary(item));
      return list;
    }
    case Library::value_t::object: {
      Json members = Json::object();
      for (const auto& [key, member] : from.items()) members[key] = fromLibrary(member);
      return members;
    }
    default:
      return {};  // null, and what was no JSON
  }
}

Library toLibrary(const Json& from) {
  if (from.is_null()) return nullptr;
  if (from.is_boolean()) return from.get<bool>();
  if (from.is_number_float()) return from.get<double>();
  if (from.is_number_unsigned()) return from.get<std::uint64_t>();
  if (from.is_number()) return from.get<std::int64_t>();
  if (from.is_string()) return from.text();
  if (from.is_array()) {
    Library list = Library::array();
    for (const Json& item : from) list.push_back(toLibrary(item));
    return list;
  }
  Library members = Library::object();
  for (const auto& [key, member] : from.items()) members.emplace(key, toLibrary(member));
  return members;
}

const char* kindOf(const Json& json) {
  return json.is_null()      ? "null"
         : json.is_boolean() ? "boolean"
         : json.is_number()  ? "number"
         : json.is_string()  ? "string"
         : json.is_array()   ? "array"
                             : "object";
}

[[noreturn]] void refuse(const Json& json, const char* wanted) {
  throw Json::exception(std::string("a value is of the type ") + kindOf(json) + ", and must be of the type " +
                        wanted);
}

template <class Members>
auto memberOf(Members& members, std::string_view key) {
  return std::find_if(members.begin(), members.end(),
                      [&](const auto& member) { return member.first == key; });
}

}  // namespace

Json::Json() : value_(nullptr) {}
Json::Json(const char* text) : value_(std::string(text)) {}
Json::Json(std::string text) : value_(std::move(text)) {}
Json::Json(std::string_view text) : value_(std::string(text)) {}
Json::Json(const Json&) = default;
Json::Json(Json&&) noexcept = default;
Json& Json::operator=(const Json&) = default;
Json& Json::operator=(Json&&) noexcept = default;
Json::~Json() = default;

Json::Json(std::initializer_list<JsonItem> items) {
  const bool members = std::all_of(items.begin(), items.end(), [](const Json& item) {
    return item.is_array() && item.size() == 2 && item[0].is_string();
  });
  if (!members) {
    value_ = List(items.begin(), items.end());
    return;
  }
  value_ = Members();
  for (const Json& item : items)
    if (!contains(item[0].text())) (*this)[item[0].text()] = item[1];
}

void Json::setTruth(bool truth) { value_ = truth; }
void Json::setInteger(std::int64_t number) { value_ = number; }
void Json::setNatural(std::uint64_t number) { value_ = number; }
void Json::setReal(double number) { value_ = number; }
void Json::setList() { value_ = List(); }
void Json::setMembers() { value_ = Members(); }

Json Json::array() { return array({}); }

Json Json::array(std::initializer_list<JsonItem> items) {
  Json json;
  json.value_ = List(items.begin(), items.end());
  return json;
}

Json Json::object() {
  Json json;
  json.setMembers();
  return json;
}

Json Json::parse(std::string_view text) {
  try {
    return fromLibrary(Library::parse(text.begin(), text.end()));
  } catch (const Library::exception& error) { throw exception(error.what()); }
}

Json Json::tryParse(std::string_view text) {
  return fromLibrary(Library::parse(text.begin(), text.end(), nullptr, false));
}

bool Json::is_null() const { return std::holds_alternative<std::nullptr_t>(value_); }
bool Json::is_boolean() const { return std::holds_alternative<bool>(value_); }
bool Json::is_number_float() const { return std::holds_alternative<double>(value_); }
bool Json::is_number_unsigned() const { return std::holds_alternative<std::uint64_t>(value_); }
bool Json::is_string() const { return std::holds_alternative<std::string>(value_); }
bool Json::is_array() const { return std::holds_alternative<List>(value_); }
bool Json::is_object() const { return std::holds_alternative<Members>(value_); }

bool Json::is_number() const {
  return is_number_float() || is_number_unsigned() || std::holds_alternative<std::int64_t>(value_);
}

void Json::get_to(bool& truth) const {
  if (!is_boolean()) refuse(*this, "boolean");
  truth = std::get<bool>(value_);
}

void Json::get_to(double& number) const {
  if (is_number_float()) number = std::get<double>(value_);
  else if (is_number_unsigned()) number = static_cast<double>(std::get<std::uint64_t>(value_));
  else number = static_cast<double>(integer());
}

std::int64_t Json::integer() const {
  if (!is_number()) refuse(*this, "number");
  if (is_number_float()) return static_cast<std::int64_t>(std::get<double>(value_));
  if (is_number_unsigned()) return static_cast<std::int64_t>(std::get<std::uint64_t>(value_));
  return std::get<std::int64_t>(value_);
}

const std::string& Json::text() const {
  if (!is_string()) refuse(*this, "string");
  return std::get<std::string>(value_);
}

const Json::List& Json::list() const {
  static List none;
  if (is_null()) return none;
  if (!is_array()) refuse(*this, "array");
  return std::get<List>(value_);
}

const Json::Members& Json::items() const {
  static const Members none;
  if (is_null()) return none;
  if (!is_object()) refuse(*this, "object");
  return std::get<Members>(value_);
}

std::size_t Json::size() const {
  if (is_object()) return items().size();
  return is_array() || is_null() ? list().size() : 1;
}

bool Json::contains(std::string_view key) const {
  return is_object() && memberOf(items(), key) != items().end();
}

const Json& Json::at(std::string_view key) const {
  if (!is_object()) refuse(*this, "object");
  const auto member = memberOf(items(), key);
  if (member == items().end()) throw exception("there is no member '" + std::string(key) + "'");
  return member->second;
}

const Json& Json::at(std::size_t index) const {
  if (index >= list().size()) throw exception("there is no item " + std::to_string(index));
  return list()[index];
}

Json& Json::operator[](std::string_view key) {
  if (is_null()) setMembers();
  if (!is_object()) refuse(*this, "object");
  auto& members = std::get<Members>(value_);
  const auto member = memberOf(members, key);
  if (member != members.end()) return member->second;
  return members.emplace_back(std::string(key), Json()).second;
}

void Json::erase(std::string_view key) {
  if (contains(key)) std::get<Members>(value_).erase(memberOf(items(), key));
}

void Json::update(const Json& members) {
  for (const auto& [key, member] : members.items()) (*this)[key] = member;
}

void Json::push_back(Json item) {
  if (is_null()) setList();
  if (!is_array()) refuse(*this, "array");
  std::get<List>(value_).push_back(std::move(item));
}

Json& Json::back() { return const_cast<Json&>(at(size() - 1)); }

Json::List::const_iterator Json::begin() const { return list().begin(); }
Json::List::const_iterator Json::end() const { return list().end(); }

Json::List::iterator Json::begin() { return const_cast<List&>(list()).begin(); }
Json::List::iterator Json::end() { return const_cast<List&>(list()).end(); }

bool operator==(const Json& a, const Json& b) {
  if (!a.is_number() || !b.is_number()) return a.value_ == b.value_;
  if (a.is_number_float() || b.is_number_float()) return a.get<double>() == b.get<double>();
  return a.integer() == b.integer();  // as the library compares them: without regard to the sign
}

std::string jsonText(const Json& json, int indent, JsonCharacters characters) {
  return toLibrary(json).dump(indent, ' ', characters == JsonCharacters::ascii,
                              Library::error_handler_t::replace);
}

}  // namespace morula
