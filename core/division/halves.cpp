#include "division/halves.h"

namespace morula {

int countFolds(Points x, Faces faces, const std::vector<char>& isProjected, const Vector& outward) {
  int folds = 0;
  for (const auto& [a, b, c] : faces)
    if (isProjected[a] && isProjected[b] && isProjected[c]) folds += dot(cross(x[b] - x[a], x[c] - x[a]), outward) < 0;
  return folds;
}

int unfold(std::vector<Point>& x, Faces faces, const std::vector<char>& isProjected, const Vector& outward,
           int sweeps) {
  std::vector<Vector> sum(x.size());
  std::vector<double> count(x.size());
  int folds = countFolds(x, faces, isProjected, outward);
  for (int sweep = 0; folds > 0 && sweep < sweeps; ++sweep) {
    // Each edge belongs to two faces, so every neighbour counts twice: the mean is that of the ring.
    sum.assign(x.size(), {});
    count.assign(x.size(), 0);
    for (const Face& f : faces)
      for (int corner = 0; corner < 3; ++corner) {
        sum[f[corner]] += x[f[(corner + 1) % 3]] + x[f[(corner + 2) % 3]];
        count[f[corner]] += 2;
      }
    for (std::size_t v = 0; v < x.size(); ++v) {
      if (!isProjected[v]) continue;
      const Vector step = sum[v] / count[v] - x[v];
      x[v] += 0.5 * (step - dot(step, outward) * outward);
    }
    folds = countFolds(x, faces, isProjected, outward);
  }
  return folds;
}

Halves halve(Points vertices, Faces faces, const Point& onPlane, const Vector& normal) {
  Halves h{{vertices.begin(), vertices.end()}, {vertices.begin(), vertices.end()}, 0, 0};
  std::vector<char> flatInA(vertices.size()), flatInB(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const double height = dot(vertices[v] - onPlane, normal);
    (height > 0 ? h.b : h.a)[v] = vertices[v] - height * normal;  // in the half where v lies beyond the plane
    (height > 0 ? flatInB : flatInA)[v] = true;
  }
  unfold(h.a, faces, flatInA, -normal);
  unfold(h.b, faces, flatInB, normal);
  h.volumeA = measureVolume(h.a, faces), h.volumeB = measureVolume(h.b, faces);
  return h;
}

}  // namespace morula
