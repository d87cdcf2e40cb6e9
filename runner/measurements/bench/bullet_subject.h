#pragma once
// A packed scene in Bullet under measurement, with all settings that Bullet leaves to its users.
#include <cmath>
#include <functional>
#include <vector>

#include "engines/bullet_scene.h"

namespace morula {

/// One of Bullet's settings and what it took.
struct BulletSettingRow {
  double margin = 0;                  // [share radii] of each surface
  int iterations = 1;                 // of the position solver
  double nsPerVertexStep = INFINITY;  // median; infinite: the cells did not stay whole
  std::vector<double> samples = {};   // [s] per vertex and step
};

class BulletSubject {
 public:
  /// [runInBullet]
  using Run = std::function<BulletResult(const BulletRequest&)>;

  /// `scene`: the packed cells at rest in our engine. `shareRadius`: what margins are multiples of.
  BulletSubject(const BulletScene& scene, double shareRadius, Run run);

  /// The first call lets the packing come to rest in Bullet's own contact, once for each margin, and times
  /// every setting. Later ones time those that were the fastest.
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
  std::vector<std::vector<Body>> settled_;  // for each margin
  std::vector<BulletSettingRow> timings_;
};

}  // namespace morula
