#include "division/place_plane.h"

#include <algorithm>
#include <vector>

#include "division/halves.h"

namespace morula {
namespace {

struct Heights {
  double low, high;
  double middle() const { return 0.5 * (low + high); }
};

/// Returns heights between which a share, falling from 1 at the lower end to 0 at the upper one, passes `wanted`. The
/// number of halvings is fixed, and enough for the last place of a double.
template <class ShareAbove>
Heights bisect(Heights h, double wanted, const ShareAbove& shareAbove) {
  for (int turn = 0; turn < 60; ++turn) (shareAbove(h.middle()) > wanted ? h.low : h.high) = h.middle();
  return h;
}

/// The volume above a height, without cutting the mesh. With heights h and the areas A_f of the faces projected onto
/// the plane, which a projection of the part below onto the plane does not change,
///
///   V(t) = Σ_f A_f · mean over f's corners of max(h − t, 0) = Σ_v w_v max(h_v − t, 0),   w_v = ⅓ Σ_{f∋v} A_f
class VolumeAbove {
 public:
  VolumeAbove(Points vertices, Faces faces, const Vector& normal) : weight_(vertices.size()) {
    const Point centre = measureCentroid(vertices);
    for (const Point& x : vertices) height_.push_back(dot(x - centre, normal));
    for (const auto& [i, j, k] : faces) {
      // `dot` is twice the area; each corner gets a third of the area.
      const double shadow = dot(cross(vertices[j] - vertices[i], vertices[k] - vertices[i]), normal) / 6;
      weight_[i] += shadow, weight_[j] += shadow, weight_[k] += shadow;
    }
  }
  double operator()(double t) const {
    double volume = 0;
    for (std::size_t v = 0; v < height_.size(); ++v) volume += weight_[v] * std::max(height_[v] - t, 0.0);
    return volume;
  }
  double lowest() const { return *std::ranges::min_element(height_); }
  double highest() const { return *std::ranges::max_element(height_); }

 private:
  std::vector<double> height_, weight_;  // [length] over the mean of the vertices; [length²]
};

}  // namespace

Point placePlane(Points vertices, Faces faces, const Vector& normal, double share) {
  const VolumeAbove above(vertices, faces, normal);
  const Point centre = measureCentroid(vertices);
  const Heights all{above.lowest(), above.highest()};
  const double whole = above(all.low);
  const double height = bisect(all, share, [&](double t) { return above(t) / whole; }).middle();
  const auto shareAbove = [&](double t) {
    const Halves h = halve(vertices, faces, centre + t * normal, normal);
    return h.volumeA / (h.volumeA + h.volumeB);
  };
  const double found = shareAbove(height);
  if (found - share < 1e-12 && share - found < 1e-12) return centre + height * normal;
  const Heights at = bisect(all, share, shareAbove);
  // Moves beside a jump, so that rounding (in a turned scene, say) does not decide on which side the plane lies.
  const double beside = 1e-9 * (all.high - all.low);
  const double more = shareAbove(at.low - beside) - share, less = share - shareAbove(at.high + beside);
  if (more + less < 1e-6) return centre + at.middle() * normal;
  return centre + (more < less ? at.low - beside : at.high + beside) * normal;
}

}  // namespace morula
