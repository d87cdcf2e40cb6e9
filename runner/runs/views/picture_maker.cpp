#include "views/picture_maker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "biology/substance_pattern.h"
#include "drawing/palette.h"
#include "pictures/pictures.h"

namespace morula {
namespace {

constexpr Colour connectionColour{0x6a, 0x3d, 0x9a}, normalColour{0x77, 0x77, 0x77};

void addConnections(OrganismPicture& picture, const World& world) {
  for (const std::size_t place : world.connections->active) {
    const ConnectionRecord& record = world.connections->history[place];
    const int a = cellNumber(world.cells, record.a), b = cellNumber(world.cells, record.b);
    if (a >= 0 && b >= 0)
      picture.lines.push_back({middleOf(picture.cells[a]), middleOf(picture.cells[b]), connectionColour, true});
  }
}

void setOpacities(OrganismPicture& picture, const World& world, const std::vector<CellOpacity>& opacities,
                  std::vector<bool>& fit) {
  for (std::size_t i = 0; i < world.cells.path.size(); ++i)
    for (std::size_t o = 0; o < opacities.size(); ++o) {
      const CellOpacity& wish = opacities[o];
      if (wish.pattern != "*" && !fitsAny(wish.pattern, world.biology->describe(world.cells.state[i]))) continue;
      picture.cells[i].opacity = wish.opacity;
      fit[o] = true;
    }
}

/// Makes the legend for the colours of the cells that are drawn.
std::vector<LegendEntry> legendOf(const OrganismPicture& picture, const World& world, const Scenario& scenario) {
  Palette palette(scenario);
  for (std::size_t i = 0; i < world.cells.path.size(); ++i)
    if (picture.cells[i].opacity > 0)
      palette.colourOf(world.cells.path[i], world.biology->describe(world.cells.state[i]));
  return palette.legend();
}

double longestOf(const std::vector<ForcesByKind>& forces, ForceKind kind) {
  double most = 0;
  for (const ForcesByKind& cell : forces)
    for (const Vector& force : cell[std::size_t(kind)]) most = std::max(most, norm(force));
  return most;
}

}  // namespace

void addLabels(OrganismPicture& picture, const World& world, const Scenario& scenario, Labels labels) {
  if (labels == Labels::none) return;
  for (std::size_t i = 0; i < world.cells.path.size(); ++i) {
    const CellPath& path = world.cells.path[i];
    const std::string plain = path.isEgg() ? "egg" : path.text();
    picture.labels.push_back({i, labels == Labels::name ? scenario.names.of(path).value_or(plain) : plain});
  }
}

Colour forceColour(ForceKind kind) {
  constexpr std::size_t series[] = {0, 1, 2, 3, 4, 6};  // [ForceKind] those that all eyes tell apart
  return seriesColour(series[std::size_t(kind)]);
}

OrganismPicture Pictures::operator[](std::size_t i) const {
  OrganismPicture picture = pictures_[i];
  if (forces_.empty()) return picture;
  double most = 0;
  for (const ForceKind kind : kinds_) most = std::max(most, longestOf(forces_[i], kind));
  for (const ForceKind kind : kinds_)
    for (std::size_t c = 0; c < forces_[i].size(); ++c) {
      const auto& onVertex = forces_[i][c][std::size_t(kind)];
      const CellShape& cell = picture.cells[c];
      if (cell.opacity == 0) continue;
      // A ball's one force acts on its middle; what is drawn are the vertices of its surface.
      const bool isBall = onVertex.size() != cell.vertices.size();
      for (std::size_t v = 0; v < onVertex.size(); ++v) {
        const Point from = isBall ? middleOf(cell) : cell.vertices[v];
        if (norm(onVertex[v]) > 1e-12 * most)  // else rounding
          picture.lines.push_back({from, from + lengthPerForce_ * onVertex[v], forceColour(kind), isBall, true});
      }
    }
  return picture;
}

PictureMaker::PictureMaker(const Scenario& scenario, PictureWishes wishes)
    : scenario_(scenario), wishes_(std::move(wishes)), opacityFits_(wishes_.opacities.size()) {
  if (wishes_.forces.empty()) return;
  checkHasForces(scenario.scene.mechanics->physics);
  scratch_ = makeWorld(scenario.scene);
  made_.kinds_ = wishes_.forces;
}

void PictureMaker::add(const World& world) {
  OrganismPicture picture = pictureOf(world, scenario_);
  picture.camera = wishes_.camera;
  picture.width = wishes_.width, picture.height = wishes_.height, picture.samples = wishes_.samples;
  picture.print = wishes_.print;
  picture.transparent = wishes_.transparent;
  picture.clip = wishes_.clip;
  picture.instruments.axes = wishes_.axes, picture.instruments.scaleBar = wishes_.scaleBar;
  if (const Units& units = scenario_.units; !units.length.empty())
    picture.instruments.lengthUnit = units.length, picture.instruments.perLength = units.perLength;
  setOpacities(picture, world, wishes_.opacities, opacityFits_);
  picture.legend = legendOf(picture, world, scenario_);
  addLabels(picture, world, scenario_, wishes_.labels);
  values_.push_back(colourValues(world, wishes_.colouring, scenario_));
  if (wishes_.normals) {
    OrganismPicture cells = picture;
    cells.cells.resize(world.cells.path.size());
    cells.lines.clear();
    std::erase_if(cells.cells, [](const CellShape& cell) { return cell.opacity == 0; });
    addNormals(cells, 0.15 * meanRadius(cells, cells.cells.size()), normalColour);
    picture.lines = std::move(cells.lines);
  }
  if (wishes_.connections && world.connections) addConnections(picture, world);
  made_.pictures_.push_back(std::move(picture));
  if (!scratch_) return;
  auto& forces = made_.forces_.emplace_back(forcesByKind(world, *scratch_));
  for (const ForceKind kind : valuesOf<ForceKind>())
    if (std::find(wishes_.forces.begin(), wishes_.forces.end(), kind) == wishes_.forces.end())
      for (ForcesByKind& cell : forces) cell[std::size_t(kind)] = {};
}

/// One scale for all, so that no arrow is longer than 0.8 mean radii of the cells in its picture.
void PictureMaker::scaleForces() {
  double scale = INFINITY;
  for (std::size_t i = 0; i < made_.forces_.size(); ++i)
    for (const ForceKind kind : wishes_.forces)
      if (const double most = longestOf(made_.forces_[i], kind); most > 0)
        scale = std::min(scale, 0.8 * meanRadius(made_.pictures_[i], made_.forces_[i].size()) / most);
  if (!std::isfinite(scale)) return;  // there are none
  made_.lengthPerForce_ = scale;
  for (OrganismPicture& picture : made_.pictures_)
    picture.instruments.arrowKey = ArrowKey{made_.lengthPerForce_, "[force]", quietInk};
}

void PictureMaker::finishLegends() {
  std::vector<LegendEntry> marks;
  if (wishes_.normals) marks.push_back({normalColour, "normal"});
  const auto isConnection = [](const LineMark& line) { return line.colour == connectionColour; };
  const auto isConnected = [&](const OrganismPicture& picture) {
    return std::any_of(picture.lines.begin(), picture.lines.end(), isConnection);
  };
  if (std::any_of(made_.pictures_.begin(), made_.pictures_.end(), isConnected))
    for (OrganismPicture& picture : made_.pictures_)
      picture.legend.push_back({connectionColour, "connection", Marker::square, isConnected(picture)});
  // Kinds whose arrows are long enough to be seen beside the longest of all.
  std::vector<double> longest(choices<ForceKind>.size());
  for (const auto& forces : made_.forces_)
    for (const ForceKind kind : wishes_.forces)
      longest[std::size_t(kind)] = std::max(longest[std::size_t(kind)], longestOf(forces, kind));
  const double most = *std::max_element(longest.begin(), longest.end());
  for (const ForceKind kind : wishes_.forces)
    if (longest[std::size_t(kind)] > 0.01 * most)
      marks.push_back({forceColour(kind), std::string(nameOf(kind)) + " force"});
  for (OrganismPicture& picture : made_.pictures_)
    picture.legend.insert(picture.legend.end(), marks.begin(), marks.end());
}

std::optional<std::string> PictureMaker::strangeOpacity() const {
  for (std::size_t o = 0; o < opacityFits_.size(); ++o)
    if (!opacityFits_[o] && wishes_.opacities[o].pattern != "*") return wishes_.opacities[o].pattern;
  return std::nullopt;
}

Pictures PictureMaker::take() {
  auto& pictures = made_.pictures_;
  colourCells(pictures, values_, wishes_.colouring, scenario_);
  if (scratch_) scaleForces();
  finishLegends();
  if (pictures.size() > 1) {
    const Framing framing = fitFraming(made_.size(), [&](std::size_t i) { return made_[i]; });
    for (OrganismPicture& picture : pictures) picture.camera.framing = framing;
  }
  values_.clear();
  return std::exchange(made_, {});
}

}  // namespace morula
