#pragma once
// Damped motion for each cell by itself, on the way to rest [Underwood 1983]:
//
//   v½' = ((1 − η/2) v½ + h a)/(1 + η/2)     x' = x + h v½'
//   v½    velocity on the way from one evaluation of the forces to the next, h [time] apart;  a: acceleration by the
//         cell's own inertia, where v½ has led;  η: the share of a motion that drag takes in one evaluation
//
// v½' is shortened where a vertex would move farther than `maxMove`. The forces change by what the cell's own motion
// meets: with sums over its vertices
//
//   σ = h (Σ v½·a_before − Σ v½·a) / Σ v½²     ω²h² of the motion, 4 where it would oscillate from step to step
//
// Nothing but a cell's own sums decides how it moves, so the same bits come out of any number of threads.
#include "physics/lane_vec3.h"

namespace morula::MORULA_ISA {

/// velocity ← v½' [PhysicsKernels::dampMotion]. Needs the velocity v½ + h a, as a whole kick leaves it.
inline void dampMotion(const TemplateView& mesh, const BlockView& b, const MotionDamping& d, double interval) {
  for (int lane = 0; lane < b.liveLanes; lane += width) {
    const Lanes h = interval, half = 0.5 * load(d.drag + lane);
    const Lanes kept = (1.0 - half) / (1.0 + half), pushed = h / (1.0 + half);
    Lanes squares = 0.0, power = 0.0, next = 0.0, farthest = 0.0;
    for (int i = 0; i < mesh.vertexCount; ++i) {
      const Vec a = loadVec(b.acceleration, i, lane), v = loadVec(b.velocity, i, lane) - h * a;
      squares += dot(v, v);
      power += dot(v, a);
      const Vec onward = kept * v + pushed * a;
      storeVec(b.velocity, i, lane, onward);
      next += dot(onward, a);
      farthest = max(dot(onward, onward), farthest);
    }
    const Lanes most = load(d.maxMove + lane) / h;
    const Mask tooFar = farthest > most * most;
    if (any(tooFar)) {
      const Lanes shortened = select(tooFar, most / sqrt(farthest), 1.0);
      for (int i = 0; i < mesh.vertexCount; ++i)
        storeVec(b.velocity, i, lane, shortened * loadVec(b.velocity, i, lane));
      next = shortened * next;
    }
    store(d.stiffness + lane, h * (load(d.power + lane) - power) / (squares + tiny));
    store(d.power + lane, next);
  }
}

}  // namespace morula::MORULA_ISA
