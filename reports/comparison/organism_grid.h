#pragma once
// Many organisms in rows and columns, seen by one camera at one scale.
#include <optional>
#include <string>
#include <vector>

#include "drawing/drawing.h"
#include "organism/organism.h"

namespace morula {

struct OrganismTile {
  OrganismPicture picture;       // its words, legend, size and framing are not used
  bool empty = false;            // nothing is drawn but the words
  std::string words;             // one line below it
  std::optional<Image> drawn{};  // a picture with a scale bar of its own, in place of `picture`
};

struct OrganismGrid {
  std::string title, caption;
  std::vector<std::vector<std::string>> rows;  // the lines that stand before each row
  std::vector<std::string> columns;            // what stands above each column
  std::vector<OrganismTile> tiles;             // row by row
  std::vector<LegendEntry> legend;             // once, below all
  std::optional<ColourBar> colourBar{};        // likewise
  std::string lengthUnit = "[length]";         // that the scale bar's number is in
  double perLength = 1;                        // so many of it are one length; > 0
};

inline constexpr std::size_t maxGridRows = 40, maxGridColumns = 12;

/// Pages that are no higher than a sheet of paper beside their width: where columns are few, rows go on beside each
/// other, and then on further pages. One camera and one scale for all; each page has title, legend and scale bar. Tiles
/// are smaller the more there are. Throws InputError for no tile, more rows or columns than there is room for, a number
/// of tiles that does not fit them, and as drawOrganism does.
std::vector<Drawing> drawOrganismGrid(OrganismGrid grid);

}  // namespace morula
