// Relaxation: one call of the kernel against the formulas at the head of fire_kernel.h.
#include <array>

#include "catch.h"
#include "lab.h"
#include "physics/physics_kernels.h"

using namespace morula;

TEST_CASE("What rests sets out along its forces, by half of them, and no vertex moves farther than it may") {
  Lab lab(softCell(), makeIcosphere(1));
  Bodies& b = lab.bodies;
  const auto push = [](int v) { return Vector{0.05 * v, 0.2, -0.3 - 0.01 * v}; };
  double squares = 0, largest = 0;
  for (int v = 0; v < b.vertexCount(0); ++v) {
    squares += dot(push(v), push(v));
    largest = std::max(largest, norm(push(v)));
  }
  for (const double most : {1e9, 0.5, 0.01}) {
    for (int v = 0; v < b.vertexCount(0); ++v) {
      b.write(b.velocity, 0, v, {});
      b.write(b.acceleration, 0, v, push(v));
    }
    alignas(64) std::array<double, blockLanes> maxMove{}, alpha{}, descents{}, strain{}, sum{};
    maxMove.fill(most);
    physicsKernels(Isa::scalar)
        .relaxVelocities(b.mesh.view(), b.block(0, 0),
                         {maxMove.data(), alpha.data(), descents.data(), strain.data(), sum.data()});
    // Half a step earlier a resting cell had v = −½ a, against the forces: the kernel stops it and starts anew.
    const double share = std::min(1.0, most / (0.5 * largest));
    Worst error;
    for (int v = 0; v < b.vertexCount(0); ++v) error.see(norm(lab.velocity(0, v) - (0.5 * share) * push(v)) / largest);
    CHECK(error < 1e-14);  // a few roundings
    CHECK(sum[0] == Approx(squares).epsilon(1e-13));
    CHECK(alpha[0] == 0.25);
    CHECK(descents[0] == 0);
    CHECK(strain[0] == 1);
  }
}
