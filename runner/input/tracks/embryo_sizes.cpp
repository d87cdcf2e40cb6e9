#include "tracks/embryo_sizes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/number_text.h"

namespace morula::tracks {
namespace {

// The egg's share of the shell: usual, and at most. A mesh of 162 vertices fills no more, and balls overlap beyond.
constexpr double usualFill = 0.9, mostOfMeshes = 0.95, mostOfBalls = 0.73;
constexpr double founderFill =
    0.37;  // of balls that begin as several, where more would jam on their way to their places
constexpr double polyhedron = 0.95;  // a shell's mesh holds the shell's ellipsoid, made so much smaller

double ballRadius(double volume) { return std::cbrt(volume / (4 * std::numbers::pi / 3)); }
double boxVolume(const std::array<double, 3>& axes) { return axes[0] * axes[1] * axes[2]; }

/// The volume of the egg, or else of all cells in the mean over the stages of which it is known; 0 if there is none.
double wholeVolume(const Embryo& embryo) {
  if (const double egg = embryo.lineage.cells[0].volume; embryo.lineage.founders == 1 && egg > 0) return egg;
  double sum = 0, time = 0;
  for (const Stage& stage : embryo.stages) {
    double volume = 0;
    for (const TrackedCell& cell : embryo.lineage.cells)
      if (livesIn(cell, stage)) volume += cell.volume;
    if (volume == volume) sum += volume * (stage.end - stage.begin), time += stage.end - stage.begin;
  }
  return time > 0 ? sum / time : 0;
}

/// Moves the centre of a ball towards the origin until the ellipsoid about that with axes times `scale` holds the ball.
Point moveInside(const Point& centre, double radius, const std::array<double, 3>& axes, double scale) {
  constexpr int directions = 500;
  const auto fits = [&](double share) {
    for (int i = 0; i < directions; ++i) {  // evenly spread on a golden spiral
      const double z = 1 - (2 * i + 1.0) / directions, turn = i * 2.399963229728653, r = std::sqrt(1 - z * z);
      const Point p = centre * share + Vector{r * std::cos(turn), r * std::sin(turn), z} * radius;
      if (norm({p.x / axes[0], p.y / axes[1], p.z / axes[2]}) > scale) return false;
    }
    return true;
  };
  double share = 1;
  while (share > 0.001 && !fits(share)) share -= 0.01;
  return centre * std::max(share, 0.0);
}

void findStart(Embryo& e, double volume) {
  const auto& cells = e.lineage.cells;
  const int founders = e.lineage.founders;
  double sum = 0;
  for (int i = 0; i < founders; ++i) sum += cells[static_cast<std::size_t>(i)].volume;
  for (int i = 0; i < founders; ++i) {
    const TrackedCell& cell = cells[static_cast<std::size_t>(i)];
    const double scale = std::cbrt(volume > 0 && sum == sum ? cell.volume / sum : 1.0 / founders);
    Point place{3.0 * i, 0, 0};  // in a row, where the table has no places
    if (!cell.seen.empty()) place = (cell.seen.front().place - e.centre) / e.length;
    if (e.shell) place = moveInside(place, e.egg * scale, *e.shell, polyhedron / e.length);
    e.start.emplace_back(place, scale);
  }
  e.assumed.push_back(std::to_string(founders) +
                      " cells have no mother: the scenario begins with all of them, as balls " +
                      (e.shell ? "inside the shell" : "in a row") + "; --root takes one and its descendants");
}

}  // namespace

void findSizes(Embryo& e, const EmbryoOptions& options) {
  if (!e.hasBodies) return;
  std::vector<Point> centres;
  Point low{INFINITY, INFINITY, INFINITY}, high = -low;
  for (const TrackedCell& cell : e.lineage.cells)
    for (const Sighting& s : cell.seen) {
      centres.push_back(s.place);
      low = {std::min(low.x, s.place.x), std::min(low.y, s.place.y), std::min(low.z, s.place.z)};
      high = {std::max(high.x, s.place.x), std::max(high.y, s.place.y), std::max(high.z, s.place.z)};
    }
  if (!centres.empty()) e.centre = (low + high) / 2;
  const int most = e.stages.empty() ? 1 : e.stages.back().cells;
  e.shell = options.shell;
  if (!e.shell && most > 1 && !centres.empty() && norm(high - low) > 0) {
    e.shell = fitShell(centres, e.centre, most);
    const auto& a = *e.shell;
    e.assumed.push_back("the shell is fitted to the cells' centres: semi-axes of " + numberText(a[0], 3) + ", " +
                        numberText(a[1], 3) + " and " + numberText(a[2], 3) + "; --shell gives measured ones");
  }
  const double volume = wholeVolume(e), shell = e.shell ? 4 * std::numbers::pi / 3 * boxVolume(*e.shell) : 0;
  const double known = volume > 0 && shell > 0 ? volume / shell : usualFill;
  e.fill = std::min(known, mostOfMeshes);
  if (shell > 0 && (e.fill < known || !(volume > 0)))
    e.assumed.push_back((volume > 0 ? "the cells have " + numberText(known, 3) + " of the shell's volume"
                                    : "the table has no volumes of all cells") +
                        ": they are taken to fill " + numberText(e.fill) + " of the shell");
  e.length = shell > 0 ? ballRadius(e.fill * shell) : volume > 0 ? ballRadius(volume) : 1;
  e.areSpheres = e.areSpheres || e.lineage.founders > 1;  // meshes that begin in one another stay so
  if (e.areSpheres && shell > 0) {
    e.egg = std::min(1.0, std::cbrt((e.lineage.founders > 1 ? founderFill : mostOfBalls) / e.fill));
    if (e.lineage.founders == 1) e.egg = std::min(e.egg, polyhedron * *std::ranges::min_element(*e.shell) / e.length);
    e.assumed.push_back("balls have " + numberText(e.egg * e.egg * e.egg, 2) +
                        " of the cells' volumes, so that the shell has room for them");
  }
  if (e.lineage.founders > 1) findStart(e, volume);
}

std::array<double, 3> fitShell(const std::vector<Point>& centres, const Point& centre, int n) {
  std::array<double, 3> far{};
  for (const Point& p : centres) {
    const Vector d = p - centre;
    far = {std::max(far[0], std::abs(d.x)), std::max(far[1], std::abs(d.y)), std::max(far[2], std::abs(d.z))};
  }
  std::array<double, 3> axes;
  axes.fill(norm({far[0], far[1], far[2]}));
  for (int round = 0; round < 200; ++round) {  // the error falls by n^⅓ in each
    const double radius = std::cbrt(boxVolume(axes) / n);
    for (std::size_t i = 0; i < 3; ++i) axes[i] = far[i] + radius;
  }
  double out = 1;
  for (const Point& p : centres) {
    const Vector d = p - centre;
    out = std::max(out, norm({d.x / axes[0], d.y / axes[1], d.z / axes[2]}));
  }
  for (double& axis : axes) axis *= out;
  return axes;
}

}  // namespace morula::tracks
