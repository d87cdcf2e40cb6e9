// Reads the part of Wavefront OBJ that says what the surface is: `v` and `f`.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/text_marks.h"
#include "mesh/mesh.h"
#include "mesh/mesh_measures.h"
#include "mesh/obj_source.h"
#include "mesh/triangulate.h"
#include "mesh/validity.h"

namespace morula {
namespace {

struct ObjWord {
  std::string_view text;
  int line, column;  // 1-based; columns in bytes
};

// Cuts the text into statements: the words of a line, without comments. A backslash at the end of a line
// joins the next one to it. Line ends are LF, CR LF or CR.
class ObjStatements {
 public:
  explicit ObjStatements(std::string_view text) : text_(withoutByteOrderMark(text)) {}

  // False at the end of the text. Statements without words are passed over.
  bool next(std::vector<ObjWord>& words) {
    words.clear();
    mayGoOn_ = true;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (isLineEnd(c)) {
        takeLineEnd();
        if (!words.empty()) return true;
      } else if (joinsLines()) {
        ++at_;
        takeLineEnd();
      } else if (c == '#') {
        while (at_ < text_.size() && !isLineEnd(text_[at_])) ++at_;
      } else if (isSpace(c)) {
        ++at_;
      } else {
        const std::size_t begin = at_;
        while (at_ < text_.size() && isWordPart()) ++at_;
        words.push_back({text_.substr(begin, at_ - begin), line_, static_cast<int>(begin - lineBegin_) + 1});
        mayGoOn_ = words[0].text == "v" || words[0].text == "f";
      }
    }
    return !words.empty();
  }

 private:
  static bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
  static bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  // The name of a material may end in a backslash, which joins nothing: only vertices and faces go on in the next line.
  bool joinsLines() const {
    return text_[at_] == '\\' && at_ + 1 < text_.size() && isLineEnd(text_[at_ + 1]) && mayGoOn_;
  }
  bool isWordPart() const {
    const char c = text_[at_];
    return !isSpace(c) && !isLineEnd(c) && c != '#' && !joinsLines();
  }
  void takeLineEnd() {
    at_ += text_.substr(at_).starts_with("\r\n") ? 2 : 1;
    ++line_;
    lineBegin_ = at_;
  }

  std::string_view text_;
  std::size_t at_ = 0, lineBegin_ = 0;
  int line_ = 1;
  bool mayGoOn_ = true;  // a backslash at the end of the line joins the next one
};

// Returns the name of another format that the text begins like; "" if it may be OBJ.
std::string otherFormat(std::string_view text) {
  if (isUtf16(text)) return "UTF-16";
  text = withoutByteOrderMark(text);
  if (text.starts_with("glTF")) return "GLB";
  if (text.starts_with("ply\n") || text.starts_with("ply\r")) return "PLY";
  if (text.starts_with("solid ") || text.starts_with("solid\n") || text.starts_with("solid\r")) return "STL";
  if (text.starts_with("OFF\n") || text.starts_with("OFF\r")) return "OFF";
  if (text.starts_with("{")) return "JSON";
  // A binary STL: a header of 80 bytes, the number of triangles, and 50 bytes for each of them.
  constexpr std::size_t head = 84, perTriangle = 50;
  if (text.find('\0') == text.npos) return "";
  return text.size() > head && (text.size() - head) % perTriangle == 0 ? "STL" : "a binary format";
}

// Keywords that do not change the surface: names, textures, normals, materials, smoothing, points and lines.
constexpr std::array<std::string_view, 19> passedOver = {
    "vt",     "vn",     "vp",     "g",   "o",     "s",        "mg",       "p",          "l",        "usemtl",
    "mtllib", "usemap", "maplib", "lod", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"};

struct ObjCorner {
  std::int64_t vertex;  // 0-based
  ObjWord word;
};

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name) : statements_(text) {
    source_.name = name;
    const std::string format = otherFormat(text);
    if (format == "UTF-16") throw InputError(name + ": the file is UTF-16; save it as UTF-8");
    if (!format.empty())
      throw InputError(name + ": the file is " + format +
                       ", and a mesh is read from Wavefront OBJ; convert it, for instance by Blender (File, Export) or "
                       "`assimp export`");
  }

