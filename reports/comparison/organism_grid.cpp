#include "comparison/organism_grid.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "drawing/palette.h"
#include "organism/camera.h"

namespace morula {
namespace {

constexpr double textSize = organismGridText;  // [pixel]
constexpr double most = 190;                   // [pixel] max width of the words before a row
const TextStyle bold{.size = textSize, .colour = ink, .bold = true},
    quiet{.size = smallText * textSize, .colour = quietInk, .anchor = Anchor::centre};

void check(const OrganismGrid& grid) {
  const std::size_t rows = grid.rows.size(), columns = grid.columns.size();
  if (rows == 0 || columns == 0 || grid.tiles.size() != rows * columns)
    throw InputError(std::to_string(grid.tiles.size()) + " pictures do not fill " + std::to_string(rows) + " rows of " +
                     std::to_string(columns));
  if (rows > maxGridRows || columns > maxGridColumns)
    throw InputError("a grid of " + std::to_string(rows) + " rows and " + std::to_string(columns) +
                     " columns is too large for one picture; needs at most " + std::to_string(maxGridRows) + " and " +
                     std::to_string(maxGridColumns));
}

/// Gives all pictures one size and one framing. Returns the framing, or none if all tiles are empty.
std::optional<Framing> frameAlike(std::vector<OrganismTile>& tiles, int side, const Print& print) {
  std::vector<OrganismPicture> shown;
  for (OrganismTile& tile : tiles) {
    OrganismPicture& picture = tile.picture;
    picture.title = picture.caption = "";
    picture.legend.clear();
    picture.instruments = {};
    picture.width = picture.height = static_cast<int>(std::lround(side * print.dots()));
    picture.print.textSize = textSize * print.dots();
    if (!tile.empty && !tile.drawn) shown.push_back(picture);
  }
  if (shown.empty()) return std::nullopt;
  const Framing framing = fitFraming(shown);
  for (OrganismTile& tile : tiles) tile.picture.camera.framing = framing;
  return framing;
}

/// The layout [pixel] of a grid: rows run down blocks, blocks stand side by side, and pages follow each other.
struct Sheet {
  int side = 0, pitch = 0, first = 0,
      block = 0;                        // a tile's side; row to row; block's edge to first tile; width of a block
  int pages = 1, blocks = 1, rows = 1;  // rows of each block
  double room = 0;                      // width of the words before a row
  int heading = 0;                      // height of the columns' headings
  std::size_t rowsOfPage() const { return static_cast<std::size_t>(blocks) * static_cast<std::size_t>(rows); }
};

constexpr double lineHeight = 1.25 * textSize;  // [pixel]

/// Returns the height [pixel] of the longest of these texts in a column of this width.
double heightOf(const std::vector<std::string>& texts, const TextStyle& style, double width) {
  std::size_t lines = 1;
  for (const std::string& text : texts) lines = std::max(lines, wrapped(text, style, width).size());
  return lineHeight * static_cast<double>(lines);
}

/// Draws the text's lines, the first one's baseline at the spot.
void drawWords(Drawing& drawing, Spot at, const std::string& text, const TextStyle& style, double width) {
  for (const std::string& line : wrapped(text, style, width)) {
    drawing.text(at, line, style);
    at.y += lineHeight;
  }
}

/// Returns the words before a row, broken into lines.
std::vector<std::string> rowLines(const std::vector<std::string>& row, double room) {
  std::vector<std::string> lines;
  for (const std::string& text : row)
    for (std::string& line : wrapped(text, bold, room + 1)) lines.push_back(std::move(line));
  return lines;
}

/// Lays out the grid with tiles of this side; 0: as wide as the grid's width leaves.
Sheet layOut(const OrganismGrid& grid, int side) {
  const int maxWidth = grid.width ? grid.width : 1250;
  const double page = grid.height  ? double(grid.height) / grid.width
                      : grid.width ? 1.6
                                   : 1.42;  // max height over width
  const int columns = static_cast<int>(grid.columns.size()), rows = static_cast<int>(grid.rows.size());
  double wordsWidth = 0;
  for (const auto& lines : grid.rows)
    for (const std::string& line : lines)
      wordsWidth = std::max(wordsWidth, textWidth(line, {.size = textSize, .bold = true}));
  Sheet sheet{.side = side, .room = std::min(wordsWidth, grid.width ? 0.25 * grid.width : most)};
  sheet.first = static_cast<int>(2.5 * textSize + sheet.room);
  if (side == 0) sheet.side = side = std::max(40, (grid.width - sheet.first - 12) / columns);
  std::vector<std::string> below;
  for (const OrganismTile& tile : grid.tiles) below.push_back(tile.words);
  sheet.heading = static_cast<int>(0.7 * textSize + heightOf(grid.columns, bold, side - 4));
  double tallest = side + heightOf(below, quiet, side - 4);
  for (const auto& row : grid.rows)
    tallest = std::max(tallest, lineHeight * static_cast<double>(rowLines(row, sheet.room).size()));
  sheet.pitch = static_cast<int>(tallest + textSize);
  sheet.block = grid.width ? grid.width : std::max(480, sheet.first + columns * side + 12);
  const auto fitting = [&](int blocks) {
    const int words = sheet.heading + static_cast<int>(12 * textSize);  // heading, legend and scale bar
    return blocks * std::max(1, (static_cast<int>(page * std::max(blocks * sheet.block, 800)) - words) / sheet.pitch);
  };
  while (rows > fitting(sheet.blocks) && (sheet.blocks + 1) * sheet.block <= maxWidth) ++sheet.blocks;
  sheet.pages = (rows + fitting(sheet.blocks) - 1) / fitting(sheet.blocks);
  const int onPage = (rows + sheet.pages - 1) / sheet.pages;  // the same for all pages, so that no page is almost empty
  sheet.rows = (onPage + sheet.blocks - 1) / sheet.blocks;
  return sheet;
}

/// Lays out the grid with the largest tiles that fit one page, or else with the smallest.
Sheet layOut(const OrganismGrid& grid) {
  if (grid.width) return layOut(grid, 0);
  for (const OrganismTile& tile : grid.tiles)
    if (tile.drawn) return layOut(grid, tile.drawn->width);
  for (const int side : {340, 260})
    if (const Sheet sheet = layOut(grid, side); sheet.pages == 1) return sheet;
  return layOut(grid, 180);
}

void drawRow(Drawing& drawing, const OrganismGrid& grid, std::size_t row, const Sheet& sheet, int left, int top) {
  const auto lines = rowLines(grid.rows[row], sheet.room);
  double baseline = top + sheet.side / 2.0 - 0.65 * textSize * (static_cast<double>(lines.size()) - 2);
  for (const std::string& line : lines) {
    drawing.text({left + 1.5 * textSize, baseline}, line, bold);
    baseline += lineHeight;
  }
  for (std::size_t c = 0; c < grid.columns.size(); ++c) {
    const OrganismTile& tile = grid.tiles[row * grid.columns.size() + c];
    const int x = left + sheet.first + static_cast<int>(c) * sheet.side;
    if (!tile.empty) {
      const Image image = tile.drawn ? *tile.drawn : drawOrganism(tile.picture);
      drawing.image(x, top, image, tile.drawn ? 1 : double(sheet.side) / image.width);
    }
    const double below = tile.empty ? top + sheet.side / 2.0 : top + sheet.side + 0.9 * textSize;
    drawWords(drawing, {x + sheet.side / 2.0, below}, tile.words, quiet, sheet.side - 4);
  }
}

Drawing drawPage(const OrganismGrid& grid, std::size_t begin, std::size_t end, const Sheet& sheet,
                 const Annotations& words, const std::optional<Framing>& framing) {
  const int rows = std::min(sheet.rows, static_cast<int>(end - begin)),
            blocks = (static_cast<int>(end - begin) + rows - 1) / rows;
  Instruments bar;
  bar.scaleBar = framing.has_value(), bar.colourBar = grid.colourBar;
  bar.lengthUnit = grid.lengthUnit, bar.perLength = grid.perLength;
  const int width = blocks * sheet.block,
            body = sheet.heading + rows * sheet.pitch + instrumentsHeight(bar, width, textSize);
  const Bands bands = bandsAround(body, words, width, textSize);
  Drawing drawing(width, body + bands.top + bands.bottom, Drawing::Ground::paper, grid.print);
  annotate(drawing, words, textSize);
  for (int b = 0; b < blocks; ++b) {
    TextStyle centred = bold;
    centred.anchor = Anchor::centre;
    for (std::size_t c = 0; c < grid.columns.size(); ++c)
      drawWords(
          drawing,
          {b * sheet.block + sheet.first + (static_cast<double>(c) + 0.5) * sheet.side, bands.top + 1.3 * textSize},
          grid.columns[c], centred, sheet.side - 4);
    for (int r = 0; r < rows; ++r)
      if (const std::size_t row = begin + static_cast<std::size_t>(b * rows + r); row < end)
        drawRow(drawing, grid, row, sheet, b * sheet.block, bands.top + sheet.heading + r * sheet.pitch);
  }
  if (!framing) return drawing;
  const EyeAxes axes = eyeAxes(grid.tiles[0].picture.camera);
  const double pixelsPerLength = 0.5 * sheet.side / (apertureOf(sheet.side, sheet.side).x * framing->distance);
  drawInstruments(drawing, bar, {axes.x, axes.y, axes.z, pixelsPerLength},
                  bands.top + sheet.heading + static_cast<double>(rows) * sheet.pitch, textSize);
  return drawing;
}

}  // namespace

std::vector<Drawing> drawOrganismGrid(OrganismGrid grid) {
  check(grid);
  const Sheet sheet = layOut(grid);
  const std::optional<Framing> framing = frameAlike(grid.tiles, sheet.side, grid.print);
  const std::size_t pages = (grid.rows.size() + sheet.rowsOfPage() - 1) / sheet.rowsOfPage();
  std::vector<Drawing> drawings;
  for (std::size_t page = 0; page < pages; ++page) {
    Annotations words{grid.title, grid.caption, grid.legend};
    if (pages > 1)
      words.caption +=
          (words.caption.empty() ? "page " : ", page ") + std::to_string(page + 1) + " of " + std::to_string(pages);
    const std::size_t begin = page * sheet.rowsOfPage();
    drawings.push_back(
        drawPage(grid, begin, std::min(begin + sheet.rowsOfPage(), grid.rows.size()), sheet, words, framing));
  }
  return drawings;
}

}  // namespace morula
