// JSON as the rooms hold it, against the library that reads and writes it: what braces mean, numbers, texts, errors.
#include "system/json.h"

#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "catch.h"

using namespace morula;
using Library = nlohmann::ordered_json;

namespace {

/// The same braces, read as both types.
#define SAME_TEXT(...) CHECK(jsonText(Json __VA_ARGS__) == (Library __VA_ARGS__).dump())

const std::string everything =
    R"({"b":[1,-1,0.1,1e+300,18446744073709551615,-9223372036854775808],"a":{"ä":"\u0001\"\\","z":null},"n":[],"o":{},"t":[true,false]})";

}  // namespace

TEST_CASE("braces are members where each item is a text and a value, and a list otherwise") {
  SAME_TEXT(({{"name", "egg"}, {"cells", 4}, {"real", 0.5}, {"yes", true}}));
  SAME_TEXT(({1, 2.5, "three", nullptr}));
  SAME_TEXT(({{"inner", {{"list", {1, 2}}, {"one", {"x"}}}}}));
  SAME_TEXT(({{"a", 1}, {2, "b"}}));
  SAME_TEXT(({{"a", 1, 2}}));
  SAME_TEXT(({{"same", 1}, {"other", 2}, {"same", 3}}));
  SAME_TEXT((std::vector<std::vector<double>>{{1, 2}, {}}));
  SAME_TEXT((std::map<std::string, std::vector<int>>{{"b", {1}}, {"a", {}}}));
  const Json value = 3;
  CHECK(jsonText({{"list", {value}}}) == R"({"list":[3]})");
  CHECK(jsonText(Json::array({"axis", "plane"})) == R"(["axis","plane"])");
}

TEST_CASE("what is read and written again is the same text, as the library's") {
  CHECK(jsonText(Json::parse(everything)) == everything);
  CHECK(jsonText(Json::parse(everything), 2) == Library::parse(everything).dump(2));
  CHECK(jsonText("ä€😀", -1, JsonCharacters::ascii) == Library("ä€😀").dump(-1, ' ', true));
  CHECK(jsonText("a\xff") == "\"a\xef\xbf\xbd\"");
  for (const double number : {0.1, 1.0 / 3, 1e-320, -0.0, 1e22, std::numeric_limits<double>::max(), 1.0}) {
    CHECK(jsonText(number) == Library(number).dump());
    CHECK(Json::parse(jsonText(number)).get<double>() == number);
  }
  CHECK(jsonText(NAN) == "null");
  CHECK(jsonText(std::numeric_limits<std::uint64_t>::max()) == "18446744073709551615");
  CHECK(jsonText(std::numeric_limits<std::int64_t>::min()) == "-9223372036854775808");
}

TEST_CASE("values are read as what they are, and refused as anything else") {
  const Json json = Json::parse(everything);
  CHECK(json["b"].get<std::vector<double>>()[2] == 0.1);
  CHECK(json["b"][4].get<std::uint64_t>() == std::numeric_limits<std::uint64_t>::max());
  CHECK(json["b"][1].get<int>() == -1);
  CHECK((json["b"][4].is_number_unsigned() && !json["b"][1].is_number_unsigned() &&
         json["b"][2].is_number_float()));
  CHECK((json["a"]["z"].is_null() && json["t"][0].is_boolean() && json["t"][0].get<bool>()));
  CHECK_THROWS_AS(json.at("c"), Json::exception);
  CHECK_THROWS_AS(json["b"].at(6), Json::exception);
  CHECK_THROWS_AS(json["b"].get<double>(), Json::exception);
  CHECK_THROWS_AS(json["b"][0].get<std::string>(), Json::exception);
  CHECK_THROWS_AS(json["b"][0].get<bool>(), Json::exception);
  CHECK_THROWS_AS(json["t"][0].get<double>(), Json::exception);
  CHECK_THROWS_AS(json["t"].at("a"), Json::exception);
  for (const char* wrong : {"", "{", "[1,]", "{\"a\":1}x", "'a'", "\"\xff\""}) {
    CHECK_THROWS_AS(Json::parse(wrong), Json::exception);
    CHECK(Json::tryParse(wrong).is_null());
  }
}

TEST_CASE("numbers are the same where their values are; members are where their order is, too") {
  CHECK((Json(1) == Json(1u) && Json(1) == Json(1.0) && Json(1) != Json(2) && Json(1) != Json("1")));
  CHECK(Json(true) != Json(1));
  CHECK(Json{{"a", 1}, {"b", {1, 2}}} == Json::parse(R"({"a":1.0,"b":[1,2]})"));
  CHECK(Json{{"a", 1}, {"b", 2}} != Json{{"b", 2}, {"a", 1}});
}

TEST_CASE("members are added, replaced and taken out in their places") {
  Json json;
  CHECK((json.is_null() && json.empty() && json.items().empty() && json.begin() == json.end()));
  json["a"] = 1, json["b"]["c"] = 2, json["list"].push_back("x");
  json.update({{"a", 3}, {"d", nullptr}});
  CHECK(jsonText(json) == R"({"a":3,"b":{"c":2},"list":["x"],"d":null})");
  json.erase("b"), json.erase("none");
  json["list"].back() = {{"y", 1}};
  for (Json& item : json["list"]) item["z"] = 2;
  CHECK(jsonText(json) == R"({"a":3,"list":[{"y":1,"z":2}],"d":null})");
  CHECK((json.contains("d") && !json.contains("b") && !json["a"].contains("x")));
  CHECK((json.size() == 3 && json["a"].size() == 1 && json["list"][0].size() == 2));
  CHECK_THROWS_AS(json["a"]["x"], Json::exception);
  CHECK_THROWS_AS(json.push_back(1), Json::exception);
}
