#include "trees/lineage_tree.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/cell_path.h"
#include "base/error.h"
#include "base/number_text.h"
#include "drawing/axis.h"
#include "drawing/palette.h"

namespace morula {
namespace {

void check(const LineageNode& node) {
  if (node.path.find_first_not_of("AB") != std::string::npos)
    throw InputError("'" + node.path + "' is not a lineage path; it must be made of the letters A and B");
  if (!std::isfinite(node.born) || !std::isfinite(node.ended))
    throw InputError(cellName(node.path) + " is born or ends at a time that is not finite");
  if (node.ended < node.born) throw InputError(cellName(node.path) + " ends before it is born");
}

constexpr std::size_t maxLabelledTree = 12;  // max leaves of a tree whose inner cells are labelled too

/// The transformation from the tree to the picture, and the widths of lines.
struct Sheet {
  ChartFrame frame;
  Axis time;     // downwards
  double pitch;  // [pixel] between leaves
  double line;   // [pixel] width of a cell's line
  bool upward;   // leaf labels are vertical because they are too wide
  double label;  // [pixel] text size of leaf labels; 0: there are none
  double room;   // [pixel] height for upright labels
  bool cuts;     // labels of inner cells that do not fit are cut, not left out

  double x(double leafUnits) const { return frame.left + 0.5 * frame.textSize + pitch * leafUnits; }
  double y(double when) const { return time.place(when); }
  /// Returns the width of a cell's line. Lines taper from the egg to the leaves, so that crowded trees keep strong
  /// limbs.
  double width(const TreePlace& place) const {
    return std::min(0.28 * frame.textSize, line * std::sqrt(double(place.leaves)));
  }
};

void settleSize(TreePicture& picture, const TreeLayout& layout) {
  const double leaves = double(layout.leaves);
  const double perLeaf = layout.leaves <= maxLabelledTree ? 120 : layout.leaves <= maxLabelledLeaves ? 40 : 8;
  std::size_t depth = 0;
  for (const TreePlace& place : layout.places) depth = std::max(depth, place.node->path.size());
  if (picture.width == 0 && picture.labelsAll)
    picture.width = int(std::clamp(160 + std::max(perLeaf, 11.0) * leaves, 900.0, 16384.0));
  if (picture.width == 0) picture.width = int(std::clamp(160 + perLeaf * leaves, 900.0, 2000.0));
  if (picture.height == 0) picture.height = int(std::clamp(420 + 70.0 * double(depth), 640.0, 1100.0));
  if (picture.print.onPaper()) picture.height = std::min(picture.height, int(1.2 * picture.width));
  for (const int side : {picture.width, picture.height})
    if (side < 64 || side > 16384)
      throw InputError("a lineage tree of " + std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                       " pixels cannot be drawn; width and height must be 64 to 16384, or 0 for what suits");
}

double textSizeOf(const TreePicture& picture) { return textSizeFor(picture.width, picture.height, picture.print); }

double barHeight(const TreePicture& picture) {
  const double size = textSizeOf(picture);
  return picture.colourBar ? colourBarHeight(size) + size : 0;
}

double widestLabel(const TreeLayout& layout, double size) {
  double widest = 0;
  for (const TreePlace& place : layout.places)
    if (place.isLeaf()) widest = std::max(widest, textWidth(place.node->label, {.size = size}));
  return widest;
}

Sheet makeSheet(const TreePicture& picture, const TreeLayout& layout, const Annotations& words) {
  const double size = textSizeOf(picture);
  const Bands bands = bandsFor(words, picture.width, picture.height, size);
  Sheet sheet{};
  sheet.time = {.low = layout.begin, .high = layout.end};
  sheet.frame = {.left = roomForUprightAxis(sheet.time, size),
                 .top = bands.top + 1.5 * size,
                 .right = picture.width - 1.5 * size,
                 .bottom = 0,
                 .textSize = size};
  sheet.pitch = (sheet.frame.right - sheet.x(0)) / std::max(1.0, double(layout.leaves));
  sheet.line = std::clamp(0.25 * sheet.pitch, 1.0, 0.2 * size);
  sheet.cuts = !picture.print.onPaper();
  sheet.room = (sheet.cuts ? 0.25 : 0.4) * picture.height - size;
  double below = 1.2 * size;
  if (picture.labelsAll) sheet.label = std::min(size, 0.85 * sheet.pitch);
  else if (layout.leaves <= maxLabelledLeaves) sheet.label = size;
  if (picture.print.onPaper() && sheet.label > 0) {
    sheet.label = std::min(size, 0.95 * sheet.pitch);
    const double least = smallText * size, millimetres = picture.width * picture.print.pixel * 25.4 / 72;
    if (sheet.label < least && picture.labelsAll)
      throw InputError("the labels of " + std::to_string(layout.leaves) + " cells do not fit into " +
                       numberText(millimetres, 3) + " mm; needs at least " +
                       numberText(std::ceil(millimetres * least / sheet.label), 4) +
                       " mm, a smaller font, or no labels");
    if (sheet.label < least) sheet.label = 0;
  }
  if (sheet.label > 0) {
    const double widest = widestLabel(layout, sheet.label);
    sheet.upward = widest > sheet.pitch - 0.6 * size;
    below += sheet.upward ? std::min(widest + size, sheet.room + size) : 1.2 * size;
  }
  sheet.frame.bottom = std::max(sheet.frame.top + 8, picture.height - bands.bottom - barHeight(picture) - below);
  sheet.time.from = sheet.frame.top, sheet.time.to = sheet.frame.bottom;
  return sheet;
}

/// Draws a cell's line: from the mother's line sideways, round the corner and down to its end.
void drawCell(Drawing& drawing, const Sheet& sheet, const TreeLayout& layout, const TreePlace& place) {
  const Spot birth{sheet.x(place.x), sheet.y(place.node->born)}, end{birth.x, sheet.y(place.node->ended)};
  std::vector<Spot> points{birth, end};
  if (place.mother >= 0) points.insert(points.begin(), {sheet.x(layout.places[place.mother].x), birth.y});
  drawing.line(points, {sheet.width(place), place.node->colour, false, 0.6 * sheet.frame.textSize});
}

void drawEnd(Drawing& drawing, const Sheet& sheet, const TreePlace& place) {
  const Spot end{sheet.x(place.x), sheet.y(place.node->ended)};
  if (place.node->fate == Fate::died) {
    const double arm = std::clamp(0.4 * sheet.pitch, 1.6, 0.4 * sheet.frame.textSize);
    const Stroke stroke{std::clamp(0.4 * arm, 0.8, 2.2), ink};
    drawing.line({{end.x - arm, end.y - arm}, {end.x + arm, end.y + arm}}, stroke);
    drawing.line({{end.x - arm, end.y + arm}, {end.x + arm, end.y - arm}}, stroke);
  } else if (place.node->fate == Fate::alive && sheet.pitch >= 3 * sheet.line) {
    drawing.disc(end, 1.6 * sheet.line, place.node->colour);
  }
}

void drawLeafLabel(Drawing& drawing, const Sheet& sheet, const TreePlace& place) {
  const double size = sheet.label;
  const Spot below{sheet.x(place.x), sheet.y(place.node->ended) + 0.9 * sheet.frame.textSize};
  if (!sheet.upward) {
    drawing.text({below.x, below.y + 0.75 * size}, place.node->label,
                 {.size = size, .colour = ink, .anchor = Anchor::centre});
    return;
  }
  const TextStyle style{.size = size, .colour = ink, .anchor = Anchor::right, .upward = true};
  drawing.text({below.x + 0.36 * size, below.y}, shortened(place.node->label, style, sheet.room), style);
}

/// Draws the times of deeds that are done to all cells.
void drawTimes(Drawing& drawing, const Sheet& sheet, const std::vector<TreeMark>& marks) {
  for (const TreeMark& mark : marks)
    if (const double y = sheet.y(mark.time); !mark.path)
      drawing.line({{sheet.frame.left, y}, {sheet.frame.right, y}}, {.width = 1, .colour = quietInk, .dashed = true});
}

/// Draws a ring for each deed that is done to a cell. The cross of a cell that is killed is drawn into it afterwards.
void drawMarks(Drawing& drawing, const Sheet& sheet, const TreeLayout& layout, const std::vector<TreeMark>& marks) {
  const double radius = std::clamp(0.4 * sheet.pitch, 2.5, 0.6 * sheet.frame.textSize);
  for (const TreeMark& mark : marks) {
    if (!mark.path) continue;
    const double y = sheet.y(mark.time);
    const auto place = std::ranges::find(layout.places, *mark.path, [](const TreePlace& p) { return p.node->path; });
    if (place != layout.places.end()) drawMarker(drawing, {sheet.x(place->x), y}, radius, ink, Marker::ring);
  }
}

/// Draws a cell's label beside its line, and its letter A or B at the corner.
void drawInnerLabels(Drawing& drawing, const Sheet& sheet, const TreePlace& place) {
  const double x = sheet.x(place.x), size = smallText * sheet.frame.textSize, width = sheet.width(place);
  if (!place.isLeaf()) {
    const TextStyle style{.size = size, .colour = quietInk};
    const double middle = 0.5 * (sheet.y(place.node->born) + sheet.y(place.node->ended));
    const std::string label = shortened(place.node->label, style, 0.9 * sheet.pitch - width);
    if (sheet.cuts || label == place.node->label)
      drawing.text({x + width + 0.3 * size, middle + 0.36 * size}, label, style);
  }
  if (place.mother < 0) return;
  const bool b = place.node->path.back() == 'B';
  drawing.text({x, sheet.y(place.node->born) - width - 0.2 * size}, b ? "B" : "A",
               {.size = size, .colour = quietInk, .anchor = b ? Anchor::right : Anchor::left});
}

}  // namespace

TreeLayout layoutTree(const std::vector<LineageNode>& nodes) {
  TreeLayout layout;
  for (const LineageNode& node : nodes) {
    check(node);
    layout.places.push_back({.node = &node});
  }
  std::vector<TreePlace>& places = layout.places;
  std::sort(places.begin(), places.end(),
            [](const TreePlace& a, const TreePlace& b) { return a.node->path < b.node->path; });
  if (places.empty()) return layout;
  layout.begin = places.front().node->born;
  layout.end = places.front().node->ended;
  // `line` holds the cells from a root down to the last one visited: a path's mother is always among them
  std::vector<int> line;
  for (int i = 0; i < int(places.size()); ++i) {
    const std::string& path = places[i].node->path;
    if (i > 0 && path == places[i - 1].node->path) throw InputError(cellName(path) + " appears twice in the tree");
    while (!line.empty() && !path.starts_with(places[line.back()].node->path)) line.pop_back();
    if (!line.empty() && places[line.back()].node->path.size() + 1 == path.size()) {
      places[i].mother = line.back();
      places[line.back()].daughter[path.back() == 'B'] = i;
    }
    line.push_back(i);
    layout.begin = std::min(layout.begin, places[i].node->born);
    layout.end = std::max(layout.end, places[i].node->ended);
  }
  for (TreePlace& place : places)
    if (place.isLeaf()) place.x = double(layout.leaves++) + 0.5;
  for (std::size_t i = places.size(); i-- > 0;) {  // daughters stand behind their mothers, so they are placed first
    TreePlace& place = places[i];
    if (place.isLeaf()) continue;
    const auto [a, b] = place.daughter;
    place.leaves = (a < 0 ? 0 : places[a].leaves) + (b < 0 ? 0 : places[b].leaves);
    place.x = a < 0 ? places[b].x : b < 0 ? places[a].x : 0.5 * (places[a].x + places[b].x);
  }
  return layout;
}

Drawing drawLineage(const TreePicture& asked) {
  TreePicture picture = asked;
  const TreeLayout layout = layoutTree(picture.nodes);
  settleSize(picture, layout);
  Annotations words{picture.title, picture.caption, picture.legend};
  const auto died = [](const LineageNode& node) { return node.fate == Fate::died; };
  if (std::any_of(picture.nodes.begin(), picture.nodes.end(), died))
    words.legend.push_back({ink, "died", Marker::cross});
  if (!picture.marks.empty()) words.legend.push_back({ink, "experiment", Marker::ring});
  Drawing drawing(picture.width, picture.height, Drawing::Ground::paper, picture.print);
  annotate(drawing, words, picture.print.textSize);
  if (layout.places.empty()) return drawing;
  if (const double size = textSizeOf(picture); picture.colourBar)
    drawColourBar(
        drawing, *picture.colourBar,
        {1.5 * size, picture.height - bandsFor(words, picture.width, picture.height, size).bottom - barHeight(picture)},
        std::min(picture.width - 3 * size, 24 * size), size);
  const Sheet sheet = makeSheet(picture, layout, words);
  drawUprightAxis(drawing, sheet.frame, sheet.time, picture.timeLabel);
  drawTimes(drawing, sheet, picture.marks);
  // Cells are drawn from the leaves up, so that mothers lie on top at divisions.
  for (auto place = layout.places.rbegin(); place != layout.places.rend(); ++place)
    drawCell(drawing, sheet, layout, *place);
  drawMarks(drawing, sheet, layout, picture.marks);
  for (const TreePlace& place : layout.places) {
    if (place.isLeaf()) drawEnd(drawing, sheet, place);
    if (place.isLeaf() && sheet.label > 0) drawLeafLabel(drawing, sheet, place);
    if (layout.leaves <= maxLabelledTree) drawInnerLabels(drawing, sheet, place);
  }
  return drawing;
}

}  // namespace morula
