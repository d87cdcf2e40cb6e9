
#include "observation/organism_measures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

#include "base/maths.h"
#include "division/principal_axis.h"
#include "division/superposition.h"
#include "mesh/mesh_measures.h"
#include "observation/body_measures.h"

namespace morula {
namespace {

using Value = std::optional<double>;

const std::vector<CellPath>& pathsOf(const Observation& now) { return now.world.cells.path; }

/// Returns for each cell the number of its clone among the living clones, by path; −1: none.
std::vector<int> cloneNumbers(const Observation& now, int depth) {
  const auto& paths = pathsOf(now);
  std::vector<int> numbers(paths.size(), -1);
  int last = -1;
  for (std::size_t i = 0; i < paths.size(); ++i) {  // a subtree is one range of paths
    if (paths[i].depth() < depth) continue;
    if (i == 0 || commonDepth(paths[i - 1], paths[i]) < depth) ++last;
    numbers[i] = last;
  }
  return numbers;
}

/// Returns the numbers of the living cells of each clone.
std::vector<std::vector<int>> clonesOf(const Observation& now, int depth) {
  std::vector<std::vector<int>> clones;
  const std::vector<int> numbers = cloneNumbers(now, depth);
  for (int i = 0; i < static_cast<int>(numbers.size()); ++i) {
    if (numbers[i] < 0) continue;
    clones.resize(numbers[i] + 1);
    clones[numbers[i]].push_back(i);
  }
  return clones;
}

Value over(double part, double whole) { return whole > 0 ? Value(part / whole) : Value(); }

Point centreOf(const Observation& now, int cell) {
  const Bodies& b = *now.world.bodies;
  const int slot = b.slots[cell], count = b.vertexCount(slot);
  Point sum;
  for (int v = 0; v < count; ++v) sum += b.vertex(slot, v);
  return sum / count;
}

std::vector<Point> centresOf(const Observation& now) {
  std::vector<Point> centres;
  for (int i = 0; i < static_cast<int>(pathsOf(now).size()); ++i) centres.push_back(centreOf(now, i));
  return centres;
}

bool touch(const Observation& now, int a, int b) {
  return std::ranges::any_of(now.contactsOf(a), [&](const Observation::Contact& c) { return c.cell == b; });
}

/// Returns the rank of each value less the mean of all ranks: −(n − 1)/2 for the smallest, (n − 1)/2 for the largest.
std::vector<double> ranks(std::span<const double> values) {
  std::vector<std::uint32_t> order(values.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::pair(values[i], i); });
  std::vector<double> rank(values.size());
  double largest = 0;
  for (double value : values) largest = std::max(largest, std::abs(value));
  const double middle = 0.5 * (static_cast<double>(values.size()) - 1);
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first + 1;
    while (end < order.size() && values[order[end]] - values[order[end - 1]] <= 1e-9 * largest) ++end;
    for (std::size_t i = first; i < end; ++i) rank[order[i]] = 0.5 * static_cast<double>(first + end - 1) - middle;
    first = end;
  }
  return rank;
}

}  // namespace

int commonDepth(const CellPath& a, const CellPath& b) {
  const int most = std::min(a.depth(), b.depth());
  int depth = 0;
  while (depth < most && a.letter(depth) == b.letter(depth)) ++depth;
  return depth;
}

Value measureRelativesInContact(const Observation& now, int relation) {
  double pairs = 0, touching = 0;
  const auto& paths = pathsOf(now);
  // A subtree is one range of paths: relatives stand close together, cells of other depths among them.
  for (int a = 0; a < static_cast<int>(paths.size()); ++a) {
    const int common = paths[a].depth() - relation;
    if (common < 0) continue;
    for (int b = a + 1; b < static_cast<int>(paths.size()) && commonDepth(paths[a], paths[b]) >= common; ++b) {
      if (paths[b].depth() != paths[a].depth() || commonDepth(paths[a], paths[b]) != common) continue;
      ++pairs;
      touching += touch(now, a, b) ? 1 : 0;
    }
  }
  return over(touching, pairs);
}

Value measureCloneContact(const Observation& now, int depth) {
  const std::vector<int> clone = cloneNumbers(now, depth);
  double all = 0, within = 0;
  for (const auto& [a, b, area] : now.contacts()) {
    const int one = clone[a], other = clone[b];
    if (one < 0 || other < 0) continue;
    all += area;
    if (one == other) within += area;
  }
  return over(within, all);
}

Value measureHomotypicContact(const Observation& now) {
  double all = 0, within = 0;
  for (const auto& [a, b, area] : now.contacts()) {
    all += area;
    if (now.world.cells.state[a] == now.world.cells.state[b]) within += area;
  }
  return over(within, all);
}

Value measureMixing(const Observation& now, int depth) {
  const std::vector<int> number = cloneNumbers(now, depth);
  double contacts = 0, mixed = 0;
  for (const auto& [a, b, area] : now.contacts()) {
    const int one = number[a], other = number[b];
    if (one < 0 || other < 0) continue;
    ++contacts;
    mixed += one != other ? 1 : 0;
  }
  double cells = 0, within = 0;  // ordered pairs of one clone
  for (const auto& clone : clonesOf(now, depth)) {
    const double size = static_cast<double>(clone.size());
    cells += size, within += size * (size - 1);
  }
  const double pairs = cells * (cells - 1);
  if (!(contacts > 0 && pairs > within)) return {};
  return (mixed / contacts) / ((pairs - within) / pairs);
}

