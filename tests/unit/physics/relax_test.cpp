// Damped motion: one call of the kernel against the formulas at the head of relax_kernel.h.
#include <array>

#include "catch.h"
#include "lab.h"
#include "physics/physics_kernels.h"

using namespace morula;

TEST_CASE("Drag takes its share of a motion, forces add to it, and no vertex moves farther than it may") {
  const double h = 0.25, before = 3.5;
  Lab lab(softCell(), makeIcosphere(1));
  Bodies& b = lab.bodies;
  const auto push = [](int v) { return Vector{0.05 * v, 0.2, -0.3 - 0.01 * v}; };
  const auto speed = [](int v) { return Vector{0.4 - 0.02 * v, 0.1, 0.03 * v}; };
  for (const double drag : {0.0, 0.2, 1.0})
    for (const double most : {1e9, 0.1, 0.01}) {
      double squares = 0, power = 0, next = 0, largest = 0;
      std::vector<Vector> onward;
      for (int v = 0; v < b.vertexCount(0); ++v) {
        b.write(b.velocity, 0, v, speed(v) + h * push(v));
        b.write(b.acceleration, 0, v, push(v));
        onward.push_back((1 - drag / 2) / (1 + drag / 2) * speed(v) + h / (1 + drag / 2) * push(v));
        squares += dot(speed(v), speed(v));
        power += dot(speed(v), push(v));
        next += dot(onward.back(), push(v));
        largest = std::max(largest, norm(onward.back()));
      }
      alignas(64) std::array<double, blockLanes> maxMove{}, drags{}, powers{}, stiffness{};
      maxMove.fill(most);
      drags.fill(drag);
      powers.fill(before);
      physicsKernels(Isa::scalar)
          .dampMotion(b.mesh.view(), b.block(0, 0), {maxMove.data(), drags.data(), powers.data(), stiffness.data()}, h);
      const double share = std::min(1.0, most / (h * largest));
      Worst error;
      for (int v = 0; v < b.vertexCount(0); ++v) error.see(norm(lab.velocity(0, v) - share * onward[v]) / largest);
      CAPTURE(drag, most, share);
      CHECK(error < 1e-14);  // a few roundings
      CHECK(stiffness[0] == Approx(h * (before - power) / squares).epsilon(1e-13));
      CHECK(powers[0] == Approx(share * next).epsilon(1e-13));
    }
}
