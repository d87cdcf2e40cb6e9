#include "catch.h"
#include "mesh/mesh.h"
#include "mesh/mesh_measures.h"
#include "zoo.h"

using namespace morula;

namespace {

std::string complaintAbout(const std::string& text) {
  try {
    readObj(text, "m.obj");
  } catch (const InputError& e) { return e.what(); }
  return "";
}

// Four corners of a cube, no three of which lie on a line.
const std::string corners = "v 1 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\n";
const std::string tetrahedron = corners + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

// Returns true if both meshes are equal bit for bit.
bool same(const Mesh& a, const Mesh& b) { return a.vertices == b.vertices && a.faces == b.faces; }

}  // namespace

TEST_CASE("A mesh that is written and read keeps its faces, and its shape but for place and size") {
  for (const auto& [name, mesh, handles] : zoo::all()) {
    CAPTURE(name);
    const Mesh read = readObj(zoo::objOf(mesh), name);
    CHECK(read.faces == mesh.faces);
    REQUIRE(read.vertices.size() == mesh.vertices.size());
    const Point centre = measureCentroid(mesh.vertices);
    double farthest = 0;
    for (const Point& v : mesh.vertices) farthest = std::max(farthest, norm(v - centre));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      REQUIRE(norm(read.vertices[i] * farthest + centre - mesh.vertices[i]) <= 4e-15 * (farthest + norm(centre)));
  }
}

TEST_CASE("A mesh is read with its vertices' mean at the origin and the farthest at distance 1") {
  const double scale = GENERATE(1.0, 1e-90, 1e99, 1e-320);  // squares of the last two overflow and underflow
  const Mesh egg = zoo::moved(zoo::scaled(makeIcosphere(1), {3, 2, 1}), {0.1, 0.2, 0.3});
  const Mesh read = readObj(zoo::objOf(zoo::scaled(egg, {scale, scale, scale})), "egg");
  double farthest = 0;
  for (const Point& v : read.vertices) farthest = std::max(farthest, norm(v));
  const double rounding = scale < 1e-300 ? 1e-3 : 1e-15;  // the smallest numbers have few digits
  CHECK(norm(measureCentroid(read.vertices)) < rounding);
  CHECK(std::abs(farthest - 1) <= 2e-16);
}

TEST_CASE("Line ends, comments, blanks, joined lines and a byte order mark change nothing") {
  const Mesh plain = readObj(tetrahedron, "plain");
  CHECK(same(plain, readObj(zoo::objOf(zoo::tetrahedron(), "\r\n"), "crlf")));
  CHECK(same(plain, readObj(zoo::objOf(zoo::tetrahedron(), "\r"), "cr")));
  CHECK(same(plain, readObj("\xEF\xBB\xBF# a mesh\n\n" + tetrahedron + "  # the end", "bom")));
  CHECK(same(plain, readObj("v 1 \\\n 1 1#x\nv\t-1\t-1\t+1.0  \nv -1 1e0 -1.\n  v 1 -1\\\r\n -.1E1\n" +
                                tetrahedron.substr(corners.size()),
                            "odd")));
  CHECK(same(plain, readObj(tetrahedron.substr(0, tetrahedron.size() - 1), "without a last line end")));
}

TEST_CASE("Corners may carry textures and normals, and count back from the latest vertex") {
  const Mesh plain = readObj(tetrahedron, "plain");
  CHECK(
      same(plain, readObj(corners + "f 1/1 3/2 2/3\nf 1//1 2//1 4//1\nf 1/1/1 4/2/2 3/3/3\nf 2 3/9/9 4\n", "slashes")));
  CHECK(same(plain, readObj(corners + "f -4 -2 -3\nf -4/-1 -3/-1 -1/-1\nf 1 -1 3\nf 2 3 4\n", "back")));
  CHECK(same(plain,
             readObj("v 1 1 1\nv -1 -1 1\nv -1 1 -1\nf -3 -1 -2\nv 1 -1 -1\nf 1 2 -1\nf 1 4 3\nf 2 3 4\n", "mixed")));
  CHECK(same(plain, readObj("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n" + corners, "faces first")));
}