Value measureCloneRadius(const Observation& now, int depth) {
  double sum = 0, clones = 0;
  for (const auto& clone : clonesOf(now, depth)) {
    if (clone.size() < 2) continue;
    std::vector<Point> centres;
    for (int cell : clone) centres.push_back(centreOf(now, cell));
    const Point mean = measureCentroid(centres);
    double squares = 0;
    for (const Point& centre : centres) squares += dot(centre - mean, centre - mean);
    sum += std::sqrt(squares / static_cast<double>(centres.size()));
    ++clones;
  }
  return over(sum, clones);
}

Value measureCloneSpread(const Observation& now, int depth) {
  double sum = 0, clones = 0;
  for (const auto& clone : clonesOf(now, depth)) {
    std::vector<SolidMoments> cells;
    double volume = 0, second = 0;
    Vector first;
    for (const int cell : clone) {
      const SolidMoments& m = cells.emplace_back(measureMoments(*now.world.bodies, now.world.bodies->slots[cell]));
      volume += m.volume, first += m.volume * m.centre;
    }
    const Point centre = first / volume;
    for (const SolidMoments& m : cells) second += m.second + m.volume * dot(m.centre - centre, m.centre - centre);
    const double radius = cubeRoot(volume * 3 / (4 * std::numbers::pi));
    sum += std::sqrt(second / volume / 0.6) / radius;
    ++clones;
  }
  return over(sum, clones);
}

std::optional<Lumen> measureLumen(const Observation& now) {
  const Cavities& found = now.cavities();
  if (found.outside.empty()) return {};
  double cells = 0;
  for (const int slot : now.world.bodies->slots) cells += measureMoments(*now.world.bodies, slot).volume;
  return Lumen{found.volume / (cells + found.volume), found.largest / (cells + found.volume)};
}

Value measureClonePieces(const Observation& now, int depth) {
  const auto& paths = pathsOf(now);
  std::vector<int> first(paths.size());  // a cell of the same piece, nearer to the piece's first one
  std::iota(first.begin(), first.end(), 0);
  const auto find = [&](int cell) {
    while (first[cell] != cell) cell = first[cell] = first[first[cell]];
    return cell;
  };
  const std::vector<int> number = cloneNumbers(now, depth);
  for (const auto& [a, b, area] : now.contacts())
    if (number[a] >= 0 && number[a] == number[b]) {
      const int one = find(a), other = find(b);
      first[std::max(one, other)] = std::min(one, other);
    }
  double pieces = 0, clones = 0;
  for (const auto& clone : clonesOf(now, depth)) {
    ++clones;
    for (int cell : clone) pieces += find(cell) == cell ? 1 : 0;
  }
  return over(pieces, clones);
}

Value measureLineageInSpace(const Observation& now) {
  const auto& paths = pathsOf(now);
  const std::vector<Point> centres = centresOf(now);
  std::vector<double> divisions, distances;
  for (std::size_t a = 0; a < paths.size(); ++a)
    for (std::size_t b = a + 1; b < paths.size(); ++b) {
      divisions.push_back(paths[a].depth() + paths[b].depth() - 2 * commonDepth(paths[a], paths[b]));
      distances.push_back(norm(centres[a] - centres[b]));
    }
  return rankCorrelation(divisions, distances);
}

Value measureOrganismElongation(const Observation& now) {
  std::vector<Point> points;
  for (int slot : now.world.bodies->slots) {
    const std::vector<Point> vertices = takeSurface(*now.world.bodies, slot).vertices;
    points.insert(points.end(), vertices.begin(), vertices.end());
  }
  return points.empty() ? Value() : Value(extentRatio(points));
}

ContactsCompared compareContacts(const Observation& now) {
  const auto& reference = now.reference->contacts;
  const auto& cells = now.world.cells;
  std::set<CellPath> known;
  for (const auto& [a, b] : reference) known.insert(a), known.insert(b);
  ContactsCompared found;
  for (const auto& [a, b, area] : now.contacts()) {
    const CellPath &one = cells.path[a], &other = cells.path[b];  // by number is by path
    if (!known.contains(one) || !known.contains(other)) continue;
    ++found.here;
    found.both += reference.contains({one, other}) ? 1 : 0;
  }
  for (const auto& [a, b] : reference) found.there += cellNumber(cells, a) >= 0 && cellNumber(cells, b) >= 0 ? 1 : 0;
  return found;
}

namespace {

/// `mirror`: −1 compares the mirror image, 1 the centres themselves.
std::optional<PositionsCompared> compareCentres(const Observation& now, double mirror) {
  std::vector<Point> here, there;
  for (const auto& [path, place] : now.reference->positions) {
    const int cell = cellNumber(now.world.cells, path);
    if (cell < 0) continue;
    const Point centre = centreOf(now, cell);
    here.push_back({mirror * centre.x, centre.y, centre.z});
    there.push_back(place);
  }
  const auto laid = superpose(here, there);
  if (!laid) return {};
  return PositionsCompared{laid->distance, laid->shape, laid->scale, here.size()};
}

}  // namespace

std::optional<PositionsCompared> comparePositions(const Observation& now) { return compareCentres(now, 1); }
std::optional<PositionsCompared> compareMirroredPositions(const Observation& now) { return compareCentres(now, -1); }

std::optional<double> rankCorrelation(std::span<const double> x, std::span<const double> y) {
  const std::vector<double> a = ranks(x), b = ranks(y);
  double xx = 0, xy = 0, yy = 0;
  for (std::size_t i = 0; i < a.size(); ++i) xx += a[i] * a[i], xy += a[i] * b[i], yy += b[i] * b[i];
  if (!(xx > 0 && yy > 0)) return {};
  return xy / (std::sqrt(xx) * std::sqrt(yy));
}

}  // namespace morula
