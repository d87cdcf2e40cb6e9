// Tables made from a known lineage, and what the scenario of each must be. Wrong tables: tests/bad_commands/tracks.txt.
#include <bit>
#include <cmath>
#include <set>

#include "base/error.h"
#include "tracks/embryo_sizes.h"
#include "tracks/settings.h"
#include "tracks/touching.h"
#include "tracks/wording.h"
#include "tracks/write_embryo.h"
// Last, because of CHECK:
#include "catch.h"

using namespace morula;
using namespace morula::tracks;

namespace {

struct Made {
  Embryo embryo;
  std::vector<std::string> assumed;

  const TrackedCell& cell(const std::string& name) const { return embryo.lineage.cells[number(name)]; }
  std::size_t number(const std::string& name) const {
    for (std::size_t i = 0; i < embryo.lineage.cells.size(); ++i)
      if (embryo.lineage.cells[i].name == name) return i;
    FAIL("there is no cell " + name);
    return 0;
  }
  bool says(const std::string& part) const {
    for (const std::string& sentence : embryo.assumed)
      if (sentence.find(part) != sentence.npos) return true;
    return false;
  }
};

Made make(const std::string& text, const EmbryoOptions& options = {}) {
  scenario::Problems problems("t.csv");
  const CellTable table = readCellTable(text, problems);
  problems.throwIfAny();
  Lineage lineage = makeLineage(table, options.root, problems);
  problems.throwIfAny();
  return {makeEmbryo(std::move(lineage), options), {}};
}

const std::string header = "track_id,t,z,y,x,parent_track_id,volume\n";

/// P0 lives for 4 frames, AB for 4 and P1 for 8; both daughters of each lie at ±axis.
std::string smallLineage() {
  std::string text = header;
  const auto rows = [&](const std::string& name, const std::string& parent, int from, int to, Point p, double volume) {
    for (int t = from; t < to; ++t)
      text += name + "," + std::to_string(t) + "," + std::to_string(p.z) + "," + std::to_string(p.y) + "," +
              std::to_string(p.x) + "," + parent + "," + std::to_string(volume) + "\n";
  };
  rows("P0", "", 0, 4, {10, 10, 10}, 100);
  rows("P1", "P0", 4, 12, {13, 10, 10}, 40);
  rows("AB", "P0", 4, 8, {7, 10, 10}, 60);
  rows("ABa", "AB", 8, 16, {7, 13, 14}, 45);
  rows("ABp", "AB", 8, 16, {7, 7, 6}, 15);
  rows("EMS", "P1", 12, 16, {13, 10, 12}, 20);
  rows("P2", "P1", 12, 16, {13, 10, 8}, 20);
  return text;
}

}  // namespace

TEST_CASE("lives, shares, axes and sizes of a table are those of the lineage that it was made of") {
  const Made made = make(smallLineage(), {.units = {"µm", "min", 1, 1}, .shell = std::array<double, 3>{4, 3, 3}});
  const Embryo& e = made.embryo;
  CHECK(e.time == 1);  // the median life is four frames
  CHECK(e.life[made.number("P0")] == 4);
  CHECK(e.life[made.number("AB")] == 4);
  CHECK(e.life[made.number("P1")] == 8);
  CHECK(!made.cell("ABa").hasEnd());
  CHECK(e.stop == 15.5);
  CHECK(*e.division[made.number("P0")].share == Approx(0.6));
  CHECK(*e.division[made.number("AB")].share == Approx(0.75));
  CHECK(norm(*e.division[made.number("P0")].axis - Vector{-1, 0, 0}) < 1e-12);  // AB comes before P1
  CHECK(norm(*e.division[made.number("AB")].axis - Vector{0, 0.6, 0.8}) < 1e-12);
  CHECK(e.path[made.number("EMS")].text() == "BA");
  CHECK(e.fill == Approx(100 / (4 * M_PI / 3 * 36)));
  CHECK(e.length == Approx(std::cbrt(100 / (4 * M_PI / 3))));
  CHECK(e.names.daughters.empty());  // each pair of endings occurs once
  REQUIRE(e.stages.size() == 4);
  CHECK(e.stages[2].cells == 3);
  CHECK(e.stages[2].begin == 8);
  REQUIRE(e.stages[2].places.size() == 3);
  const auto& [cell, place] = e.stages[2].places[0];
  CHECK(norm(place * e.length + e.centre - e.lineage.cells[static_cast<std::size_t>(cell)].seen[0].place) < 1e-12);
  CHECK(e.assumed.empty());
}

