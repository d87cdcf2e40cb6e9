#include "comparison/comparison.h"

#include <algorithm>

#include "base/error.h"
#include "base/number_text.h"
#include "mesh/distance.h"

namespace morula {
namespace {

OrganismPicture mapOf(const OrganismPicture& one, const OrganismPicture& other, double eggRadius) {
  OrganismPicture map = one;
  std::vector<std::vector<double>> distances;
  double most = 0;
  for (std::size_t i = 0; i < one.cells.size(); ++i) {
    distances.push_back(measureDistances({one.cells[i].vertices, facesOf(one, one.cells[i])},
                                         {other.cells[i].vertices, facesOf(other, other.cells[i])}));
    for (const double d : distances.back()) most = std::max(most, d);
  }
  for (std::size_t i = 0; i < map.cells.size(); ++i)
    for (const double d : distances[i]) map.cells[i].shares.push_back(most > 0 ? d / most : 0);
  map.title = "distance of the surfaces";
  map.caption = "at most " + numberText(most, 3) + " [length], " + numberText(most / eggRadius, 2) +
                " radii of the egg";
  map.legend.clear();
  map.instruments.colourBar = ColourBar{"distance [length]", 0, most};
  return map;
}

}  // namespace

Drawing drawComparison(OrganismPicture one, OrganismPicture other, double eggRadius) {
  if (one.cells.size() != other.cells.size())
    throw InputError("organisms of " + std::to_string(one.cells.size()) + " and " +
                     std::to_string(other.cells.size()) + " cells cannot be compared cell by cell");
  // One framing and one band of words, so that the three can be laid over each other by eye.
  for (OrganismPicture* picture : {&one, &other}) {
    picture->legend.clear();
    picture->instruments.colourBar = ColourBar{.title = "", .blank = true};
  }
  one.camera.framing = other.camera.framing = fitFraming({one, other});
  const OrganismPicture map = mapOf(one, other, eggRadius);
  return contactSheet({drawOrganism(one), drawOrganism(other), drawOrganism(map)}, 3);
}

Drawing contactSheet(const std::vector<Image>& images, int columns, int gap) {
  if (images.empty()) throw InputError("a contact sheet needs at least one image");
  const int count = int(images.size());
  if (columns <= 0)
    for (columns = 1; columns * columns < count;) ++columns;
  columns = std::min(columns, count);
  const int rows = (count + columns - 1) / columns;
  int tileWidth = 0, tileHeight = 0;
  for (const Image& image : images) {
    tileWidth = std::max(tileWidth, image.width);
    tileHeight = std::max(tileHeight, image.height);
  }
  Drawing sheet(columns * (tileWidth + gap) + gap, rows * (tileHeight + gap) + gap);
  for (int i = 0; i < count; ++i)
    sheet.image(gap + i % columns * (tileWidth + gap) + (tileWidth - images[i].width) / 2,
                gap + i / columns * (tileHeight + gap) + (tileHeight - images[i].height) / 2, images[i]);
  return sheet;
}

}  // namespace morula
