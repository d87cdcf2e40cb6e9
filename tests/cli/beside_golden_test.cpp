// Pictures of differences from a golden, and of two pictures, as users ask for them.
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "drawing/drawing.h"
#include "drawing/png_file.h"
#include "launch.h"

using namespace morula::test;
namespace fs = std::filesystem;

namespace {

/// Returns true if a page contains the words. A page is too long for the message of a failed check.
bool has(const std::string& page, const std::string& words) { return page.find(words) != page.npos; }

const std::string pair =
    "morula: 1\nname: pair\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {time: 1.25}\n"
    "physics: {mesh: {icosphere: 1}, drag: 5, contact: {}}\n";

}  // namespace

TEST_CASE("a run that differs from its golden is drawn beside it, and one that does not takes the picture away") {
  const TemporaryFolder folder;
  const auto scenario = folder / "pair.yaml";
  writeWhole(scenario, pair);
  accept(scenario);
  const Words run{"run", scenario, "--out", folder.path(), "--quiet"};
  const fs::path results = fs::path(jsonOf(run).at("db")).parent_path();
  CHECK_FALSE(fs::exists(results / "golden.png"));

  writeWhole(scenario, replaced(pair, "drag: 5", "drag: 8"));
  CHECK(jsonOf(run, 1).at("pictures").back() == (results / "golden.png").string());
  CHECK(fs::exists(results / "golden.png"));
  writeWhole(scenario, pair);
  CHECK(launch(run).code == 0);
  CHECK_FALSE(fs::exists(results / "golden.png"));
}

TEST_CASE("a page of a failed check shows the golden's organism: from git, or else from its numbers") {
  const TemporaryFolder folder;
  std::string genes;  // more genes than a golden records verbatim
  for (int i = 0; i < 20; ++i) genes += "  h" + std::to_string(i) + "(p" + std::to_string(i) + "|a0,A)\n";
  const auto scenario = folder / "pair.yaml";
  writeWhole(scenario, replaced(pair, "stop:", genes + "stop:"));
  accept(scenario);
  const auto pageOf = [&](const std::string& text) {
    writeWhole(scenario, text);
    endsWith(1, {"check", scenario, "--reports", folder / "out", "--quiet"});
    return readWhole(folder / "out/report.html");
  };
  const std::string changed = replaced(replaced(pair, "stop:", genes + "  h20(die|A)\nstop:"), "drag: 5", "drag: 8");
  const std::string without = pageOf(changed);
  CHECK(has(without, "spheres with the accepted volumes"));
  CHECK(has(without, "git does not have these files"));

  writeWhole(scenario, replaced(pair, "stop:", genes + "stop:"));
  const auto git = [&](const std::string& words) {
    return std::system(
               ("git -C '" + folder.path() + "' -c user.name=tests -c user.email=tests " + words + " >/dev/null 2>&1")
                   .c_str()) == 0;
  };
  if (!git("init") || !git("add pair.yaml pair.golden") || !git("commit -m first")) {
    WARN("skipped: no git here");
    return;
  }
  CHECK(has(pageOf(changed), "the accepted state, from its scenario run again, bit for bit"));
  // Pictures also work after the change was committed: the golden's own commit has its scenario.
  REQUIRE(git("commit -a -m second"));
  CHECK(has(pageOf(changed), "the accepted state, from its scenario run again, bit for bit"));
}

TEST_CASE("render --compare tells how different two pictures look") {
  const TemporaryFolder folder;
  morula::Image image(60, 40, morula::paper);
  writeWhole(folder / "one.png", morula::pngFile(image));
  image.at(20, 10).r -= 1;
  writeWhole(folder / "rounded.png", morula::pngFile(image));
  for (int x = 10; x < 30; ++x) image.at(x, 20) = {0, 0, 0};
  writeWhole(folder / "other.png", morula::pngFile(image));
  writeWhole(folder / "small.png", morula::pngFile(morula::Image(30, 40, morula::paper)));

  CHECK(succeeds({"render", folder / "one.png", "--compare", folder / "one.png"}).out ==
        "the pictures have the same pixels\n");
  CHECK_THAT(succeeds({"render", folder / "one.png", "--compare", folder / "rounded.png"}).out,
             ContainsSubstring("the pictures look the same: at most") && ContainsSubstring("needs at most 2.3"));
  const auto json =
      jsonOf({"render", folder / "one.png", "--compare", folder / "other.png", "-o", folder / "map.png"}, 1);
  CHECK(json.at("passed") == false);
  CHECK(json.at("most") > json.at("threshold"));
  CHECK(json.at("y") == 20);
  CHECK(json.at("unequal_pixels") == 21);
  CHECK(readWhole(folder / "map.png").substr(1, 3) == "PNG");
  CHECK(jsonOf({"render", "--compare", folder / "one.png", folder / "other.png"}, 1).at("most") == json.at("most"));
  CHECK(succeeds({"render", folder / "one.png", "--compare", folder / "one.png", "-o", folder / "map.svg"}).out ==
        "the pictures have the same pixels\npicture  " + (folder / "map.svg") + "\n");

  const auto fails = [&](int code, const std::string& because, const Words& more) {
    refuses(joined({"render", folder / "one.png", "--compare"}, more), code, because);
  };
  fails(3, "60 x 40 and 30 x 40 pixels cannot be compared", {folder / "small.png"});
  fails(6, "No such file", {folder / "none.png"});
  fails(3, "not a PNG picture", {uniqueFour});
  fails(2, "--compare and --size: give only one of them", {folder / "other.png", "--size", "100"});
  fails(2, "--compare and --threads: give only one of them", {folder / "other.png", "--threads", "2"});
  fails(2, "needs a name that ends in .png, .svg or .pdf", {folder / "other.png", "-o", folder / "map.mp4"});
}
