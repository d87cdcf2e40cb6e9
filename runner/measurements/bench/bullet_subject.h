#pragma once
// Measures a packed scene in Bullet, with all settings that Bullet leaves to its users.
#include <cmath>
#include <functional>
#include <vector>

#include "engines/bullet_scene.h"

namespace morula {

/// A setting of Bullet and its time.
struct BulletSettingRow {
  double margin = 0;                  // [share radii] margin of each surface
  int iterations = 1;                 // iterations of the position solver
  double nsPerVertexStep = INFINITY;  // the median; infinite: cells did not stay whole
  std::vector<double> samples = {};   // [s] per vertex and step
};

class BulletSubject {
 public:
  /// A function like runInBullet.
  using Run = std::function<BulletResult(const BulletRequest&)>;

  /// `scene`: the packed cells at rest in Morula. `shareRadius`: the unit of margins.
  BulletSubject(const BulletScene& scene, double shareRadius, Run run);

  /// Measures one round. The first call lets the packing come to rest in Bullet's own contact, once for each margin,
  /// and times every setting. Later calls time the fastest settings.
  void round();

  /// Returns all settings whose cells stayed whole, by their medians, the fastest first.
  std::vector<BulletSettingRow> timings() const;

 private:
  BulletResult ask(double margin, int iterations, const std::vector<Body>& start, int steps) const;
  void settle();
  void time(BulletSettingRow& timing);
  double vertices() const;

  BulletScene scene_;
  double shareRadius_;
  Run run_;
  std::vector<std::vector<Body>> settled_;  // cells at rest, for each margin
  std::vector<BulletSettingRow> timings_;
};

}  // namespace morula
