#include "pictures/bullet_picture.h"

#include "pictures/pictures.h"

namespace morula {

Drawing drawBesideBullet(const World& world, const std::vector<std::vector<Point>>& shapes,
                         const Scenario& scenario) {
  OrganismPicture ours = pictureOf(world, scenario);
  ours.width = ours.height = 700;
  OrganismPicture bullets = ours;
  ours.title += ": ours";
  bullets.title += ": Bullet's";
  for (std::size_t i = 0; i < bullets.cells.size(); ++i) bullets.cells[i].vertices = shapes[i];
  return drawComparison(ours, bullets, scenario.scene.mechanics->physics.cell.radius);
}

}  // namespace morula
