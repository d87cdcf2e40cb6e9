// JSON from outside, and records as JSON.
#include "system/json.h"

#include <limits>

#include "catch.h"
#include "system/json_record.h"

using namespace morula;

namespace morula {

struct Sent {
  std::string text;
  bool passed = true;
  std::uint64_t whole = 0;
  std::optional<std::uint64_t> step;
  std::optional<std::string> cell;
  std::optional<double> share;
  std::vector<Vector> places;
  std::vector<double> list;
  friend bool operator==(const Sent&, const Sent&) = default;
};
template <IsA<Sent> T>
void listFields(T& sent, auto&& field) {
  auto& [text, passed, whole, step, cell, share, places, list] = sent;
  field({"text"}, text);
  field({"passed"}, passed);
  field({"whole"}, whole);
  field({"step"}, step);
  field({"cell"}, cell);
  field({"share"}, share);
  field({"places"}, places);
  field({"list"}, list);
}

}  // namespace morula

TEST_CASE("what is no JSON is an error, or null") {
  for (const char* wrong : {"", "{", "[1,]", "{\"a\":1}x", "'a'", "\"\xff\""}) {
    CHECK_THROWS_AS(parseJson(wrong), Json::exception);
    CHECK(tryParseJson(wrong).is_null());
  }
  CHECK(jsonText(parseJson(R"({"b":[1,-1,0.1],"a":null})")) == R"({"b":[1,-1,0.1],"a":null})");
  CHECK(jsonText("a\xff") == "\"a\xef\xbf\xbd\"");
  CHECK(jsonText("ä", -1, JsonCharacters::ascii) == R"("\u00e4")");
}

TEST_CASE("JSON may be nested as deep as YAML, and no deeper") {
  const auto nested = [](int levels) {
    return std::string(std::size_t(levels), '[') + std::string(std::size_t(levels), ']');
  };
  CHECK(jsonText(parseJson(nested(32))) == nested(32));
  CHECK_THROWS_WITH(parseJson(nested(33)), ContainsSubstring("nested more than 32 deep"));
  CHECK(tryParseJson(nested(200'000)).is_null());
}

TEST_CASE("whole numbers are those that fit") {
  CHECK(wholeFrom<std::uint64_t>(parseJson("18446744073709551615")) == std::numeric_limits<std::uint64_t>::max());
  CHECK(wholeFrom<std::int64_t>(parseJson("-9223372036854775808")) == std::numeric_limits<std::int64_t>::min());
  CHECK(wholeFrom<int>(Json(2)) == 2);
  for (const char* wrong : {"1e300", "-1e300", "2.0", "3000000000", "-3000000000", "true", "null", "\"2\""})
    CHECK_THROWS_AS(wholeFrom<int>(parseJson(wrong)), Json::exception);
  CHECK_THROWS_AS(wholeFrom<std::uint64_t>(parseJson("-1")), Json::exception);
}

TEST_CASE("a record arrives as it was sent") {
  Sent sent{"a\nb", false, 7, 1ull << 63, "", 0.1, {{1, -0.0, 1e-320}, {3, 4, 5}}, {1.0 / 3}};
  CHECK(fromJson<Sent>(parseJson(jsonText(toJson(sent)))) == sent);
  CHECK(toJson(sent)["places"].size() == 6);
  sent.step.reset(), sent.cell.reset(), sent.share.reset();
  const Json json = toJson(sent);
  CHECK(fromJson<Sent>(json) == sent);
  for (const auto& [key, value] : json.items()) {
    CAPTURE(key);
    Json without = json;
    without.erase(key);
    CHECK_THROWS_AS(fromJson<Sent>(without), Json::exception);
    without[key] = Json::object();
    CHECK_THROWS_AS(fromJson<Sent>(without), Json::exception);
  }
  CHECK_THROWS_AS(fromJson<Sent>(Json("text")), Json::exception);
}