TEST_CASE("Weights, colours and whatever is not shape are passed over") {
  CHECK(same(readObj(tetrahedron, "plain"),
             readObj("mtllib a.mtl\no tetra\nv 1 1 1 1.0\nv -1 -1 1 0.5 0.5 0.5\nv -1 1 -1 1 0.5 0.5 0.5\nv 1 -1 -1\n"
                     "vt 0 0\nvn 0 0 1\nvp 1\ng side\nusemtl red\ns off\nl 1 2\np 1\n" +
                         tetrahedron.substr(corners.size()),
                     "rich")));
}

TEST_CASE("Polygons are split into fans") {
  const std::string cube =
      "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
      "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
  CHECK(readObj(cube, "cube").faces == zoo::box({-1, -1, -1}, {1, 1, 1}).faces);
  // A prism over a hexagon, with twelve vertices.
  std::string prism;
  for (const char* z : {" 0\n", " 1\n"})
    for (const char* xy : {"2 0", "1 2", "-1 2", "-2 0", "-1 -2", "1 -2"}) prism += std::string("v ") + xy + z;
  prism += "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\n";
  for (int i = 1; i <= 6; ++i) {
    const int j = i % 6 + 1;
    prism += "f " + std::to_string(i) + " " + std::to_string(j) + " " + std::to_string(j + 6) + " " +
             std::to_string(i + 6) + "\n";
  }
  const Mesh m = readObj(prism, "prism");
  CHECK(m.faces.size() == 4 + 4 + 12);
  CHECK(m.faces[4] == Face{6, 7, 8});
  CHECK(m.faces[7] == Face{6, 10, 11});
}

TEST_CASE("What is wrong with the text is said with its line and column, and what would be right") {
  const auto [text, complaint] = GENERATE(table<std::string, std::string>({
      {"v 1 2\n" + tetrahedron, "m.obj:1:1: a vertex of 2 numbers; write \"v x y z\""},
      {"v 1 2 3 4 5\n" + tetrahedron, "m.obj:1:1: a vertex of 5 numbers; write \"v x y z\""},
      {"v\n" + tetrahedron, "m.obj:1:1: a vertex of 0 numbers; write \"v x y z\""},
      {"\n v 1 2,5 3\n" + tetrahedron, "m.obj:2:6: \"2,5\" is not a number; write it like 0.5 or -1e-3"},
      {"v 1 2 0x10\n" + tetrahedron, "m.obj:1:7: \"0x10\" is not a number; write it like 0.5 or -1e-3"},
      {"v 1 + 2\n" + tetrahedron, "m.obj:1:5: \"+\" is not a number; write it like 0.5 or -1e-3"},
      {"v 1 +-1 2\n" + tetrahedron, "m.obj:1:5: \"+-1\" is not a number; write it like 0.5 or -1e-3"},
      {"v nan 0 0\n" + tetrahedron,
       "m.obj:1:3: \"nan\" is not a usable coordinate; it must be finite, between -1e100 and 1e100"},
      {"v 0 -inf 0\n" + tetrahedron,
       "m.obj:1:5: \"-inf\" is not a usable coordinate; it must be finite, between -1e100 and 1e100"},
      {"v 0 0 1e400\n" + tetrahedron,
       "m.obj:1:7: \"1e400\" is not a usable coordinate; it must be finite, between -1e100 and 1e100"},
      {tetrahedron + "f 1 2\n", "m.obj:9:1: a face of 2 corners; a face has three or more"},
      {tetrahedron + "f 0 1 2\n",
       "m.obj:9:3: \"0\": there is no number 0; vertices count from 1, or from the latest back with -1"},
      {tetrahedron + "f 1 2 5\n", "m.obj:9:7: \"5\": there is no such vertex; the file has 4"},
      {tetrahedron + "f 1 2 -5\n", "m.obj:9:7: \"-5\": there is no such vertex; 4 stand above this line"},
      {tetrahedron + "f 1 2 99999999999999999999\n",
       "m.obj:9:7: \"99999999999999999999\": there is no such vertex; 4 stand above this line"},
      {tetrahedron + "f 1 2 4294967297\n", "m.obj:9:7: \"4294967297\": there is no such vertex; the file has 4"},
      {tetrahedron + "f 1 2 3.5\n",
       "m.obj:9:7: \"3.5\" is not a corner; write the vertex's number, as 7, 7/1, 7//1 or 7/1/1"},
      {tetrahedron + "f 1 2 3/1/1/1\n",
       "m.obj:9:7: \"3/1/1/1\" is not a corner; write the vertex's number, as 7, 7/1, 7//1 or 7/1/1"},
      {tetrahedron + "f /1 2 3\n",
       "m.obj:9:3: \"/1\" is not a corner; write the vertex's number, as 7, 7/1, 7//1 or 7/1/1"},
      {tetrahedron + "f 1 2 3 1\n",
       "m.obj:9:9: vertex 1 occurs twice in this face; the corners of a face are different vertices"},
      {tetrahedron + "f 1 2 -3 3\n",
       "m.obj:9:7: vertex 2 occurs twice in this face; the corners of a face are different vertices"},
      {tetrahedron + "face 1 2 3\n",
       "m.obj:9:1: \"face\" is no statement of a polygon mesh; write v for a vertex, f for a face"},
      {"v\xC2\xA0"
       "1 2 3\n" +
           tetrahedron,
       "m.obj:1:2: U+00A0 no-break space stands in the line; remove it, or replace it by a space"},
      {"v 1 2\xE2\x80\x8B 3\n" + tetrahedron,
       "m.obj:1:6: U+200B zero-width space stands in the line; remove it, or replace it by a space"},
      {"", "m.obj: no vertices; a mesh needs lines \"v x y z\" and \"f 1 2 3\""},
      {"# nothing\n", "m.obj: no vertices; a mesh needs lines \"v x y z\" and \"f 1 2 3\""},
      {"v 1 1 1\nv 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n",
       "m.obj: all vertices lie at one place; a cell needs an inside"},
  }));
  CHECK(complaintAbout(text) == complaint);
}

