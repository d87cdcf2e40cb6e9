#pragma once
// JSON as all rooms of the runner hold it: members stay in the order in which they were added. The type is our own, with the
// names of nlohmann_json, which reads and writes it: a compiler takes half a second for that library in each file that sees it.
#include <array>
#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace morula {

class JsonItem;

class Json {
 public:
  using List = std::vector<Json>;
  using Members = std::vector<std::pair<std::string, Json>>;

  /// A text that is no JSON, or a value that is not what it is read as.
  struct exception : std::runtime_error {
    using std::runtime_error::runtime_error;
  };

  Json();  // null
  Json(std::nullptr_t) : Json() {}
  Json(const char* text);
  Json(std::string text);
  Json(std::string_view text);
  Json(std::same_as<bool> auto truth) { setTruth(truth); }
  Json(std::signed_integral auto number) { setInteger(number); }
  Json(std::unsigned_integral auto number) requires(!std::same_as<decltype(number), bool>) {
    setNatural(number);
  }
  Json(std::floating_point auto number) { setReal(number); }
  /// Members where each item is a list of a text and a value, as in {{"name", "egg"}, {"cells", 4}}; a list otherwise.
  Json(std::initializer_list<JsonItem> items);
  /// A list, or of a map the members.
  template <class Range>
  requires(requires(const Range& r) { r.begin() != r.end(); } && !std::derived_from<Range, Json> &&
           !std::convertible_to<const Range&, std::string_view> &&
           !std::convertible_to<const Range&, std::string>) Json(const Range& range) {
    if constexpr (requires { typename Range::mapped_type; }) {
      setMembers();
      for (const auto& [key, value] : range) (*this)[key] = Json(value);
    } else {
      setList();
      for (const auto& value : range) push_back(Json(value));
    }
  }

  Json(const Json&);
  Json(Json&&) noexcept;
  Json& operator=(const Json&);
  Json& operator=(Json&&) noexcept;
  ~Json();

  static Json array();
  static Json array(std::initializer_list<JsonItem> items);
  static Json object();

  /// Throws Json::exception where `text` is no JSON.
  static Json parse(std::string_view text);
  /// Null where `text` is no JSON.
  static Json tryParse(std::string_view text);

  bool is_null() const;
  bool is_boolean() const;
  bool is_number() const;
  bool is_number_float() const;
  bool is_number_unsigned() const;  // was read without a sign and a point, or made of such a type
  bool is_string() const;
  bool is_array() const;
  bool is_object() const;

  /// The value as that type; throws Json::exception where it is of another kind. A number becomes any type of numbers.
  template <class Value>
  Value get() const {
    Value value{};
    get_to(value);
    return value;
  }
  void get_to(bool& truth) const;
  void get_to(double& number) const;
  void get_to(std::string& text) const { text = this->text(); }
  void get_to(std::integral auto& number) const {
    number = static_cast<std::decay_t<decltype(number)>>(integer());
  }
  template <class Value>
  void get_to(std::vector<Value>& list) const {
    list.clear();
    for (const Json& item : this->list()) list.push_back(item.get<Value>());
  }
  template <class Value, std::size_t size>
  void get_to(std::array<Value, size>& list) const {
    for (std::size_t i = 0; i < size; ++i) at(i).get_to(list[i]);
  }
  const std::string& text() const;

  /// Of a list or members, how many; of null 0, of all else 1.
  std::size_t size() const;
  bool empty() const { return size() == 0; }

  bool contains(std::string_view key) const;
  /// The member or item; throws Json::exception where there is none.
  const Json& at(std::string_view key) const;
  const Json& at(std::size_t index) const;
  const Json& operator[](std::string_view key) const { return at(key); }
  const Json& operator[](std::size_t index) const { return at(index); }
  Json& operator[](std::size_t index) { return const_cast<Json&>(at(index)); }
  /// The member, which is added where there is none; null becomes members.
  Json& operator[](std::string_view key);
  void erase(std::string_view key);
  /// Takes over all members, those of the same key in their old places.
  void update(const Json& members);
  /// Null becomes a list.
  void push_back(Json item);
  Json& back();

  /// The items of a list; of null, none.
  List::const_iterator begin() const;
  List::const_iterator end() const;
  List::iterator begin();
  List::iterator end();
  /// The members; of null, none.
  const Members& items() const;

  /// Numbers are the same where their values are.
  friend bool operator==(const Json& a, const Json& b);

 private:
  void setTruth(bool truth);
  void setInteger(std::int64_t number);
  void setNatural(std::uint64_t number);
  void setReal(double number);
  void setList();
  void setMembers();
  std::int64_t integer() const;
  const List& list() const;

  std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string, List, Members> value_;
};

/// What may stand between braces: {x} is a list of x, also where x is JSON.
class JsonItem : public Json {
 public:
  using Json::Json;
  JsonItem(Json json) : Json(std::move(json)) {}
};

template <class T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

enum class JsonCharacters { unicode, ascii };

/// JSON as text, on one line or with that indent. What is not UTF-8 in it, which JSON cannot hold, becomes U+FFFD.
std::string jsonText(const Json& json, int indent = -1, JsonCharacters characters = JsonCharacters::unicode);

}  // namespace morula