TEST_CASE("the axis is the mean direction over three frames, the first with the greatest weight") {
  const auto row = [](const char* name, int t, Point p) {
    return std::string(name) + "," + std::to_string(t) + ",0," + std::to_string(p.y) + "," + std::to_string(p.x) +
           ",e,\n";
  };
  const Point directions[] = {{2, 0, 0}, {0, 4, 0}, {-1, 0, 0}, {0, -100, 0}};  // A − B; the fourth does not count
  std::string text = header + "e,0,0,0,0,,\n";
  for (int t = 0; t < 4; ++t) text += row("a", t + 1, directions[t]) + row("b", t + 1, {0, 0, 0});
  const Vector expected = Vector{3 - 1, 2, 0} / norm({2, 2, 0});
  CHECK(norm(*make(text).embryo.division[0].axis - expected) < 1e-12);
}

TEST_CASE("headers of trackers, separators, line ends and a byte order mark read alike") {
  const std::string plain = smallLineage();
  const auto replace = [](std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
      text.replace(at, from.size(), to);
    return text;
  };
  const std::string trackMate = "TRACK_ID,FRAME,POSITION_Z,POSITION_Y,POSITION_X,MOTHER,Volume [µm³]\n";
  for (const std::string& text :
       {"\xEF\xBB\xBF" + plain, replace(plain, "\n", "\r\n"), replace(plain, "\n", "\r"), replace(plain, ",", ";"),
        replace(plain, ",", "\t"), replace(plain, header, trackMate), replace(plain, "P1,", "\"P1\",")}) {
    const Made made = make(text);
    REQUIRE(made.embryo.lineage.cells.size() == 7);
    CHECK(made.cell("P1").birth == 4);
    CHECK(made.cell("P1").volume == 40);
  }
}

TEST_CASE("columns with headers of one's own are named, and the scenario begins with the command that names them") {
  const std::string own = "Spot,When,Z,Y,X,Comes from,Volume\n" + smallLineage().substr(header.size());
  const EmbryoOptions options{.columns = {{"track_id", "Spot"}, {"t", "When"}, {"parent", "Comes from"}}};
  std::vector<std::string> assumed;
  const auto files = embryoFromTable(own, "t.csv", options, "small", assumed);
  CHECK(files[1].text == embryoFromTable(smallLineage(), "t.csv", {}, "small", assumed)[1].text);
  CHECK(files[0].text.find("--columns 'parent=Comes from,t=When,track_id=Spot'\n") != std::string::npos);
}

TEST_CASE("cells without an id are told apart by their names, and what R writes for nothing is unknown") {
  const Made made =
      make("Cell name,mother,birth,division,x,y,z,volume,fate\nZ,NA,0,4,0,0,0,NA,\na,Z,4,NA,1,NaN,nan,2,NA\nb,Z,4,,,,,1,\n");
  REQUIRE(made.embryo.lineage.cells.size() == 3);
  CHECK(made.embryo.lineage.founders == 1);
  CHECK(made.cell("a").seen.empty());
  CHECK(*made.embryo.division[0].share == Approx(2.0 / 3));
  CHECK(!made.says("ends before the table does"));
}

TEST_CASE("a summary speaks of axes where the table gives some") {
  std::vector<std::string> assumed;
  const auto summary = [&](const std::string& text) { return embryoFromTable(text, "t", {}, "t", assumed)[0].text; };
  CHECK(summary("1 0 3 0\n2 4 9 1\n3 4 9 1\n").find("with their times\"\n") != std::string::npos);
  CHECK(summary(smallLineage()).find("with their times and axes of division\"\n") != std::string::npos);
}

