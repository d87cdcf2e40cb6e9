// morula render and chart: what they draw, and what they refuse.
#include <filesystem>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
namespace fs = std::filesystem;

namespace {

/// Width and height that a PNG says it has.
std::pair<int, int> sidesOf(const std::string& png) {
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(png[at + i]);
    return value;
  };
  return {number(16), number(20)};
}

void refusesToDraw(std::vector<std::string> arguments, const std::string& words) {
  arguments.insert(arguments.begin(), "render");
  refuses(arguments, 2, words);
}

}  // namespace

TEST_CASE("whatever the environment asks of Mesa, a picture is the same") {
  const TemporaryFolder folder;
  const auto picture = [&](const Environment& environment) {
    const auto end =
        launch({"render", uniqueFour, "--time", "1.2", "--size", "64", "-o", folder / "a.png"}, environment);
    INFO(end.err);
    CHECK(end.code == 0);
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
  const auto picture = [&](std::vector<std::string> more) {
    std::vector<std::string> all{"render", uniqueFour, "--time", "1.2", "--size", "200x150", "-o", folder / "a.png"};
    all.insert(all.end(), more.begin(), more.end());
    const auto end = launch(all);
    INFO(end.err);
    REQUIRE(end.code == 0);
    const std::string png = readWhole(folder / "a.png");
    CHECK(sidesOf(png) == std::pair(200, 150));
    return png;
  };
  std::vector<std::string> seen{picture({})};
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{{"--view", "top"},
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
  REQUIRE(
      launch({"render", uniqueFour, "--time", "1.2", "--size", "100", "--turntable", "3", "-o", folder / "turn.png"})
          .code == 0);
  for (const char* name : {"turn-0000.png", "turn-0001.png", "turn-0002.png"}) CHECK(fs::exists(folder / name));
  CHECK(readWhole(folder / "turn-0000.png") != readWhole(folder / "turn-0001.png"));
  const auto end =
      launch({"render", uniqueFour, "--time", "1.2", "--size", "100", "--frames", "3", "-o", folder / "time.png"});
  REQUIRE(end.code == 0);
  CHECK(end.out.find("time-0002.png") != std::string::npos);
  CHECK(readWhole(folder / "time-0000.png") != readWhole(folder / "time-0002.png"));
  CHECK(!fs::exists(folder / "time-0003.png"));
  REQUIRE(launch({"render", uniqueFour, "--time", "1.2", "--size", "300", "--frames", "3", "--forces", "all", "-o",
                  folder / "force.png"})
              .code == 0);
  for (const char* number : {"1", "2"})
    CHECK(readWhole(folder / ("force-000" + std::string(number) + ".png")) !=
          readWhole(folder / ("time-000" + std::string(number) + ".png")));
}

TEST_CASE("render writes films where ffmpeg is, and says so where it is not") {
  const TemporaryFolder folder;
  const std::vector<std::string> film{"render", uniqueFour,    "--time", "0.5", "--size",
                                      "101",    "--turntable", "3",      "-o",  folder / "turn.mp4"};
  const auto without = launch(film, {{"PATH", folder / "nothing"}});
  CHECK(without.code == 2);
  CHECK(without.err.find("there is none in PATH; needs a name that ends in .png") != std::string::npos);
  const auto end = launch(film);
  if (end.code == 2) {
    WARN("no ffmpeg: films are not tried");
    return;
  }
  INFO(end.err);
  REQUIRE(end.code == 0);
  CHECK(readWhole(folder / "turn.mp4").substr(4, 4) == "ftyp");
  const std::string first = readWhole(folder / "turn.mp4");
  REQUIRE(launch(film).code == 0);  // a film may be replaced
  CHECK(readWhole(folder / "turn.mp4") == first);
  int names = 0;
  for (const auto& entry : fs::directory_iterator(folder.path()))
    names += entry.is_regular_file() || entry.is_directory();
  CHECK(names == 1);  // the single pictures are gone
}

TEST_CASE("render refuses what it cannot draw, by the option's name") {
  refusesToDraw({uniqueFour, "-o", "x.gif"}, "needs --turntable N or --frames N");
  refusesToDraw({uniqueFour, "-o", "x.svg"}, "needs a name that ends in .png");
  refusesToDraw({uniqueFour, "--view", "upside"}, "--view: 'upside' is no view; needs front, back");
  refusesToDraw({uniqueFour, "--view", "10,100"}, "-90 to 90");
  refusesToDraw({uniqueFour, "--size", "100x"}, "--size");
  refusesToDraw({uniqueFour, "--size", "100x100x100"}, "WIDTHxHEIGHT");
  refusesToDraw({uniqueFour, "--supersample", "5"}, "--supersample: 5 is out of range");
  refusesToDraw({uniqueFour, "--clip", "1,2,3"}, "--clip: '1,2,3' is no plane");
  refusesToDraw({uniqueFour, "--clip", "0,0,0,1"}, "is no plane");
  refusesToDraw({uniqueFour, "--clip", "a,0,0,1"}, "is no plane");
  refusesToDraw({uniqueFour, "--opacity", "1.5"}, "--opacity");
  refusesToDraw({uniqueFour, "--opacity", "=0.5"}, "--opacity");
  refusesToDraw({uniqueFour, "--forces", "sprin"}, "did you mean spring?");
  refusesToDraw({uniqueFour, "--colour", "volum"}, "did you mean volume?");
  refusesToDraw({uniqueFour, "--labels", "both"}, "--labels: 'both' is not known; needs none, name or path");
  refusesToDraw({uniqueFour, "--turntable", "1"}, "--turntable");
  refusesToDraw({uniqueFour, "--turntable", "3", "--frames", "3"}, "--turntable and --frames: give one of them");
  for (const char* option : {"--clip", "--labels", "--turntable", "--beside"})
    refusesToDraw({uniqueFour, "--style", "lineage", option, "3"},
                  std::string("--style lineage and ") + option + ": give one of them");
  refusesToDraw({uniqueFour, "--style", "lineage", "--axes"}, "--style lineage and --axes: give one of them");
  refusesToDraw({uniqueFour, "--fps", "10"}, "--fps is of a film");
  refusesToDraw({uniqueFour, "--fps", "0.001", "--frames", "3", "-o", "x.gif"}, "--fps: 0.001 is out of range");
  refusesToDraw({uniqueFour, "--size", "8192x8192"},
                "--size: 8192x8192 pixels with --supersample 2 take too much memory");
  refusesToDraw({uniqueFour, "--time", "0.1", "--opacity", "a*=0.5,zz=0.3"}, "--opacity: no cell in the picture");
  refusesToDraw({uniqueFour, "--connections"}, "--connections: no cells of unique-four connect");
  refusesToDraw({uniqueFour, "--beside", uniqueFour, "--style", "both"}, "--beside");
}

TEST_CASE("two runs stand side by side with the distance of their surfaces") {
  const TemporaryFolder folder;
  const auto end =
      launch({"render", uniqueFour, "--time", "1.2", "--size", "150", "--beside", uniqueFour, "-o", folder / "a.png"});
  INFO(end.err);
  REQUIRE(end.code == 0);
  CHECK(sidesOf(readWhole(folder / "a.png")).first == 3 * (150 + 8) + 8);
  CHECK(launch({"render", uniqueFour, "--beside", "scenarios/worm/four-cell.yaml", "--time", "2.3"}).code == 3);
}

TEST_CASE("chart draws measures over time, contacts and divisions of a stored run") {
  const TemporaryFolder folder;
  REQUIRE(launch({"run", uniqueFour, "--db", folder / "four.db", "--no-pictures"}).code == 0);
  for (const char* what : {"cells", "cell.volume", "pair.area", "contacts", "divisions"}) {
    const auto end = launch({"chart", folder / "four.db", what, "-o", folder / "a.svg"});
    CAPTURE(what, end.err);
    REQUIRE(end.code == 0);
    CHECK(readWhole(folder / "a.svg").starts_with("<?xml"));
  }
  const auto wrong = launch({"chart", folder / "four.db", "volum"});
  CHECK(wrong.code == 2);
  CHECK(wrong.err.find("did you mean volume?") != std::string::npos);
  const auto none = launch({"chart", folder / "four.db", "extent_1", "-o", folder / "b.svg"});
  CHECK(none.code == 3);
  CHECK(none.err.find("record.measures must name it") != std::string::npos);
  const auto bodiless = launch({"chart", "scenarios/thesis/elegans-1024.yaml", "divisions", "-o", folder / "c.svg"});
  CHECK(bodiless.code == 3);
  CHECK(launch({"lineage", folder / "four.db", "--colour", "volume", "--labels", "-o", folder / "tree.svg"}).code == 0);
  CHECK(launch({"lineage", folder / "four.db", "--colour", "volume"}).code == 2);
}
