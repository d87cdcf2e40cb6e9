#include "cli/frame_file.h"

#include "base/error.h"
#include "base/fields.h"

namespace morula::cli {

namespace {

using Numbers = std::vector<std::uint64_t>;

std::uint64_t number(Colour c) { return std::uint64_t{c.r} << 16 | std::uint64_t{c.g} << 8 | c.b; }

Colour colour(std::uint64_t n) {
  return {static_cast<std::uint8_t>(n >> 16), static_cast<std::uint8_t>(n >> 8),
          static_cast<std::uint8_t>(n)};
}

/// Takes `count` of the values, from `at` on.
template <class Value>
std::vector<Value> next(const std::vector<Value>& values, std::size_t& at, std::uint64_t count) {
  if (count > values.size() - at)
    throw InputError("frame: its columns have different lengths, so it is damaged");
  at += count;
  return {values.begin() + static_cast<std::ptrdiff_t>(at - count),
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
  if (caption.size() != 1 || labelColours.size() != labels.size() || colours.size() != n ||
      vertices.size() != n || faces.size() != n)
    throw InputError("frame: its columns have different lengths, so it is damaged");
  blank.caption = caption[0];
  for (std::size_t i = 0; i < labels.size(); ++i)
    blank.legend.push_back({colour(labelColours[i]), labels[i]});
  std::size_t atPosition = 0, atCorner = 0;
  for (std::size_t i = 0; i < n; ++i) {
    CellShape cell{paths[i], {}, colour(colours[i])};
    const auto x = next(positions, atPosition, 3 * vertices[i]);
    for (std::size_t v = 0; v < vertices[i]; ++v)
      cell.vertices.push_back({x[3 * v], x[3 * v + 1], x[3 * v + 2]});
    const auto c = next(corners, atCorner, 3 * faces[i]);
    for (std::size_t f = 0; f < faces[i]; ++f) {
      Face face;
      for (std::size_t k = 0; k < 3; ++k) face[k] = static_cast<std::int32_t>(c[3 * f + k]);
      cell.faces.push_back(face);
    }
    blank.cells.push_back(std::move(cell));
  }
  return blank;
}

}  // namespace morula::cli
