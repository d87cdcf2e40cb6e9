#include "pictures/bullet_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/distance.h"
#include "pictures/pictures.h"
#include "simulation/measures.h"

namespace morula {

namespace {

constexpr int side = 700;  // [pixel] of each of the three

/// Dark to light, also for eyes that do not tell red from green, and on grey paper.
constexpr std::array<Colour, 5> scale{
    {{0x2a, 0x1a, 0x5e}, {0x23, 0x5e, 0x96}, {0x21, 0x9d, 0x8b}, {0x8f, 0xce, 0x4b}, {0xfd, 0xe7, 0x25}}};

/// `share`: 0 the first colour, 1 the last.
Colour colourAt(double share) {
  const double place = std::clamp(share, 0.0, 1.0) * (scale.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), scale.size() - 2);
  const double t = place - static_cast<double>(i);
  const auto mix = [t](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + t * (b - a)));
  };
  return {mix(scale[i].r, scale[i + 1].r), mix(scale[i].g, scale[i + 1].g), mix(scale[i].b, scale[i + 1].b)};
}

/// [length] For each cell and vertex, from ours to Bullet's surface.
std::vector<std::vector<double>> distancesOf(const OrganismPicture& ours, const OrganismPicture& bullets) {
  std::vector<std::vector<double>> distances;
  for (std::size_t i = 0; i < ours.cells.size(); ++i)
    distances.push_back(measureDistances({ours.cells[i].vertices, facesOf(ours, ours.cells[i])},
                                         {bullets.cells[i].vertices, facesOf(bullets, bullets.cells[i])}));
  return distances;
}

OrganismPicture mapOf(const OrganismPicture& ours, const std::vector<std::vector<double>>& distances,
                      double eggRadius) {
  OrganismPicture map = ours;
  double most = 0;
  for (const auto& ofCell : distances)
    for (const double d : ofCell) most = std::max(most, d);
  for (std::size_t i = 0; i < map.cells.size(); ++i)
    for (const double d : distances[i]) map.cells[i].colours.push_back(colourAt(most > 0 ? d / most : 0));
  map.title = "distance of the surfaces";
  map.caption = fmt::format("at most {:.3g} [length], {:.2g} radii of the egg", most, most / eggRadius);
  map.legend.clear();
  for (std::size_t i = 0; i < scale.size(); ++i)
    map.legend.push_back(
        {scale[i], fmt::format("{:.2g}", most * static_cast<double>(i) / (scale.size() - 1))});
  map.legend.back().label += " [length]";
  return map;
}

}  // namespace

Image drawBesideBullet(const World& ours, const std::vector<std::vector<Point>>& shapes,
                       const Scenario& scenario) {
  OrganismPicture left = pictureOf(ours, scenario);
  left.width = left.height = side;
  OrganismPicture middle = left;
  for (std::size_t i = 0; i < middle.cells.size(); ++i) middle.cells[i].vertices = shapes[i];
  left.title += ": ours";
  middle.title += ": Bullet's";
  // One framing and one band of words, so that the three can be laid over each other by eye.
  left.camera.framing = middle.camera.framing = fitFraming({left, middle});
  OrganismPicture right =
      mapOf(left, distancesOf(left, middle), scenario.scene.mechanics->physics.cell.radius);
  left.legend = middle.legend = right.legend;
  for (OrganismPicture* picture : {&left, &middle})
    for (LegendEntry& entry : picture->legend) entry = {paper, ""};
  return contactSheet({drawOrganism(left), drawOrganism(middle), drawOrganism(right)}, 3);
}

}  // namespace morula