TEST_CASE("What textures and normals say is passed over, whatever it is") {
  CHECK(
      same(readObj(tetrahedron, "plain"),
           readObj(corners + "f 1/0 3/- 2/x\nf 1/a/b 2/ 4//\nf 1 4/99999999999999999999 3\nf 2/1/ 3 4\n", "dropped")));
}

TEST_CASE("Files of other formats are named once, with what makes a mesh of them") {
  std::string binary(84 + 2 * 50, '\0');
  binary[80] = 2;
  const auto [text, format] = GENERATE_COPY(table<std::string, std::string>({
      {"solid cube\nfacet normal 0 0 1\nouter loop\n", "STL"},
      {binary, "STL"},
      {"ply\nformat ascii 1.0\nelement vertex 8\n", "PLY"},
      {std::string("glTF\2\0\0\0", 8), "GLB"},
      {"{\"asset\": {\"version\": \"2.0\"}}", "JSON"},
      {"OFF\n8 6 0\n", "OFF"},
      {std::string("PK\3\4\0\0", 6), "a binary format"},
  }));
  CHECK(complaintAbout(text) == "m.obj: the file is " + format +
                                    ", and a mesh is read from Wavefront OBJ; convert it, for instance by Blender "
                                    "(File, Export) or `assimp export`");
  CHECK(complaintAbout(std::string("\xFF\xFEv\0", 4)) == "m.obj: the file is UTF-16; save it as UTF-8");
}

TEST_CASE("All vertices that no face has are named at once") {
  CHECK_THAT(complaintAbout(tetrahedron + "v 5 5 5\n"),
             ContainsSubstring("m.obj:9:1: vertex 5: no face has this vertex"));
  std::string loose = tetrahedron;
  for (int i = 0; i < 10; ++i) loose += "v 5 5 5\n";
  CHECK_THAT(
      complaintAbout(loose),
      ContainsSubstring("m.obj:9:1: no face has the vertices 5, 6, 7, 8, 9, 10, 11, 12 and 2 more; remove them"));
}

