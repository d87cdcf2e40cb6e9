#include "pictures/picture_maker.h"

#include <algorithm>
#include <cmath>

#include "biology/substance_pattern.h"
#include "drawing/palette.h"
#include "pictures/pictures.h"

namespace morula {

namespace {

constexpr Colour connectionColour{0x6a, 0x3d, 0x9a}, normalColour{0x77, 0x77, 0x77};

Point middleOf(const CellShape& cell) {
  Point middle;
  for (const Point& p : cell.vertices) middle += p / double(cell.vertices.size());
  return middle;
}

/// [length] The mean distance of a vertex from its cell's middle.
double meanRadius(const OrganismPicture& picture, std::size_t cells) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    const Point middle = middleOf(picture.cells[i]);
    for (const Point& p : picture.cells[i].vertices) sum += norm(p - middle), ++count;
  }
  return count ? sum / double(count) : 1;
}

void addConnections(OrganismPicture& picture, const World& world) {
  for (const std::size_t place : world.connections->active) {
    const ConnectionRecord& record = world.connections->history[place];
    const int a = cellNumber(world.cells, record.a), b = cellNumber(world.cells, record.b);
    if (a >= 0 && b >= 0)
      picture.lines.push_back(
          {middleOf(picture.cells[a]), middleOf(picture.cells[b]), connectionColour, true});
  }
}

void setOpacities(OrganismPicture& picture, const World& world, const std::vector<CellOpacity>& opacities) {
  for (std::size_t i = 0; i < world.cells.path.size(); ++i)
    for (const CellOpacity& wish : opacities)
      if (wish.pattern == "*" || fitsAny(wish.pattern, world.biology->describe(world.cells.state[i])))
        picture.cells[i].opacity = wish.opacity;
}

void addLabels(OrganismPicture& picture, const World& world, const Scenario& scenario, Labels labels) {
  for (std::size_t i = 0; i < world.cells.path.size(); ++i) {
    const CellPath& path = world.cells.path[i];
    const std::string plain = path.isEgg() ? "egg" : path.text();
    picture.labels.push_back({i, labels == Labels::name ? scenario.names.of(path).value_or(plain) : plain});
  }
}

/// Whether an arrow of this kind is long enough to be seen beside the longest of all.
bool isSeen(const OrganismPicture& picture, ForceKind kind) {
  double most = 0, ofKind = 0;
  for (const LineMark& line : picture.lines) {
    if (!line.arrow) continue;
    const double length = norm(line.to - line.from);
    most = std::max(most, length);
    if (line.colour == forceColour(kind)) ofKind = std::max(ofKind, length);
  }
  return ofKind > 0.01 * most;
}

}  // namespace

Colour forceColour(ForceKind kind) {
  constexpr std::size_t series[] = {0, 1, 2, 3, 4, 6};  // [ForceKind] those that all eyes tell apart
  return seriesColour(series[std::size_t(kind)]);
}

double arrowScale(const std::vector<ForcesByKind>& forces, const std::vector<ForceKind>& kinds,
                  double longest) {
  double most = 0;
  for (const ForcesByKind& cell : forces)
    for (const ForceKind kind : kinds)
      for (const Vector& force : cell[std::size_t(kind)]) most = std::max(most, norm(force));
  return most > 0 ? longest / most : 1;
}

void PictureMaker::add(const World& world) {
  OrganismPicture picture = pictureOf(world, scenario_);
  picture.camera = wishes_.camera;
  picture.width = wishes_.width, picture.height = wishes_.height, picture.samples = wishes_.samples;
  picture.transparent = wishes_.transparent;
  picture.clip = wishes_.clip;
  picture.instruments.axes = wishes_.axes, picture.instruments.scaleBar = wishes_.scaleBar;
  setOpacities(picture, world, wishes_.opacities);
  if (wishes_.labels != Labels::none) addLabels(picture, world, scenario_, wishes_.labels);
  pictures_.push_back(std::move(picture));
  values_.push_back(colourValues(world, wishes_.colouring, scenario_));
  if (wishes_.normals) {
    OrganismPicture cells = pictures_.back();
    cells.cells.resize(world.cells.path.size());
    cells.lines.clear();
    addNormals(cells, 0.15 * meanRadius(cells, cells.cells.size()), normalColour);
    pictures_.back().lines = std::move(cells.lines);
  }
  if (wishes_.connections && world.connections) addConnections(pictures_.back(), world);
}

void PictureMaker::addForces(World& world) {
  if (wishes_.forces.empty()) return;
  OrganismPicture& picture = pictures_.back();
  const std::vector<ForcesByKind> forces = forcesByKind(world);
  const double longest = 0.8 * meanRadius(picture, forces.size());
  const double scale = arrowScale(forces, wishes_.forces, longest);
  for (const ForceKind kind : wishes_.forces)
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const auto& onVertex = forces[i][std::size_t(kind)];
      // A ball's one force acts on its middle; what is drawn are the vertices of its surface.
      const bool isBall = onVertex.size() != picture.cells[i].vertices.size();
      for (std::size_t v = 0; v < onVertex.size(); ++v) {
        const Point from = isBall ? middleOf(picture.cells[i]) : picture.cells[i].vertices[v];
        if (scale * norm(onVertex[v]) > 1e-12 * longest)  // else rounding
          picture.lines.push_back({from, from + scale * onVertex[v], forceColour(kind), isBall, true});
      }
    }
  picture.instruments.arrowKey = ArrowKey{scale, "[force]", quietInk};
}

std::vector<OrganismPicture> PictureMaker::take() {
  colourCells(pictures_, values_, wishes_.colouring, scenario_);
  if (wishes_.colouring.by == Colouring::By::substance) shareLegend(pictures_);
  for (OrganismPicture& picture : pictures_) {
    if (wishes_.normals) picture.legend.push_back({normalColour, "normal"});
    if (std::any_of(picture.lines.begin(), picture.lines.end(),
                    [](const LineMark& line) { return line.colour == connectionColour; }))
      picture.legend.push_back({connectionColour, "connection"});
    for (const ForceKind kind : wishes_.forces)
      if (isSeen(picture, kind))
        picture.legend.push_back({forceColour(kind), std::string(nameOf(kind)) + " force"});
  }
  if (pictures_.size() > 1) {
    const Framing framing = fitFraming(pictures_);
    for (OrganismPicture& picture : pictures_) picture.camera.framing = framing;
  }
  values_.clear();
  return std::move(pictures_);
}

}  // namespace morula