TEST_CASE("the fitted shell holds all centres, and a cell's ball beyond the farthest along each axis") {
  std::vector<Point> centres;
  for (int i = 0; i < 200; ++i) centres.push_back({20 * std::sin(i), 9 * std::sin(2.0 * i), 7 * std::cos(3.0 * i)});
  for (const int n : {2, 8, 64, 1000}) {
    const auto axes = fitShell(centres, {}, n);
    for (const Point& p : centres) CHECK(norm({p.x / axes[0], p.y / axes[1], p.z / axes[2]}) <= 1 + 1e-12);
  }
  const std::vector<Point> cross{{5, 0, 0}, {-5, 0, 0}, {0, 3, 0}, {0, 0, -2}};
  const auto axes = fitShell(cross, {}, 8);
  const double radius = std::cbrt(axes[0] * axes[1] * axes[2] / 8);
  CHECK(axes[0] == Approx(5 + radius));
  CHECK(axes[1] == Approx(3 + radius));
  CHECK(axes[2] == Approx(2 + radius));
}

TEST_CASE("a track with one daughter goes on, late founders are there from the start, and all of that is said") {
  const Made made = make("1 0 10 0\n2 0 45 0\n3 11 30 1\n4 11 50 1\n5 31 60 3\n6 33 60 3\n7 52 60 4\n8 20 60 0\n");
  CHECK(made.embryo.lineage.cells.size() == 7);
  CHECK(made.embryo.lineage.founders == 3);
  CHECK(made.cell("1").end == 11);
  CHECK(made.cell("3").end == 31);
  CHECK(!made.cell("4").hasEnd());
  CHECK(made.cell("6").birth == 31);
  CHECK(made.cell("8").birth == 0);
  CHECK(made.says("only daughter of another"));
  CHECK(made.says("is first seen later"));
  CHECK(made.says("is first seen after her sister"));
  CHECK(made.says("ends before the table does"));
  CHECK(make("1 0 10 0\n2 0 45 0\n3 11 30 1\n4 11 50 1\n", {.root = "1"}).embryo.lineage.cells.size() == 3);
}

TEST_CASE("a row per cell says when it is born or divides, where its axis lies, and whether it dies") {
  const Made made = make(
      "cell,parent,birth,end,axis_x,axis_y,axis_z,volume,fate\n"
      "a4.2*,,0,8,0,0,2,,divides\nb,a4.2*,,12,,,,30,died\nc,a4.2*,8,,,,,10,\n");
  CHECK(made.embryo.substance[0] == "a4_2_");
  CHECK(made.says("a4.2* is a4_2_"));
  CHECK(norm(*made.embryo.division[0].axis - Vector{0, 0, 1}) < 1e-12);
  CHECK(*made.embryo.division[0].share == Approx(0.75));
  CHECK(made.cell("b").dies);
  CHECK(made.cell("b").birth == 8);
  CHECK(made.cell("c").birth == 8);
}

TEST_CASE(
    "of a row per cell, columns give places while so many cells live, and the first row of two daughters is A's") {
  const std::string text =
      "cell,parent,division,volume,x_2,y_2,z_2,x_3,y_3,z_3,x_7,y_7,z_7\n"
      "e,,4,30,,,,,,,,,\nz,e,8,20,5,0,0,,,,1,1,1\na,e,,10,-5,0,0,-6,0,0,,,\n"
      "zb,z,,10,,,,4,3,0,,,\nza,z,,10,,,,4,-3,0,,,\n";
  const Made made = make(text, {.shell = std::array<double, 3>{12, 8, 8}, .perTime = 2.0});
  const Embryo& e = made.embryo;
  CHECK(e.time == 2);
  CHECK(e.life[made.number("z")] == 2);
  CHECK(e.path[made.number("z")].text() == "A");
  CHECK(e.path[made.number("za")].text() == "AB");
  CHECK(norm(*e.division[made.number("e")].axis - Vector{1, 0, 0}) <
        1e-12);  // by places among the same number of cells
  CHECK(norm(*e.division[made.number("z")].axis - Vector{0, 1, 0}) < 1e-12);
  REQUIRE(e.stages.size() == 3);
  REQUIRE(e.stages[2].places.size() == 3);
  CHECK(norm(e.stages[2].places[0].second * e.length + e.centre - Point{-6, 0, 0}) < 1e-12);  // a's among three
  CHECK(e.stages[2].contacts.size() == 3);
  CHECK(made.says("do not live while there are so many; these are left out: 7"));
}

