#include "pictures/frame_file.h"

#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/fields.h"

namespace morula {
namespace {

using Numbers = std::vector<std::uint64_t>;

std::uint64_t number(Colour c) { return std::uint64_t{c.r} << 16 | std::uint64_t{c.g} << 8 | c.b; }

[[noreturn]] void refuse() { throw InputError("frame: its counts, positions and corners do not fit together"); }

/// Returns the next `count` triples of values, and moves `at` behind them.
template <class Value>
std::vector<Value> nextTriples(const std::vector<Value>& values, std::size_t& at, std::uint64_t count) {
  if (count > (values.size() - at) / 3) refuse();
  at += 3 * count;
  return {values.begin() + static_cast<std::ptrdiff_t>(at - 3 * count),
          values.begin() + static_cast<std::ptrdiff_t>(at)};
}

}  // namespace

std::string frameBytes(const OrganismPicture& picture) {
  std::vector<std::string> paths;
  Numbers colours, vertices, faces, corners;
  std::vector<double> positions;
  for (const CellShape& cell : picture.cells) {
    paths.push_back(cell.path);
    colours.push_back(number(cell.colour));
    vertices.push_back(cell.vertices.size());
    faces.push_back(cell.faces.size());
    for (const Point& x : cell.vertices) positions.insert(positions.end(), {x.x, x.y, x.z});
    for (const Face& f : cell.faces) corners.insert(corners.end(), f.begin(), f.end());
  }
  FieldWriter out;
  out.add("caption", std::vector<std::string>{picture.caption});
  std::vector<std::string> labels;
  Numbers labelColours;
  for (const LegendEntry& entry : picture.legend) {
    labels.push_back(entry.label);
    labelColours.push_back(number(entry.colour));
  }
  out.add("legend.label", labels);
  out.add("legend.colour", labelColours);
  out.add("cells.path", paths);
  out.add("cells.colour", colours);
  out.add("cells.vertices", vertices);
  out.add("cells.faces", faces);
  out.add("positions", positions);
  out.add("corners", corners);
  return out.bytes();
}

OrganismPicture pictureFrom(const std::string& bytes, OrganismPicture blank) {
  FieldReader in(bytes, "frame");
  const auto caption = in.texts("caption");
  const auto labels = in.texts("legend.label");
  const Numbers labelColours = in.numbers("legend.colour");
  const auto paths = in.texts("cells.path");
  const Numbers colours = in.numbers("cells.colour"), vertices = in.numbers("cells.vertices"),
                faces = in.numbers("cells.faces");
  const std::vector<double> positions = in.reals("positions");
  const Numbers corners = in.numbers("corners");
  in.end();
  const std::size_t n = paths.size();
  if (caption.size() != 1 || labelColours.size() != labels.size() || colours.size() != n || vertices.size() != n ||
      faces.size() != n)
    refuse();
  blank.caption = caption[0];
  for (std::size_t i = 0; i < labels.size(); ++i)
    blank.legend.push_back({colourFrom(std::uint32_t(labelColours[i])), labels[i]});
  std::size_t atPosition = 0, atCorner = 0;
  for (std::size_t i = 0; i < n; ++i) {
    CellShape cell{paths[i], {}, colourFrom(std::uint32_t(colours[i]))};
    const auto x = nextTriples(positions, atPosition, vertices[i]);
    for (std::size_t v = 0; v < vertices[i]; ++v) cell.vertices.push_back({x[3 * v], x[3 * v + 1], x[3 * v + 2]});
    const auto c = nextTriples(corners, atCorner, faces[i]);
    for (std::size_t f = 0; f < faces[i]; ++f) {
      Face face;
      for (std::size_t k = 0; k < 3; ++k) {
        if (c[3 * f + k] > std::numeric_limits<std::int32_t>::max()) refuse();
        face[k] = static_cast<std::int32_t>(c[3 * f + k]);
      }
      cell.faces.push_back(face);
    }
    for (const Face& face : cell.faces.empty() ? blank.faces : cell.faces)
      for (const auto corner : face)
        if (static_cast<std::uint64_t>(corner) >= vertices[i]) refuse();
    for (const double a : x)
      if (!std::isfinite(a)) refuse();
    blank.cells.push_back(std::move(cell));
  }
  return blank;
}

}  // namespace morula