TEST_CASE("All mistakes are named at once, in the order of the text, up to twenty") {
  CHECK(complaintAbout("f 1 1 9\nv a b 3\nf 0 1 2\n") ==
        "m.obj:1:5: vertex 1 occurs twice in this face; the corners of a face are different vertices\n"
        "m.obj:1:7: \"9\": there is no such vertex; the file has 1\n"
        "m.obj:2:3: \"a\" is not a number; write it like 0.5 or -1e-3\n"
        "m.obj:2:5: \"b\" is not a number; write it like 0.5 or -1e-3\n"
        "m.obj:3:3: \"0\": there is no number 0; vertices count from 1, or from the latest back with -1");
  std::string many;
  for (int i = 0; i < 25; ++i) many += "q\n";
  const std::string text = complaintAbout(many);
  CHECK(std::count(text.begin(), text.end(), '\n') == 20);
  CHECK_THAT(text, ContainsSubstring("m.obj:20:1: ") && ContainsSubstring("\n… and 5 more mistakes"));
}

TEST_CASE("What is wrong with the surface is said with the line of the face") {
  CHECK(complaintAbout(corners + "f 1 3 2\n\n# turned:\nf 1 4 2\nf 1 4 3\nf 2 3 4\n") ==
        "m.obj:8:1: the edge between vertices 1 and 2: face 1 and face 2 turn opposite ways; list the corners of all "
        "faces counter-clockwise as seen from outside");
  // Both triangles of a quad have its number.
  CHECK_THAT(complaintAbout("v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
                            "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\n"),
             ContainsSubstring("m.obj:9:1: the edge between vertices 2 and 4 belongs to face 1 only"));
  CHECK_THAT(complaintAbout("v 5 5 5\n" + corners + "f 2 4 3\nf 2 3 5\nf 2 5 4\nf 3 4 5\n"),
             ContainsSubstring("m.obj:1:1: vertex 1: no face has this vertex"));
  CHECK_THAT(complaintAbout(corners + "f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n"),
             ContainsSubstring("m.obj:5:1: all faces are inverted"));
}

TEST_CASE("Corners as exporters write them where textures and normals are missing") {
  const Mesh plain = readObj(tetrahedron, "m.obj");
  for (const std::string behind : {"/", "//", "/1/", "//1", "/1", "/1/1"}) {
    std::string faces;
    for (const char* face : {"1 3 2", "1 2 4", "1 4 3", "2 3 4"}) {
      faces += "f";
      for (const char c : std::string(face))
        if (c != ' ') faces += std::string(" ") + c + behind;
      faces += "\n";
    }
    CAPTURE(behind);
    CHECK(same(readObj(corners + "vt 0 0\nvn 0 0 1\n" + faces, "m.obj"), plain));
  }
  CHECK_THAT(complaintAbout(corners + "f 1 3 /2\n"), ContainsSubstring("\"/2\" is not a corner"));
}

TEST_CASE("A material whose name ends in a backslash does not swallow the next line") {
  CHECK(same(readObj("usemtl skin\\\n" + tetrahedron + "g a\\\n", "m.obj"), readObj(tetrahedron, "m.obj")));
}

TEST_CASE("Numbers behind a vertex are not read") {
  CHECK(
      same(readObj("v 1 1 1 - - -\nv -1 -1 1 nan nan nan\nv -1 1 -1 1\nv 1 -1 -1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
                   "m.obj"),
           readObj(tetrahedron, "m.obj")));
}

TEST_CASE("A concave polygon of a file is filled, and one that crosses itself is told with its line") {
  const std::string sides = "f 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n";
  std::string points;
  for (const char* z : {"0", "1"})
    for (const char* xy : {"0 0", "2 0", "2 1", "1 1", "1 2", "0 2"}) points += std::string("v ") + xy + " " + z + "\n";
  const Mesh solid = readObj(points + "f 9 10 11 12 7 8\nf 3 2 1 6 5 4\n" + sides, "l.obj");
  const double area = measureArea(solid.vertices, solid.faces), volume = measureVolume(solid.vertices, solid.faces);
  CHECK(std::pow(area / 14, 3) == Approx(std::pow(volume / 3, 2)).epsilon(1e-12));  // 14 and 3 in the file's units
  CHECK_THAT(
      complaintAbout(points + "f 7 9 8 10 11 12\nf 6 5 4 3 2 1\n" + sides),
      ContainsSubstring("m.obj:13:3: the outline of this face crosses or touches itself; split it into triangles"));
}