TEST_CASE("two cells of equal volume share the disc between them, unequal ones the disc nearer to the smaller") {
  const std::array<double, 3> ball{10, 10, 10};
  const auto even = facesOf({{{-4, 0, 0}, 3}, {{4, 0, 0}, 3}}, {}, ball);
  REQUIRE(even.size() == 1);
  CHECK(even[0].area == Approx(M_PI * 100).epsilon(0.001));
  // d² - r² is equal at x where (x + 4)² - 25 = (x - 4)² - 9, at 1.
  const auto uneven = facesOf({{{-4, 0, 0}, 5}, {{4, 0, 0}, 3}}, {}, ball);
  CHECK(uneven[0].area == Approx(M_PI * 99).epsilon(0.001));
  // An ellipsoid is cut in an ellipse.
  CHECK(facesOf({{{-4, 0, 0}, 3}, {{4, 0, 0}, 3}}, {}, {10, 5, 2})[0].area == Approx(M_PI * 10).epsilon(0.001));
}

TEST_CASE(
    "eight cells at the corners of a cube share twelve faces, whose areas are quarters of discs, and no diagonals") {
  std::vector<Ball> cube;
  for (int i = 0; i < 8; ++i) cube.push_back({{i & 1 ? 3.0 : -3.0, i & 2 ? 3.0 : -3.0, i & 4 ? 3.0 : -3.0}, 3});
  const auto pairs = touching(cube, {}, {9, 9, 9});
  CHECK(pairs.size() == 12);
  for (const auto& [a, b] : pairs) CHECK(std::popcount(static_cast<unsigned>(a ^ b)) == 1);
  for (const Face& face : facesOf(cube, {}, {9, 9, 9}))
    if (std::popcount(static_cast<unsigned>(face.a ^ face.b)) == 1)
      CHECK(face.area == Approx(M_PI * 81 / 4).epsilon(0.001));
}

TEST_CASE("settings replace the lines of their keys, are added where there is none, and leave all other lines") {
  const std::string text =
      "# head\nmorula: 1\nstop: {time: 3}  # late\nphysics:\n  drag: 10\n  shell: {\n    sphere: 1, fill: 0.9\n  }\n"
      "  contact: {stiffness: 30}\nrecord:\n  every: 1\n";
  scenario::Problems problems("t.yaml");
  CHECK(withSettings(text, {}, problems) == text);
  CHECK(withSettings(text,
                     {"stop.time=5", "physics.shell.fill=0.8", "physics.membrane={stiffness: 5}", "physics.drag=null",
                      "summary=one, two", "colours={\"a*\": \"#ff0000\"}"},
                     problems) ==
        "# head\nmorula: 1\nstop: {time: 5}\nphysics:\n  shell: {sphere: 1, fill: 0.8}\n"
        "  contact: {stiffness: 30}\n  membrane: {stiffness: 5}\nrecord:\n  every: 1\n"
        "summary: \"one, two\"\ncolours: {\"a*\": \"#ff0000\"}\n");
  CHECK(problems.empty());
}

TEST_CASE("substances keep apart names that differ in what no substance may hold, and the simulator's own words") {
  const Made made =
      make("cell,parent,birth,division\nA,,0,1\ndivide,A,,2\n7,A,,3\nx*,divide,,\nx-,divide,,\nB,7,,\nSTART,7,,\n");
  std::set<std::string> different(made.embryo.substance.begin(), made.embryo.substance.end());
  CHECK(different.size() == 7);
  for (const char* word : {"A", "B", "divide", "START"}) CHECK(!different.contains(word));
}

TEST_CASE("names come in the order of their letters, and of the values of their digits") {
  CHECK(precedes("ABa", "ABp"));
  CHECK(precedes("9", "10"));
  CHECK(precedes("cell9b", "cell10a"));
  CHECK(!precedes("10", "9"));
  CHECK(!precedes("E", "E"));
  CHECK(precedes("E", "EMS"));
}

TEST_CASE("every file of a table can be read, with meshes and with balls") {
  for (const bool areSpheres : {false, true}) {
    std::vector<std::string> assumed;
    const auto files = embryoFromTable(smallLineage(), "some/t.csv", {.areSpheres = areSpheres}, "small", assumed);
    CHECK(files[0].path == "small.yaml");
    CHECK(files[0].text.find("- {of: AB, axis: [0, 0.6, 0.8], share: 0.75}\n") != std::string::npos);
    CHECK(files[0].text.find("t.csv") != std::string::npos);
    CHECK(files[0].text.find("some/") == std::string::npos);
    CHECK(files.back().path == "real/4.txt");
    for (const auto& file : files) CHECK(file.text.ends_with("\n"));
  }
}
