// morula render and chart: their drawings and their refusals.
#include <filesystem>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
namespace fs = std::filesystem;

namespace {

/// Returns the width and height in a PNG's header.
std::pair<int, int> sidesOf(const std::string& png) {
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(png[at + i]);
    return value;
  };
  return {number(16), number(20)};
}

}  // namespace

TEST_CASE("whatever the environment asks of Mesa, a picture is the same") {
  const TemporaryFolder folder;
  const auto picture = [&](const Environment& environment) {
    succeeds({"render", uniqueFour, "--time", "1.2", "--size", "64", "-o", folder / "a.png"}, environment);
    return readWhole(folder / "a.png");
  };
  const std::string plain = picture({});
  for (const Environment& asked :
       {Environment{{"GALLIUM_DRIVER", "softpipe"}}, Environment{{"LP_NATIVE_VECTOR_WIDTH", "512"}},
        Environment{{"MESA_GL_VERSION_OVERRIDE", "3.0"}}, Environment{{"GALLIVM_PERF", "brilinear"}}}) {
    CAPTURE(asked.begin()->first);
    CHECK((picture(asked) == plain));
  }
}

TEST_CASE("render draws what it is asked for, in the size that it is asked for") {
  const TemporaryFolder folder;
  const auto picture = [&](const Words& more) {
    succeeds(joined({"render", uniqueFour, "--time", "1.2", "--size", "200x150", "-o", folder / "a.png"}, more));
    const std::string png = readWhole(folder / "a.png");
    CHECK(sidesOf(png) == std::pair(200, 150));
    return png;
  };
  Words seen{picture({})};
  for (const Words& more : {Words{"--view", "top"},
                            {"--view", "-90,0"},
                            {"--supersample", "3"},
                            {"--transparent"},
                            {"--clip", "-1,0,0,0"},
                            {"--colour", "volume"},
                            {"--colour", "clone:1"},
                            {"--labels", "path"},
                            {"--opacity", "0.4"},
                            {"--normals"},
                            {"--forces", "spring,pressure"},
                            {"--forces", "all"},
                            {"--axes"},
                            {"--scale-bar"},
                            {"--style", "wireframe"}}) {
    CAPTURE(more);
    const std::string png = picture(more);
    for (const auto& other : seen) CHECK(png != other);
    seen.push_back(png);
  }
}

TEST_CASE("render goes around and through time, as numbered pictures") {
  const TemporaryFolder folder;
  const auto draws = [&](const Words& more) { return succeeds(joined({"render", uniqueFour, "--time", "1.2"}, more)); };
  draws({"--size", "100", "--turntable", "3", "-o", folder / "turn.png"});
  for (const char* name : {"turn-0000.png", "turn-0001.png", "turn-0002.png"}) CHECK(fs::exists(folder / name));
  CHECK(readWhole(folder / "turn-0000.png") != readWhole(folder / "turn-0001.png"));
  CHECK_THAT(draws({"--size", "100", "--frames", "3", "-o", folder / "time.png"}).out,
             ContainsSubstring("time-0002.png"));
  CHECK(readWhole(folder / "time-0000.png") != readWhole(folder / "time-0002.png"));
  CHECK(!fs::exists(folder / "time-0003.png"));
  draws({"--size", "300", "--frames", "3", "--forces", "all", "-o", folder / "force.png"});
  for (const std::string end : {"-0001.png", "-0002.png"})
    CHECK(readWhole(folder / ("force" + end)) != readWhole(folder / ("time" + end)));
}

TEST_CASE("render writes films where ffmpeg is, and says so where it is not") {
  const TemporaryFolder folder;
  const Words film{"render", uniqueFour,    "--time", "0.5", "--size",
                   "101",    "--turntable", "3",      "-o",  folder / "turn.mp4"};
  refuses(launch(film, {{"PATH", folder / "nothing"}}), 2, "PATH does not have it; needs a name that ends in .png");
  const auto end = launch(film);
  if (end.code == 2) {
    WARN("no ffmpeg: films are not tried");
    return;
  }
  INFO(end.err);
  REQUIRE(end.code == 0);
  CHECK(readWhole(folder / "turn.mp4").substr(4, 4) == "ftyp");
  const std::string first = readWhole(folder / "turn.mp4");
  REQUIRE(launch(film).code == 0);  // render may replace its own film
  CHECK(readWhole(folder / "turn.mp4") == first);
  int names = 0;
  for (const auto& entry : fs::directory_iterator(folder.path()))
    names += entry.is_regular_file() || entry.is_directory();
  CHECK(names == 1);  // the single pictures were removed
}

TEST_CASE("two runs stand side by side with the distance of their surfaces") {
  const TemporaryFolder folder;
  succeeds({"render", uniqueFour, "--time", "1.2", "--size", "150", "--beside", uniqueFour, "-o", folder / "a.png"});
  CHECK(sidesOf(readWhole(folder / "a.png")).first == 3 * (150 + 8) + 8);
  const auto other = succeeds({"render", uniqueFour, "--beside", "scenarios/worm/four-cell.yaml", "--time", "2.3",
                               "--size", "150", "-o", folder / "b.png"});
  CHECK_THAT(other.err, ContainsSubstring("only in the"));  // cells that the other has not
  CHECK(sidesOf(readWhole(folder / "b.png")).first == 3 * (150 + 8) + 8);
}

TEST_CASE("chart draws measures over time, contacts and divisions of a stored run") {
  const TemporaryFolder folder;
  succeeds({"run", uniqueFour, "--db", folder / "four.db", "--no-pictures"});
  for (const char* what : {"cells", "cell.volume", "pair.area", "contacts", "divisions"}) {
    succeeds({"chart", folder / "four.db", what, "-o", folder / "a.svg"});
    CHECK(readWhole(folder / "a.svg").starts_with("<?xml"));
  }
  refuses({"chart", folder / "four.db", "volum"}, 2, "did you mean volume?");
  refuses({"chart", folder / "four.db", "extent_1", "-o", folder / "b.svg"}, 3, "name it in record.measures");
  CHECK(launch({"lineage", folder / "four.db", "--colour", "volume", "--labels", "-o", folder / "tree.svg"}).code == 0);
}
