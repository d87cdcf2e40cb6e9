#pragma once
// Organisms that should be the same, side by side, and how far their surfaces are apart.
#include <functional>
#include <string>
#include <vector>

#include "drawing/drawing.h"
#include "organism/organism.h"

namespace morula {

/// The distance that the third picture of a comparison maps.
struct DistanceMap {
  bool ofOther = false;    // the vertices of `other` beside the surfaces of `one`; else those of `one` beside `other`
  bool ofCentres = false;  // how far the centroid of each cell has moved, with an arrow, in place of its vertices
  std::function<std::string(const std::string&)> named = {};  // puts names of cells into words, for "cell AB"
};

/// The three pictures, of one size and seen from one place.
struct ComparisonImages {
  Image one, other, distance;
  std::string unmatched;  // a sentence on the cells that only one of the two has; "" if both have the same
};

/// `one`, `other`, and the cells of one of them with each vertex in the colour of its distance [length] from the
/// surface that the cell of the same path has in the other one, with their scale below. Cells that only one of the two
/// has are grey there: nothing can be said of them. Size, camera direction and titles are those of the two; their
/// legends are left out. `eggRadius` [length] is for the caption. Throws InputError as drawOrganism does.
ComparisonImages compareOrganisms(OrganismPicture one, OrganismPicture other, double eggRadius,
                                  const DistanceMap& map = {});

/// The three in a row, and below them the notes and what is unmatched, a line each.
Drawing comparisonSheet(const ComparisonImages& images, std::vector<std::string> notes = {});

/// comparisonSheet of compareOrganisms, for organisms with the same cells in one order. Throws InputError if
/// their numbers differ.
Drawing drawComparison(OrganismPicture one, OrganismPicture other, double eggRadius);

/// All images as tiles in rows of `columns` (0: as square as possible), with a gap of `gap` pixels. Tiles are as large
/// as the largest image; smaller ones stand centred. `notes`: lines below all of them, shortened to the sheet's width.
/// Throws InputError for no image.
Drawing contactSheet(const std::vector<Image>& images, int columns = 0, int gap = 8,
                     const std::vector<std::string>& notes = {});

}  // namespace morula
