#pragma once
// One cell as Bullet's soft body, and what must be set so that Bullet computes our forces.
#include <memory>
#include <vector>

#include "engines/bullet_soft_body.h"
#include "engines/bullet_world.h"

namespace morula {

/// Nodes, links with the cell's own rest lengths, faces; a tree of faces only where cells touch, for Bullet
/// updates it in every step. B1 does not solve links: it has them, and faces, only where cells touch, for
/// Bullet's tree of faces needs them.
std::unique_ptr<btSoftBody> makeSoftBody(const BulletScene& scene, const MeshTemplate& mesh, const Body& cell,
                                         btSoftBodyWorldInfo& info);

/// B2: Bullet's pressure for this step, f = n·A·kPR/V, such that it is P = k_p/V − P_0 on true areas.
void setPressure(btSoftBody& body, double pressureConstant, double outside);

/// Neither gravity nor air acts on bodies of this world.
void makeWeightless(btSoftBodyWorldInfo& info, btBroadphaseInterface& broadphase, btDispatcher& dispatcher);

/// Throws BugError if Bullet measures another volume of the egg than we do: then its headers and its library
/// are of different precision.
void checkPrecision(const Mesh& egg, btSoftBodyWorldInfo& info);

/// The scene's cells as the bodies are now.
std::vector<Body> readCells(const BulletScene& scene, const std::vector<std::unique_ptr<btSoftBody>>& bodies);

/// makeBulletWorld for B3.
std::unique_ptr<BulletWorld> makeImplicitWorld(const BulletScene& scene);

}  // namespace morula
