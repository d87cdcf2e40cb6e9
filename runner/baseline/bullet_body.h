#pragma once
// One cell as Bullet's soft body, and the traps on the way there.
#include <memory>

#include "baseline/bullet_scene.h"
#include "baseline/bullet_soft_body.h"

namespace morula {

/// Nodes, links with the cell's own rest lengths, faces. B1 keeps the links, which Bullet's face tree needs,
/// and does not solve them.
std::unique_ptr<btSoftBody> makeSoftBody(const BulletScene& scene, const MeshTemplate& mesh, const Body& cell,
                                         btSoftBodyWorldInfo& info);

/// B2: Bullet's pressure for this step, f = n·A·kPR/V, such that it is P = k_p/V − P_0 on true areas.
void setPressure(btSoftBody& body, double pressureConstant, double outside);

/// [length³] as Bullet measures it. Wrong if headers and library disagree on the precision.
double volumeOf(const btSoftBody& body);

}  // namespace morula
