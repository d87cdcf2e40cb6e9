#pragma once
// Organisms that should be the same, side by side, and how far their surfaces are apart.
#include <vector>

#include "drawing/drawing.h"
#include "organism/organism.h"

namespace morula {

/// Three pictures in a row, seen from one place: `one`, `other`, and `one` again, each vertex in the colour
/// of its distance [length] from the same cell's surface in `other`, with their scale below. The same cells
/// stand in both, in one order. Size, camera direction and titles are those of the two; their legends are
/// left out. `eggRadius` [length] is for the caption. Throws InputError as drawOrganism does, and if the
/// numbers of cells differ.
Drawing drawComparison(OrganismPicture one, OrganismPicture other, double eggRadius);
/// The three pictures of it, each by itself: one, other, distances.
std::vector<Image> comparisonPanels(OrganismPicture one, OrganismPicture other, double eggRadius);

/// All images as tiles in rows of `columns` (0: as square as possible), with a gap of `gap` pixels. Tiles are
/// as large as the largest image; smaller ones stand centred. Throws InputError for no image.
Drawing contactSheet(const std::vector<Image>& images, int columns = 0, int gap = 8);

}  // namespace morula
