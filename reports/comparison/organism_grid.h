#pragma once
// Many organisms in rows and columns, seen by one camera at one scale.
#include <optional>
#include <string>
#include <vector>

#include "drawing/drawing.h"
#include "organism/organism.h"

namespace morula {

struct OrganismTile {
  OrganismPicture picture;       // words, legend, size and framing are ignored
  bool empty = false;            // only `words` are drawn
  std::string words;             // below the picture
  std::optional<Image> drawn{};  // a picture with a scale bar of its own, in place of `picture`
};

struct OrganismGrid {
  std::string title, caption;
  std::vector<std::vector<std::string>> rows;  // the lines of words before each row
  std::vector<std::string> columns;            // the heading of each column
  std::vector<OrganismTile> tiles;             // row by row
  std::vector<LegendEntry> legend;             // one for all tiles, below them
  std::optional<ColourBar> colourBar{};        // one for all tiles
  std::string lengthUnit = "[length]";         // unit of the scale bar
  double perLength = 1;                        // number of these units in one length; > 0
  int width = 0, height = 0;                   // [pixel] of a page, at most; 0: what suits
  Print print = {};
};

/// Size [pixel] of ordinary text in a grid.
inline constexpr double organismGridText = 15;

inline constexpr std::size_t maxGridRows = 40, maxGridColumns = 12;

/// Returns pages that are not much higher than wide. If columns are few, rows go on side by side, then on further
/// pages. All tiles share one camera and one scale; each page has title, legend and scale bar. Throws InputError if
/// there are no tiles, too many rows or columns, or a number of tiles that does not fit them; also as drawOrganism
/// does.
std::vector<Drawing> drawOrganismGrid(OrganismGrid grid);

}  // namespace morula
