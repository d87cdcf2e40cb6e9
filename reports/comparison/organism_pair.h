#pragma once
// Pictures that compare two organisms: both side by side, and the distances of their surfaces.
#include <functional>
#include <string>
#include <vector>

#include "drawing/drawing.h"
#include "organism/organism.h"

namespace morula {

/// The distance that the third picture of a comparison maps.
struct DistanceMap {
  bool ofOther = false;    // true: from the vertices of `other` to the surfaces of `one`; false: the other way
  bool ofCentres = false;  // map how far each cell's centroid has moved, with an arrow, instead of vertices
  std::function<std::string(const std::string&)> named = {};  // replaces paths by names of cells, as in "cell AB"
};

/// Three pictures of one size, seen by one camera.
struct ComparisonImages {
  Image one, other, distance;
  std::string unmatched;  // a sentence on cells that only one organism has; "" if both have the same
};

/// Draws `one`, `other`, and a map of distances. Each vertex of the map has the colour of its distance [length] from
/// the surface of the cell with the same path in the other organism; the colour bar is below. Cells that only one
/// organism has are grey. Size, camera direction and titles are those of the pictures; their legends are left out.
/// `eggRadius` [length] is for the caption. Throws InputError as drawOrganism does.
ComparisonImages compareOrganisms(OrganismPicture one, OrganismPicture other, double eggRadius,
                                  const DistanceMap& map = {});

/// Puts the three images in a row, and below them the notes and `unmatched`, a line each.
Drawing comparisonSheet(const ComparisonImages& images, std::vector<std::string> notes = {});

/// Draws comparisonSheet of compareOrganisms.
Drawing drawComparison(OrganismPicture one, OrganismPicture other, double eggRadius);

/// Draws all images as tiles in rows of `columns` (0: as square as possible), `gap` pixels apart. Tiles are as large as
/// the largest image; smaller images are centred. `notes`: lines below the tiles, shortened to the sheet's width.
/// Throws InputError if there is no image.
Drawing contactSheet(const std::vector<Image>& images, int columns = 0, int gap = 8,
                     const std::vector<std::string>& notes = {});

}  // namespace morula
