#pragma once
// One cell as Bullet's soft body, with settings by which Bullet computes our forces.
#include <memory>
#include <vector>

#include "engines/bullet_soft_body.h"
#include "engines/bullet_world.h"

namespace morula {

/// Makes nodes, links with the cell's own rest lengths, and faces. Only touching cells get a tree of faces, which
/// Bullet updates in every step. B1 does not solve links; it has links and faces only where cells touch, since the tree
/// of faces needs them.
std::unique_ptr<btSoftBody> makeSoftBody(const BulletScene& scene, const MeshTemplate& mesh, const Body& cell,
                                         btSoftBodyWorldInfo& info);

/// Sets B2's pressure in Bullet for this step, f = n·A·kPR/V, such that it is P = k_p/V − P_0 on true areas.
void setPressure(btSoftBody& body, double pressureConstant, double outside);

/// Switches gravity and air off for the bodies of this world.
void makeWeightless(btSoftBodyWorldInfo& info, btBroadphaseInterface& broadphase, btDispatcher& dispatcher);

/// Throws BugError if Bullet measures another volume of the egg than we do: then its headers and its library differ in
/// precision.
void checkPrecision(const Mesh& egg, btSoftBodyWorldInfo& info);

/// Returns the scene's cells with the present state of the bodies.
std::vector<Body> readCells(const BulletScene& scene, const std::vector<std::unique_ptr<btSoftBody>>& bodies);

/// Makes the world of B3 for makeBulletWorld.
std::unique_ptr<BulletWorld> makeImplicitWorld(const BulletScene& scene);

}  // namespace morula
