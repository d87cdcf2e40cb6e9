#include "organism/organism.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>
#include <thread>

#include "base/error.h"
#include "catch.h"
#include "drawing/annotations.h"
#include "drawing/palette.h"
#include "pictures.h"

namespace morula {

TEST_CASE("a red ball is red in the middle, and the paper shows in the corners", "[organism]") {
  const Image image = drawOrganism(picture({ball("", {0, 0, 0}, 1, red)}));
  REQUIRE(image.width == 120);
  REQUIRE(image.height == 120);
  REQUIRE(isReddish(centre(image)));
  for (const auto& [x, y] : {std::pair{0, 0}, {119, 0}, {0, 119}, {119, 119}}) REQUIRE(image.at(x, y) == paper);
}

TEST_CASE("a ball covers the disc that perspective says", "[organism]") {
  const Image image = drawOrganism(picture({ball("", {0, 0, 0}, 1, red)}, 400));
  // The silhouette of a unit ball at distance 10 has the tangent 1/√99; half the picture has 0.19.
  const double radius = 200 / 0.19 / std::sqrt(99.0);
  REQUIRE(double(countPixels(image, isInk)) == Approx(3.14159265 * radius * radius).epsilon(0.02));
}

TEST_CASE("a map on a cell needs a share of the scale for each vertex", "[organism]") {
  CellShape cell = ball("", {0, 0, 0}, 1, neutralGrey);
  cell.shares.assign(cell.vertices.size(), 0.5);
  CHECK_NOTHROW(drawOrganism(picture({cell})));
  cell.shares.back() = 1.5;
  CHECK_THROWS_AS(drawOrganism(picture({cell})), InputError);
  cell.shares.back() = std::nan("");
  CHECK_THROWS_AS(drawOrganism(picture({cell})), InputError);
  cell.shares.pop_back();
  CHECK_THROWS_AS(drawOrganism(picture({cell})), InputError);
}

TEST_CASE("within a face a map has the colour of the value there, and no steps", "[organism]") {
  // One large flat triangle, seen from the front, so that each place has the same light.
  const auto triangle = [](Colour colour) {
    CellShape cell{.path = "A", .vertices = {{-1.8, -1.6, 0}, {1.8, -1.6, 0}, {0, 1.8, 0}}, .colour = colour};
    cell.faces = {{0, 1, 2}};
    return cell;
  };
  CellShape map = triangle(neutralGrey);
  const auto field = [](double x, double y) { return 0.5 + 0.18 * x + 0.1 * y; };
  for (const Point& p : map.vertices) map.shares.push_back(field(p.x, p.y));
  for (const double opacity : {1.0, 0.5}) {
    map.opacity = opacity;
    const Image image = drawOrganism(picture({map}, 300));
    for (const auto& [x, y] : {std::pair{0.0, -0.5}, {-0.9, -1.2}, {0.8, -1.3}, {0.1, 0.9}}) {
      CellShape plain = triangle(scaleColour(field(x, y)));
      plain.opacity = opacity;
      const int px = int(150 + x * 150 / 1.9), py = int(150 - y * 150 / 1.9);
      const Colour seen = image.at(px, py), expected = drawOrganism(picture({plain}, 300)).at(px, py);
      INFO(x << ", " << y << " at opacity " << opacity);
      CHECK(apart(seen, expected) <= 2);  // a pixel is 0.0025 of the scale wide
    }
    // A face shows six tenths of the scale, and no step is larger than two pixels of it need.
    for (int x = 80; x < 220; ++x)
      CHECK(std::abs(brightness(image.at(x, 220)) - brightness(image.at(x + 1, 220))) <= 6);
  }
}

TEST_CASE("right is right and up is up", "[organism]") {
  const Image image = drawOrganism(picture({ball("A", {1, 0, 0}, 0.5, red), ball("B", {0, 1, 0}, 0.5, blue)}));
  REQUIRE(isReddish(image.at(60 + 31, 60)));
  REQUIRE(isBluish(image.at(60, 60 - 31)));
  REQUIRE(image.at(60 - 31, 60) == paper);
  REQUIRE(image.at(60, 60 + 31) == paper);
}

TEST_CASE("nearer cells hide farther ones, in whatever order they are given", "[organism]") {
  const CellShape nearer = ball("A", {0, 0, 0.8}, 0.6, blue), farther = ball("B", {0, 0, -0.8}, 1, red);
  for (const Style style : {Style::solid, Style::wireframe}) {
    const Image one = drawOrganism(picture({nearer, farther}), style);
    REQUIRE(one == drawOrganism(picture({farther, nearer}), style));
    if (style == Style::solid) {
      REQUIRE(isBluish(centre(one)));
      REQUIRE(isReddish(one.at(60 + 24, 60)));
    }
  }
}

TEST_CASE("the wireframe shows no hidden lines", "[organism]") {
  const CellShape front = ball("A", {0, 0, 0.5}, 1, red), hidden = ball("B", {0, 0, -1.6}, 1, blue);
  // The second ball is as large but farther away, so the first ball covers it whole.
  REQUIRE(drawOrganism(picture({front}), Style::wireframe) == drawOrganism(picture({front, hidden}), Style::wireframe));
}

TEST_CASE("the wireframe is lines on pale faces", "[organism]") {
  const Image image = drawOrganism(picture({ball("", {0, 0, 0}, 1.5, red)}, 500), Style::wireframe);
  const Image middle = part(image, 200, 200, 100, 100);
  REQUIRE(countPixels(middle, [](Colour c) { return c.g < 170; }) > 200);
  REQUIRE(countPixels(middle, [](Colour c) { return c.g >= 170; }) > 6000);
  REQUIRE(countPixels(middle, [](Colour c) { return c.g >= 200 && c.r < c.g; }) == 0);
}

TEST_CASE("two pictures of one thing are equal, whatever was drawn between them and on any thread", "[organism]") {
  OrganismPicture p = picture({ball("A", {-0.5, 0, 0}, 0.8, red), ball("B", {0.5, 0, 0}, 0.8, blue)});
  p.shell = Vector{1.4, 1.2, 1.2};
  p.title = "title";
  const Image first = drawOrganism(p);
  REQUIRE(drawOrganism(p) == first);
  drawOrganism(picture({ball("", {0, 0, 0}, 1, red)}, 64), Style::wireframe);
  REQUIRE(drawOrganism(p) == first);
  Image elsewhere;
  std::thread([&] { elsewhere = drawOrganism(p); }).join();
  REQUIRE(elsewhere == first);
  REQUIRE(std::string(std::getenv("LP_NATIVE_VECTOR_WIDTH")) == "128");  // equal on every x86-64
}

TEST_CASE("cells are parted by dark lines", "[organism]") {
  const Colour colour{200, 200, 60};
  const Image parted =
      drawOrganism(picture({ball("A", {-0.5, 0, 0}, 0.8, colour), ball("B", {0.5, 0, 0}, 0.8, colour)}));
  REQUIRE(brightness(centre(parted)) < 0.7 * brightness(parted.at(60 - 16, 60)));
}

TEST_CASE("light falls from the upper left, and creases between cells are darker", "[organism]") {
  const Image alone = drawOrganism(picture({ball("A", {-0.6, 0, 0}, 0.6, red)}));
  REQUIRE(brightness(alone.at(60 - 24, 60 - 6)) > brightness(alone.at(60 - 12, 60 + 10)));
  const Image pair = drawOrganism(picture({ball("A", {-0.6, 0, 0}, 0.6, red), ball("B", {0.6, 0, 0}, 0.6, red)}));
  REQUIRE(brightness(pair.at(60 - 3, 60)) < brightness(alone.at(60 - 3, 60)));
}

TEST_CASE("an arrow has a head at its end", "[organism]") {
  OrganismPicture p = picture({}, 300);
  p.lines = {{{-1, 0, 0}, {1, 0, 0}, {0, 0, 0}}};
  const auto inked = [](const Image& image, int from) { return countPixels(part(image, from, 0, 150, 300), isInk); };
  const Image line = drawOrganism(p);
  p.lines[0].arrow = true;
  const Image arrow = drawOrganism(p);
  CHECK(inked(arrow, 150) > inked(line, 150) + 15);
  CHECK(inked(arrow, 0) == inked(line, 0));
}

TEST_CASE("a shell is a faint rim that leaves cells their colour", "[organism]") {
  OrganismPicture p = picture({ball("", {0, 0, 0}, 0.5, red)});
  const Image bare = drawOrganism(p);
  p.shell = Vector{1.5, 1, 1};
  const Image shelled = drawOrganism(p);
  REQUIRE(isReddish(centre(shelled)));
  REQUIRE(std::abs(centre(shelled).r - centre(bare).r) < 30);
  const int end = int(60 + 60 / 1.9 * 1.5);  // end of the shell along x
  int darkest = brightness(paper);
  for (int x = end - 4; x <= end + 4; ++x) darkest = std::min(darkest, brightness(shelled.at(x, 60)));
  REQUIRE(darkest < brightness(paper) - 40);
  REQUIRE(shelled.at(end + 6, 60) == paper);
  REQUIRE(shelled.at(60, 119) == paper);
}

TEST_CASE("lines are seen before cells, and behind them only if they should be", "[organism]") {
  OrganismPicture p = picture({ball("", {0, 0, 0}, 1, red)});
  const Image bare = drawOrganism(p);
  p.lines = {{{-0.5, 0, -1.5}, {0.5, 0, -1.5}, {0, 0, 0}}};
  REQUIRE(drawOrganism(p) == bare);
  p.lines[0].throughCells = true;
  REQUIRE(brightness(centre(drawOrganism(p))) < brightness(centre(bare)) - 60);
  p.lines = {{{-0.5, 0, 1.5}, {0.5, 0, 1.5}, {0, 0, 0}}};
  REQUIRE(brightness(centre(drawOrganism(p))) < brightness(centre(bare)) - 60);
}

TEST_CASE("normals become lines from the vertices", "[organism]") {
  OrganismPicture p = picture({ball("", {0, 0, 0}, 1, red), ball("", {2, 0, 0}, 1, red)});
  addNormals(p, 0.25);
  REQUIRE(p.lines.size() == 2 * 162);
  for (std::size_t i = 0; i < 162; ++i) {
    REQUIRE(p.lines[i].from == p.cells[0].vertices[i]);
    REQUIRE(norm(p.lines[i].to) == Approx(1.25).margin(1e-3));
  }
}

TEST_CASE("an empty organism is paper, with its shell if it has one", "[organism]") {
  OrganismPicture p = picture({});
  const Image empty = drawOrganism(p);
  REQUIRE(countPixels(empty, isInk) == 0);
  p.camera.framing.reset();
  REQUIRE(drawOrganism(p) == empty);
  p.shell = Vector{1, 1, 1};
  REQUIRE(drawOrganism(p) != empty);
}

TEST_CASE("solid and wireframe stand side by side", "[organism]") {
  const OrganismPicture p = picture({ball("", {0, 0, 0}, 1, red)});
  const Image both = organismDrawing(p, {Style::solid, Style::wireframe}).pixels();
  REQUIRE(both.width == 240);
  Drawing joined(240, 120);
  joined.image(0, 0, drawOrganism(p, Style::solid));
  joined.image(120, 0, drawOrganism(p, Style::wireframe));
  REQUIRE(both == joined.pixels());
}

TEST_CASE("one framing holds a whole sequence", "[organism]") {
  OrganismPicture small = picture({ball("", {0, 0, 0}, 0.5, red)}), moved = picture({ball("", {4, 0, 0}, 1, red)});
  small.camera.framing.reset();
  moved.camera.framing.reset();
  const Framing both = fitFraming({small, moved});
  REQUIRE(both.distance > fitFraming(small).distance);
  REQUIRE(both.distance > fitFraming(moved).distance);
  REQUIRE(both.centre.x == Approx(2.25));
  const Framing asMade = fitFraming(2, [&](std::size_t i) { return i == 0 ? small : moved; });
  REQUIRE(asMade.distance == both.distance);
  REQUIRE(asMade.centre == both.centre);
  // With a shell, the shell alone counts, so cells may come and go.
  small.shell = moved.shell = Vector{2, 2, 2};
  REQUIRE(fitFraming(small).distance == fitFraming(moved).distance);
  REQUIRE_THROWS_AS(fitFraming(std::vector<OrganismPicture>{}), InputError);
}

TEST_CASE("words stay out of the scene", "[organism]") {
  OrganismPicture p = picture({ball("", {0, 0, 0}, 1, red)}, 300);
  p.title = "A title";
  p.caption = "and its caption";
  p.legend = {{red, "a4"}, {blue, "a5"}};
  const Image words = drawOrganism(p);
  p.title = "Another title";
  p.caption = "with another caption";
  p.legend = {{red, "x4"}, {blue, "y5"}};
  const Image others = drawOrganism(p);
  const Bands bands = bandsFor({p.title, p.caption, p.legend}, 300, 300);
  REQUIRE(bands.top + bands.bottom < 150);
  const int height = 300 - bands.top - bands.bottom;
  REQUIRE(part(words, 0, bands.top, 300, height) == part(others, 0, bands.top, 300, height));
  REQUIRE(isReddish(words.at(150, 155)));
}

// This test does not run by itself: test_unit_reports "[measure]" prints how long the largest pictures take.
TEST_CASE("4096 cells at 1920 x 1080", "[.][measure]") {
  OrganismPicture p = picture({}, 120);
  p.width = 1920, p.height = 1080;
  for (int i = 0; i < 4096; ++i)
    p.cells.push_back(ball("A", {0.1 * (i % 16) - 0.75, 0.1 * (i / 16 % 16) - 0.75, 0.1 * (i / 256) - 0.75}, 0.055,
                           {std::uint8_t(i % 200 + 30), std::uint8_t(i / 16), 128}));
  for (const bool translucent : {false, true}) {
    for (CellShape& cell : p.cells) cell.opacity = translucent ? 0.3 : 1;
    const auto begin = std::chrono::steady_clock::now();
    drawOrganism(p);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    WARN((translucent ? "translucent: " : "solid: ") << took.count() << " s");
  }
}

TEST_CASE("pictures that cannot be are refused by name", "[organism]") {
  const auto refused = [](auto change, const char* word) {
    OrganismPicture p = picture({ball("AB", {0, 0, 0}, 1, red)});
    change(p);
    REQUIRE_THROWS_AS(drawOrganism(p), InputError);
    REQUIRE_THROWS_WITH(drawOrganism(p), ContainsSubstring(word));
  };
  refused([](auto& p) { p.width = 15; }, "15 x 120");
  refused([](auto& p) { p.height = 8193; }, "8192");
  refused([](auto& p) { p.width = -900; }, "16 to 8192");
  refused([](auto& p) { p.samples = 0; }, "samples");
  refused([](auto& p) { p.samples = 5; }, "samples");
  refused([](auto& p) { p.samples = 4, p.width = p.height = 2000; }, "50000000");
  refused([](auto& p) { p.cells[0].vertices.pop_back(); }, "cell AB has 161");
  refused([](auto& p) { p.cells[0].vertices[3].y = NAN; }, "cell AB");
  refused([](auto& p) { p.cells[0].vertices[3].y = INFINITY; }, "not finite");
  refused([](auto& p) { p.cells[0].opacity = 1.5; }, "opacity");
  refused([](auto& p) { p.cells[0].opacity = NAN; }, "opacity");
  refused([](auto& p) { p.faces[0][0] = -1; }, "negative");
  refused([](auto& p) { p.shell = Vector{1, 0, 1}; }, "semi-axes");
  refused([](auto& p) { p.labels = {{1, "words"}}; }, "no cell");
  refused([](auto& p) { p.lines.push_back({{0, 0, 0}, {NAN, 0, 0}, {}}); }, "not finite");
  refused([](auto& p) { p.camera.framing->distance = 0; }, "distance");
  refused([](auto& p) { p.camera.up = p.camera.towardsEye; }, "parallel");
}

}  // namespace morula
