#include "comparison/organism_pair.h"

#include <algorithm>
#include <map>
#include <optional>

#include "base/cell_path.h"
#include "base/error.h"
#include "base/number_text.h"
#include "drawing/palette.h"
#include "mesh/distance.h"
#include "mesh/mesh_measures.h"

namespace morula {
namespace {

constexpr double minArrow = 0.02;  // [radii of the egg] a shorter arrow would be only a head

/// Returns for each cell of `of` the place in `beside` of the cell with the same path.
std::vector<std::optional<std::size_t>> matchCells(const OrganismPicture& of, const OrganismPicture& beside) {
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < beside.cells.size(); ++i) places.emplace(beside.cells[i].path, i);
  std::vector<std::optional<std::size_t>> matches;
  for (const CellShape& cell : of.cells) {
    const auto found = places.find(cell.path);
    matches.push_back(found == places.end() ? std::nullopt : std::optional(found->second));
  }
  return matches;
}

std::size_t countUnmatched(const OrganismPicture& of, const OrganismPicture& beside) {
  const auto matches = matchCells(of, beside);
  return static_cast<std::size_t>(std::count(matches.begin(), matches.end(), std::nullopt));
}

std::string cellsOf(std::size_t count) { return std::to_string(count) + (count == 1 ? " cell" : " cells"); }

/// Returns `of`, coloured by its distances from `beside`.
OrganismPicture mapOf(const OrganismPicture& of, const OrganismPicture& beside, double eggRadius,
                      const DistanceMap& what) {
  OrganismPicture map = of;
  const auto matches = matchCells(of, beside);
  std::vector<std::vector<double>> distances(of.cells.size());
  double most = 0, sum = 0;
  std::size_t count = 0;
  std::string where;
  for (std::size_t i = 0; i < of.cells.size(); ++i) {
    if (!matches[i]) continue;
    const CellShape &cell = of.cells[i], &partner = beside.cells[*matches[i]];
    if (what.ofCentres) {
      const Point from = measureCentroid(partner.vertices), to = measureCentroid(cell.vertices);
      distances[i].assign(cell.vertices.size(), norm(to - from));
      if (norm(to - from) > minArrow * eggRadius) map.lines.push_back({from, to, ink, true, true});
    } else {
      distances[i] = measureDistances({cell.vertices, facesOf(of, cell)}, {partner.vertices, facesOf(beside, partner)});
    }
    for (const double d : distances[i]) {
      if (d > most) most = d, where = cell.path;
      sum += d, ++count;
    }
  }
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    map.cells[i].colour = neutralGrey;
    for (const double d : distances[i]) map.cells[i].shares.push_back(most > 0 ? d / most : 0);
  }
  map.title = what.ofCentres ? "displacement of the centroids" : "distance of the surfaces";
  map.caption = most > 0
                    ? "at most " + numberText(most, 3) + " [length], " + numberText(most / eggRadius, 2) +
                          " radii of the egg, of " + cellName(where) + "; mean " + numberText(sum / double(count), 3)
                : count ? "none"
                        : "no cell is in both";
  if (what.named) map.caption = what.named(map.caption);
  map.legend.clear();
  map.instruments.colourBar = ColourBar{"distance [length]", 0, most};
  return map;
}

}  // namespace

ComparisonImages compareOrganisms(OrganismPicture one, OrganismPicture other, double eggRadius,
                                  const DistanceMap& map) {
  // All pictures have one framing and bands of one height, so that they can be overlaid by eye.
  for (OrganismPicture* picture : {&one, &other}) {
    picture->legend.clear();
    picture->instruments.colourBar = ColourBar{.title = "", .blank = true};
  }
  one.camera.framing = other.camera.framing = fitFraming({one, other});
  const OrganismPicture &of = map.ofOther ? other : one, &beside = map.ofOther ? one : other;
  const std::size_t grey = countUnmatched(of, beside), missing = countUnmatched(beside, of);
  ComparisonImages images{drawOrganism(one), drawOrganism(other), drawOrganism(mapOf(of, beside, eggRadius, map)), ""};
  const std::string ofWhich = map.ofOther ? "second" : "first", besideWhich = map.ofOther ? "first" : "second";
  const auto isOnly = [](std::size_t count, const std::string& which) {
    return cellsOf(count) + (count == 1 ? " is" : " are") + " only in the " + which + " picture.";
  };
  if (grey) images.unmatched = "Grey, because these cells cannot be compared: " + isOnly(grey, ofWhich);
  if (missing) images.unmatched += (grey ? " " : "") + isOnly(missing, besideWhich);
  return images;
}

Drawing comparisonSheet(const ComparisonImages& images, std::vector<std::string> notes) {
  if (!images.unmatched.empty()) notes.push_back(images.unmatched);
  return contactSheet({images.one, images.other, images.distance}, 3, 8, notes);
}

Drawing drawComparison(OrganismPicture one, OrganismPicture other, double eggRadius) {
  return comparisonSheet(compareOrganisms(std::move(one), std::move(other), eggRadius));
}

Drawing contactSheet(const std::vector<Image>& images, int columns, int gap, const std::vector<std::string>& notes) {
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
  const double size = textSizeFor(tileWidth, tileHeight);
  const int height = rows * (tileHeight + gap) + gap,
            noteHeight = notes.empty() ? 0 : int((1.6 * double(notes.size()) + 0.8) * size);
  Drawing sheet(columns * (tileWidth + gap) + gap, height + noteHeight);
  for (int i = 0; i < count; ++i)
    sheet.image(gap + i % columns * (tileWidth + gap) + (tileWidth - images[i].width) / 2,
                gap + i / columns * (tileHeight + gap) + (tileHeight - images[i].height) / 2, images[i]);
  for (std::size_t i = 0; i < notes.size(); ++i) {
    const TextStyle style{.size = size, .colour = quietInk};
    sheet.text({1.5 * size + gap, height + (1.6 * double(i) + 1) * size},
               shortened(notes[i], style, sheet.width() - 2 * (1.5 * size + gap)), style);
  }
  return sheet;
}

}  // namespace morula