  /// `toUnitSize`: centroid to the origin, farthest vertex to distance 1. `from`, if not null, receives the lines.
  Mesh read(bool toUnitSize, MeshSource* from = nullptr) {
    std::vector<ObjWord> words;
    while (statements_.next(words)) {
      const std::string_view keyword = words[0].text;
      if (keyword == "v") readVertex(words);
      else if (keyword == "f") readFace(words);
      else if (std::find(passedOver.begin(), passedOver.end(), keyword) == passedOver.end())
        fail(words[0], quoted(keyword) + " is no statement of a polygon mesh; write v for a vertex, f for a face");
    }
    addFaces();
    if (!errors_.empty()) throw InputError(allErrors());
    if (mesh_.vertices.empty())
      throw InputError(source_.name + ": no vertices; a mesh needs lines \"v x y z\" and \"f 1 2 3\"");
    if (toUnitSize) moveToUnitSize();
    checkClosedManifold(mesh_, source_);
    if (from) *from = source_;
    return std::move(mesh_);
  }

 private:
  static std::string quoted(std::string_view text) { return '"' + std::string(text) + '"'; }

  void fail(const ObjWord& at, const std::string& text) {
    const auto found = findInvisible(at.text);
    errors_.push_back(found ? Error{at.line, at.column + static_cast<int>(found->at),
                                    found->name + " stands in the line; remove it, or replace it by a space"}
                            : Error{at.line, at.column, text});
  }

  // Returns all errors in the order of the text, not in the order of their discovery.
  std::string allErrors() {
    std::stable_sort(errors_.begin(), errors_.end(), [](const Error& a, const Error& b) {
      return std::pair(a.line, a.column) < std::pair(b.line, b.column);
    });
    std::string all;
    for (std::size_t i = 0; i < std::min(errors_.size(), maxErrors); ++i) {
      const Error& e = errors_[i];
      all += (i ? "\n" : "") + source_.name + ":" + std::to_string(e.line) + ":" + std::to_string(e.column) + ": " +
             e.text;
    }
    if (errors_.size() > maxErrors) all += "\n… and " + std::to_string(errors_.size() - maxErrors) + " more mistakes";
    return all;
  }

  // v x y z. Exporters may add a weight, or a colour of three numbers, or both, which are not read.
  void readVertex(const std::vector<ObjWord>& words) {
    std::array<double, 3> numbers{};
    bool good = true;
    const std::size_t n = words.size() - 1;
    for (std::size_t i = 0; i < std::min(n, numbers.size()); ++i) good &= readNumber(words[i + 1], numbers[i]);
    if (n != 3 && n != 4 && n != 6 && n != 7) {
      fail(words[0], "a vertex of " + std::to_string(n) + " numbers; write \"v x y z\"");
      good = false;
    }
    // A bad vertex keeps its place, so that later vertices keep their numbers in further messages.
    mesh_.vertices.push_back(good ? Point{numbers[0], numbers[1], numbers[2]} : Point{});
    source_.vertexLines.push_back(words[0].line);
  }

