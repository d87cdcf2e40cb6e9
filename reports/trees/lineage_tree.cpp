#include "trees/lineage_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "drawing/annotations.h"
#include "drawing/canvas.h"
#include "drawing/text.h"
#include "trees/tree_layout.h"

namespace morula {
namespace {

constexpr Colour ink{0x2a, 0x2e, 0x33}, axisInk{0x6a, 0x70, 0x77}, gridInk{0xe6, 0xe6, 0xe2};
constexpr std::size_t maxLabelledTree = 12;  // leaves up to which inner cells are labelled too

/// Where tree units lie in the picture, and how thick things are there.
struct Sheet {
  double left, top, right, bottom;  // [pixel] of the tree itself
  double begin, end;                // [time] at top and bottom
  double pitch;                     // [pixel] between leaves
  double line;                      // [pixel] width of a cell's line
  double textSize;                  // [pixel]
  bool upward;                      // leaf labels read upward because they are too wide

  double x(double leafUnits) const { return left + pitch * leafUnits; }
  /// Lines taper from the egg to the leaves, as branches do: a crowded tree keeps strong limbs.
  double width(const TreePlace& place) const {
    return std::min(0.28 * textSize, line * std::sqrt(double(place.leaves)));
  }
  double y(double time) const {
    return end > begin ? top + (bottom - top) * (time - begin) / (end - begin) : top;
  }
};

void settleSize(TreePicture& picture, const TreeLayout& layout) {
  const double leaves = double(layout.leaves);
  const double perLeaf = layout.leaves <= maxLabelledTree ? 120 : layout.leaves <= maxLabelledLeaves ? 40 : 8;
  std::size_t depth = 0;
  for (const TreePlace& place : layout.places) depth = std::max(depth, place.node->path.size());
  if (picture.width == 0) picture.width = int(std::clamp(160 + perLeaf * leaves, 900.0, 2000.0));
  if (picture.height == 0) picture.height = int(std::clamp(420 + 70.0 * double(depth), 640.0, 1100.0));
  for (const int side : {picture.width, picture.height})
    if (side < 64 || side > 16384)
      throw InputError("a lineage tree of " + std::to_string(picture.width) + " x " +
                       std::to_string(picture.height) +
                       " pixels cannot be drawn; width and height must be 64 to 16384, or 0 for what suits");
}

/// [pixel] Beyond `most` it does not matter how much wider.
double widestLabel(const TreeLayout& layout, double size, double most) {
  const TextStyle style{.size = size};
  double widest = 0;
  for (const TreePlace& place : layout.places)
    if (place.isLeaf())
      widest = std::max(widest, textWidth(beginningWiderThan(place.node->label, style, most), style));
  return widest;
}

Sheet makeSheet(const TreePicture& picture, const TreeLayout& layout, const Annotations& words) {
  const Bands bands = bandsFor(words, picture.width, picture.height);
  Sheet sheet{};
  sheet.textSize = textSizeFor(picture.width, picture.height);
  sheet.left = 4.5 * sheet.textSize;
  sheet.right = picture.width - 1.5 * sheet.textSize;
  sheet.top = bands.top + 1.5 * sheet.textSize;
  sheet.pitch = (sheet.right - sheet.left) / std::max(1.0, double(layout.leaves));
  sheet.line = std::clamp(0.25 * sheet.pitch, 1.0, 0.2 * sheet.textSize);
  double below = 1.2 * sheet.textSize;
  if (layout.leaves <= maxLabelledLeaves) {
    const double widest = widestLabel(layout, sheet.textSize, std::max(picture.width, picture.height));
    sheet.upward = widest > sheet.pitch - 0.6 * sheet.textSize;
    below += sheet.upward ? std::min(widest + sheet.textSize, 0.25 * picture.height) : 1.2 * sheet.textSize;
  }
  sheet.bottom = std::max(sheet.top + 8, picture.height - bands.bottom - below);
  sheet.begin = layout.begin;
  sheet.end = layout.end;
  return sheet;
}

void drawAxis(Image& image, const Sheet& sheet) {
  const double x = sheet.left - 0.5 * sheet.textSize;
  const int wanted = std::clamp(int((sheet.bottom - sheet.top) / (4 * sheet.textSize)), 2, 10);
  for (const double tick : axisTicks(sheet.begin, sheet.end, wanted)) {
    const double y = std::floor(sheet.y(tick)) + 0.5;  // on the middle of a row: one crisp line
    drawStroke(image, {{x, y}, {sheet.right, y}}, 1, gridInk);
    drawStroke(image, {{x - 0.35 * sheet.textSize, y}, {x, y}}, 1, axisInk);
    drawText(image, x - 0.6 * sheet.textSize, y + 0.36 * sheet.textSize, fmt::format("{:.6g}", tick),
             {.size = 0.9 * sheet.textSize, .colour = axisInk, .anchor = Anchor::right});
  }
  const double middle = std::floor(x) + 0.5;
  drawStroke(image, {{middle, sheet.top}, {middle, sheet.bottom}}, 1, axisInk);
  drawText(image, 1.35 * sheet.textSize, 0.5 * (sheet.top + sheet.bottom), "time",
           {.size = 0.9 * sheet.textSize, .colour = axisInk, .anchor = Anchor::centre, .upward = true});
}

/// From the mother's line sideways, round the corner and down to the end.
std::vector<Spot> lineOf(const Sheet& sheet, const TreeLayout& layout, const TreePlace& place) {
  const double x = sheet.x(place.x), end = sheet.y(place.node->ended);
  if (place.mother < 0) return {{x, sheet.y(place.node->born)}, {x, end}};
  const double start = sheet.x(layout.places[place.mother].x), y = sheet.y(place.node->born);
  const double radius = std::min({0.6 * sheet.textSize, 0.5 * std::abs(x - start), 0.5 * (end - y)});
  const double side = x < start ? -1 : 1;
  std::vector<Spot> points{{start, y}};
  for (int i = 0; i <= 6; ++i) {  // a quarter circle about (x − side·r, y + r)
    const double angle = i * 3.14159265358979 / 12;
    points.push_back({x - side * radius * (1 - std::sin(angle)), y + radius * (1 - std::cos(angle))});
  }
  points.push_back({x, end});
  return points;
}

void drawEnd(Image& image, const Sheet& sheet, const TreePlace& place) {
  const Spot end{sheet.x(place.x), sheet.y(place.node->ended)};
  if (place.node->fate == Fate::died) {
    const double arm = std::clamp(0.4 * sheet.pitch, 1.6, 0.4 * sheet.textSize);
    const double width = std::clamp(0.4 * arm, 0.8, 2.2);
    drawStroke(image, {{end.x - arm, end.y - arm}, {end.x + arm, end.y + arm}}, width, ink);
    drawStroke(image, {{end.x - arm, end.y + arm}, {end.x + arm, end.y - arm}}, width, ink);
  } else if (place.node->fate == Fate::alive && sheet.pitch >= 3 * sheet.line) {
    drawDisc(image, end, 1.6 * sheet.line, place.node->colour);
  }
}

void drawLeafLabel(Image& image, const Sheet& sheet, const TreePlace& place) {
  const double x = sheet.x(place.x), y = sheet.y(place.node->ended) + 0.9 * sheet.textSize;
  TextStyle style{.size = sheet.textSize, .colour = ink, .anchor = Anchor::centre};
  if (!sheet.upward) {
    drawText(image, x, y + 0.75 * sheet.textSize, place.node->label, style);
    return;
  }
  style.anchor = Anchor::right;
  style.upward = true;
  const std::string label = shortened(place.node->label, style, 0.25 * image.height - sheet.textSize);
  drawText(image, x + 0.36 * sheet.textSize, y, label, style);
}

/// The state beside the line, and at the corner the letter that the division gave.
void drawInnerLabels(Image& image, const Sheet& sheet, const TreePlace& place) {
  const double x = sheet.x(place.x), size = 0.9 * sheet.textSize;
  if (!place.isLeaf()) {
    const TextStyle style{.size = size, .colour = axisInk};
    const double middle = 0.5 * (sheet.y(place.node->born) + sheet.y(place.node->ended));
    drawText(image, x + sheet.width(place) + 0.3 * size, middle + 0.36 * size,
             shortened(place.node->label, style, 0.9 * sheet.pitch - sheet.width(place)), style);
  }
  if (place.mother < 0) return;
  const bool b = place.node->path.back() == 'B';
  drawText(image, x, sheet.y(place.node->born) - sheet.width(place) - 0.2 * size,
           std::string_view(b ? "B" : "A"),
           {.size = 0.8 * size, .colour = axisInk, .anchor = b ? Anchor::right : Anchor::left});
}

}  // namespace

Image drawLineage(const TreePicture& asked) {
  TreePicture picture = asked;
  const TreeLayout layout = layoutTree(picture.nodes);
  settleSize(picture, layout);
  const Annotations words{picture.title, picture.caption, picture.legend};
  Image image(picture.width, picture.height, paper);
  annotate(image, words);
  if (layout.places.empty()) return image;
  const Sheet sheet = makeSheet(picture, layout, words);
  drawAxis(image, sheet);
  // From the leaves up, so that at a division the mother lies on top.
  for (auto place = layout.places.rbegin(); place != layout.places.rend(); ++place)
    drawStroke(image, lineOf(sheet, layout, *place), sheet.width(*place), place->node->colour);
  for (const TreePlace& place : layout.places) {
    if (place.isLeaf()) drawEnd(image, sheet, place);
    if (place.isLeaf() && layout.leaves <= maxLabelledLeaves) drawLeafLabel(image, sheet, place);
    if (layout.leaves <= maxLabelledTree) drawInnerLabels(image, sheet, place);
  }
  return image;
}

}  // namespace morula
