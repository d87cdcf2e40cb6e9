#pragma once
// Bullet's headers, in the precision of the library that this room links.
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

// Float headers link silently with the double library, and compute nonsense.
static_assert(sizeof(btScalar) == 8, "Bullet's double-precision headers are needed: bullet-float64");
