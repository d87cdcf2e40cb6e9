#pragma once
// Integrator::fire: FIRE, the fast inertial relaxation engine, for each cell by itself: it goes where forces vanish [Bitzek et al. 2006],
// with velocities half a step ahead of the forces [Guénolé et al. 2020].
//
//   v½                velocity on the way from one evaluation to the next:  x' = x + v½, in a step of 1
//   v = v½ − ½ a      where the forces are known;  a: acceleration, by the cell's own inertia
//   P = Σ a·v         power;  V = Σ v²,  A = Σ a²: sums over the cell's vertices, in their order
//   P > 0:  v ← (1 − α) v + α √(V/A) a      turns the motion towards the force, at the same speed
//           α ← 0.99 α                      from the fifth evaluation on that went downhill
//   else:   v ← 0,  α ← ¼
//   v½' = v + ½ a                           shortened where a vertex would move farther than `maxMove`
//   strain ← 63/64 strain, and + 1 where a cell goes uphill within five evaluations from where it last did
//
// Nothing but a cell's own sums decides how it moves, so the same bits come out of any number of threads.
#include "physics/lane_vec3.h"

namespace morula::MORULA_ISA {

constexpr double steepestTurn = 0.25, turnDecay = 0.99, surelyDownhill = 5,
                 strainDecay = 1 - 1.0 / 64;  // as published, except α: 0.1 there

/// velocity ← v½' [PhysicsKernels::relaxVelocities]
inline void relaxVelocities(const TemplateView& mesh, const BlockView& b, const Relaxation& r) {
  for (int lane = 0; lane < b.liveLanes; lane += width) {
    Lanes power = 0.0, speeds = 0.0, squares = 0.0;
    for (int i = 0; i < mesh.vertexCount; ++i) {
      const Vec a = loadVec(b.acceleration, i, lane), v = loadVec(b.velocity, i, lane) - Lanes(0.5) * a;
      power += dot(a, v);
      speeds += dot(v, v);
      squares += dot(a, a);
    }
    const Mask downhill = power > Lanes(0.0);
    const Lanes before = load(r.alpha + lane), since = load(r.descents + lane) + 1.0;
    const Lanes decayed = select(since > Lanes(surelyDownhill), turnDecay * before, before);
    const Lanes alpha = select(downhill, decayed, steepestTurn);
    const Lanes kept = select(downhill, 1.0 - alpha, 0.0);
    const Lanes turned = select(downhill, alpha * sqrt(speeds / (squares + tiny)), 0.0) + 0.5;
    Lanes farthest = 0.0;
    for (int i = 0; i < mesh.vertexCount; ++i) {
      const Vec a = loadVec(b.acceleration, i, lane), v = loadVec(b.velocity, i, lane) - Lanes(0.5) * a;
      const Vec next = kept * v + turned * a;
      storeVec(b.velocity, i, lane, next);
      farthest = max(dot(next, next), farthest);
    }
    const Lanes most = load(r.maxMove + lane);
    const Mask tooFar = farthest > most * most;
    if (any(tooFar)) {
      const Lanes shortened = select(tooFar, most / sqrt(farthest), 1.0);
      for (int i = 0; i < mesh.vertexCount; ++i)
        storeVec(b.velocity, i, lane, shortened * loadVec(b.velocity, i, lane));
    }
    store(r.alpha + lane, alpha);
    const Lanes strain = load(r.strain + lane);
    store(r.strain + lane,
          select(downhill, strainDecay * strain, select(since > Lanes(surelyDownhill), strain, strain + 1.0)));
    store(r.descents + lane, select(downhill, since, 0.0));
    store(r.squares + lane, squares);
  }
}

}  // namespace morula::MORULA_ISA
