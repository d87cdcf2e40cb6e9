#include "comparison/organism_grid.h"

#include <algorithm>

#include "base/error.h"
#include "drawing/palette.h"
#include "organism/camera.h"

namespace morula {
namespace {

constexpr double textSize = 15;  // [pixel]
constexpr double most = 190;     // [pixel] of the words before a row

/// [pixel] of a tile's side.
int sideFor(std::size_t rows, std::size_t columns) {
  return rows * columns <= 12 ? 340 : rows * columns <= 60 ? 260 : 180;
}

void check(const OrganismGrid& grid) {
  const std::size_t rows = grid.rows.size(), columns = grid.columns.size();
  if (rows == 0 || columns == 0 || grid.tiles.size() != rows * columns)
    throw InputError(std::to_string(grid.tiles.size()) + " pictures do not fill " + std::to_string(rows) +
                     " rows of " + std::to_string(columns));
  if (rows > mostGridRows || columns > mostGridColumns)
    throw InputError("a grid of " + std::to_string(rows) + " rows and " + std::to_string(columns) +
                     " columns is too large for one picture; it has room for " +
                     std::to_string(mostGridRows) + " and " + std::to_string(mostGridColumns));
}

/// Gives all pictures one size and one framing, and returns it. All empty: nothing.
std::optional<Framing> frameAlike(std::vector<OrganismTile>& tiles, int side) {
  std::vector<OrganismPicture> shown;
  for (OrganismTile& tile : tiles) {
    OrganismPicture& picture = tile.picture;
    picture.title = picture.caption = "";
    picture.legend.clear();
    picture.instruments = {};
    picture.width = picture.height = side;
    if (!tile.empty) shown.push_back(picture);
  }
  if (shown.empty()) return std::nullopt;
  const Framing framing = fitFraming(shown);
  for (OrganismTile& tile : tiles) tile.picture.camera.framing = framing;
  return framing;
}

}  // namespace

Drawing drawOrganismGrid(OrganismGrid grid) {
  check(grid);
  const std::size_t rows = grid.rows.size(), columns = grid.columns.size();
  const int side = sideFor(rows, columns), pitch = side + static_cast<int>(2.2 * textSize);
  const std::optional<Framing> framing = frameAlike(grid.tiles, side);
  const TextStyle bold{.size = textSize, .colour = ink, .bold = true};
  double wordsWidth = 0;
  for (const auto& lines : grid.rows)
    for (const std::string& line : lines) wordsWidth = std::max(wordsWidth, textWidth(line, bold));
  const double left = 1.5 * textSize, room = std::min(wordsWidth, most);
  const int first = static_cast<int>(left + room + textSize),
            width = std::max(480, first + static_cast<int>(columns) * side + 12);
  Instruments instruments;
  instruments.scaleBar = framing.has_value();
  const int scaleHeight = instrumentsHeight(instruments, width, textSize),
            heading = static_cast<int>(2 * textSize);
  const int body = heading + static_cast<int>(rows) * pitch + scaleHeight;
  const Annotations words{grid.title, grid.caption, grid.legend};
  // The bands are at most a quarter of the whole height each, and so depend on it.
  Bands bands;
  int height = body;
  for (int i = 0; i < 16; ++i) {
    bands = bandsFor(words, width, height, textSize);
    height = body + bands.top + bands.bottom;
  }

  Drawing drawing(width, height);
  annotate(drawing, words, textSize);
  for (std::size_t c = 0; c < columns; ++c) {
    TextStyle style = bold;
    style.anchor = Anchor::centre;
    drawing.text({first + (static_cast<double>(c) + 0.5) * side, bands.top + 1.3 * textSize},
                 shortened(grid.columns[c], style, side - textSize), style);
  }
  for (std::size_t r = 0; r < rows; ++r) {
    const int top = bands.top + heading + static_cast<int>(r) * pitch;
    const auto& lines = grid.rows[r];
    double baseline = top + side / 2.0 - 0.65 * textSize * (static_cast<double>(lines.size()) - 2);
    for (const std::string& line : lines) {
      drawing.text({left, baseline}, shortened(line, bold, room + 1), bold);
      baseline += 1.3 * textSize;
    }
    for (std::size_t c = 0; c < columns; ++c) {
      const OrganismTile& tile = grid.tiles[r * columns + c];
      const int x = first + static_cast<int>(c) * side;
      if (!tile.empty) drawing.image(x, top, drawOrganism(tile.picture));
      const TextStyle quiet{.size = 0.87 * textSize, .colour = quietInk, .anchor = Anchor::centre};
      const double below = tile.empty ? top + side / 2.0 : top + side + 0.9 * textSize;
      drawing.text({x + side / 2.0, below}, shortened(tile.words, quiet, side - 8), quiet);
    }
  }
  if (framing) {
    const EyeAxes axes = eyeAxes(grid.tiles[0].picture.camera);
    const double pixelsPerLength = 0.5 * side / (apertureOf(side, side).x * framing->distance);
    drawInstruments(drawing, instruments, {axes.x, axes.y, axes.z, pixelsPerLength},
                    bands.top + heading + static_cast<double>(rows) * pitch, textSize);
  }
  return drawing;
}

}  // namespace morula
