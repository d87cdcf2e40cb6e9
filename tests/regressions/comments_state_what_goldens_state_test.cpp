// Comments of scenarios and their goldens state the error of the settings; the two were written by hand, and
// both left out the mesh. What a comment says is what its golden says.
#include <cstdlib>
#include <filesystem>
#include <regex>

#include "catch.h"
#include "golden/accept.h"
#include "launch.h"

using namespace morula;
using test::readWhole;

namespace {

/// The comment at the head, its lines joined.
std::string head(const std::string& text) {
  std::string joined;
  for (std::size_t begin = 0; begin < text.size() && text[begin] == '#';) {
    const auto end = text.find('\n', begin);
    joined += text.substr(begin + 1, end - begin - 1);
    begin = end + 1;
  }
  return joined;
}

/// A comment is rounded to the two digits that it has.
bool isRounded(double comment, double golden) { return std::abs(comment - golden) <= 0.06 * golden; }

}  // namespace

TEST_CASE("The error that a scenario's comment states is its golden's") {
  const std::regex stated(
      R"(Error of these settings \(morula accuracy[^)]*\): (?:time ([0-9.e+-]+), mesh ([0-9.e+-]+|not known|none)|([0-9.e+-]+)), in radii of the egg, up to time ([0-9.]+)[,.; ])");
  std::size_t compared = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator("scenarios")) {
    if (entry.path().extension() != ".yaml") continue;
    if (entry.path().stem().extension() == ".study") continue;  // of many runs
    const auto file = goldenPath(entry.path());
    CAPTURE(entry.path().string());
    const std::string comment = head(readWhole(entry.path().string()));
    const bool states = comment.find("Error of these settings") != comment.npos;
    if (!std::filesystem::exists(file)) {
      CHECK_FALSE(states);
      continue;
    }
    const auto error = readGoldenFile(file).error;
    CHECK(states == error.has_value());
    if (!error || !states) continue;
    std::smatch match;
    REQUIRE(std::regex_search(comment, match, stated));
    CHECK(isRounded(std::stod(match[1].matched ? match[1] : match[3]), error->time));
    const double until = std::stod(match[4]);
    CHECK(std::abs(until - error->until) <= 0.006 * error->until);
    if (match[2].matched) {
      if (match[2] == "not known") CHECK_FALSE(error->mesh);
      else if (match[2] == "none") CHECK(error->mesh == 0);
      else {
        REQUIRE(error->mesh);
        CHECK(isRounded(std::stod(match[2]), *error->mesh));
      }
    } else {
      CHECK_FALSE(error->mesh);  // one that states the mesh is told in full
    }
    ++compared;
  }
  CHECK(compared > 40);
}