  bool readNumber(const ObjWord& word, double& value) {
    std::string_view digits = word.text;
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::invalid_argument || end != digits.data() + digits.size())
      fail(word, quoted(word.text) + " is not a number; write it like 0.5 or -1e-3");
    else if (error == std::errc::result_out_of_range || !(std::abs(value) <= largest))
      fail(word, quoted(word.text) + " is not a usable coordinate; it must be finite, between -1e100 and 1e100");
    else {
      source_.written.note(digits);
      return true;
    }
    return false;
  }

  void readFace(const std::vector<ObjWord>& words) {
    ++faceCount_;
    std::vector<ObjCorner> corners;
    bool good = true;
    for (std::size_t i = 1; i < words.size(); ++i) {
      std::int64_t vertex = 0;
      good &= readCorner(words[i], vertex);
      corners.push_back({vertex, words[i]});
    }
    if (corners.size() < 3) {
      fail(words[0], "a face of " + std::to_string(corners.size()) + " corners; a face has three or more");
      good = false;
    }
    if (!good) return;
    polygons_.push_back({std::move(corners), faceCount_, words[0].line});
  }

  // v, v/vt, v//vn or v/vt/vn; v counts from 1, or from the latest vertex back with -1. Textures and normals are passed
  // over, and may be empty: v/, v//, v/vt/.
  bool readCorner(const ObjWord& word, std::int64_t& vertex) {
    const std::string_view digits = word.text.substr(0, word.text.find('/'));
    const auto known = static_cast<std::int64_t>(mesh_.vertices.size());
    std::int64_t index = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (error == std::errc::invalid_argument || end != digits.data() + digits.size() ||
        std::ranges::count(word.text, '/') > 2)
      fail(word, quoted(word.text) + " is not a corner; write the vertex's number, as 7, 7/1, 7//1 or 7/1/1");
    else if (error != std::errc() || index < -known)
      fail(word, quoted(word.text) + ": there is no such vertex; " + std::to_string(known) + " stand above this line");
    else if (index == 0)
      fail(word, quoted(word.text) + ": there is no number 0; vertices count from 1, or from the latest back with -1");
    else {
      vertex = index > 0 ? index - 1 : known + index;
      return true;
    }
    return false;
  }

  // Faces may stand before their vertices, so their numbers can only be judged at the end.
  void addFaces() {
    for (const Polygon& polygon : polygons_) {
      const auto& corners = polygon.corners;
      if (!checkCorners(corners)) continue;
      std::vector<Point> places;
      for (const ObjCorner& c : corners) places.push_back(mesh_.vertices[static_cast<std::size_t>(c.vertex)]);
      const Triangulation cut = triangulate(places);
      if (!cut.wrong.empty()) fail(corners[0].word, cut.wrong);
      for (const auto& [a, b, c] : cut.triangles) {
        mesh_.faces.push_back({static_cast<std::int32_t>(corners[a].vertex),
                               static_cast<std::int32_t>(corners[b].vertex),
                               static_cast<std::int32_t>(corners[c].vertex)});
        source_.faceLines.push_back(polygon.line);
        source_.faceNumbers.push_back(polygon.number);
      }
    }
  }

  bool checkCorners(const std::vector<ObjCorner>& corners) {
    const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
    bool good = true;
    for (const ObjCorner& c : corners)
      if (c.vertex >= count) {
        fail(c.word, quoted(c.word.text) + ": there is no such vertex; the file has " + std::to_string(count));
        good = false;
      }
    std::vector<ObjCorner> sorted = corners;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const ObjCorner& a, const ObjCorner& b) { return a.vertex < b.vertex; });
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end(),
                                          [](const ObjCorner& a, const ObjCorner& b) { return a.vertex == b.vertex; });
    if (twice != sorted.end()) {
      fail(twice[1].word, "vertex " + std::to_string(twice->vertex + 1) +
                              " occurs twice in this face; the corners of a face are different vertices");
      good = false;
    }
    return good;
  }

  // Moves the centroid to the origin and the farthest vertex to distance 1. Divides twice, because the square of a tiny
  // or huge distance may underflow or overflow.
  void moveToUnitSize() {
    const Point centre = measureCentroid(mesh_.vertices);
    double extent = 0, farthest = 0;
    for (Point& v : mesh_.vertices) {
      v -= centre;
      extent = std::max({extent, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    }
    if (!(extent > 0)) throw InputError(source_.name + ": all vertices lie at one place; a cell needs an inside");
    for (Point& v : mesh_.vertices) {
      v = v / extent;
      farthest = std::max(farthest, norm(v));
    }
    for (Point& v : mesh_.vertices) v = v / farthest;
  }

  struct Polygon {
    std::vector<ObjCorner> corners;
    int number, line;
  };
  struct Error {
    int line, column;
    std::string text;
  };
  static constexpr std::size_t maxErrors = 20;
  static constexpr double largest = 1e100;

  ObjStatements statements_;
  Mesh mesh_;
  MeshSource source_;
  std::vector<Polygon> polygons_;
  int faceCount_ = 0;
  std::vector<Error> errors_;
};

}  // namespace

Mesh readObj(const std::string& text, const std::string& name) { return ObjReader(text, name).read(true); }

Mesh readObjAsGiven(const std::string& text, const std::string& name, MeshSource& source) {
  return ObjReader(text, name).read(false, &source);
}

}  // namespace morula
