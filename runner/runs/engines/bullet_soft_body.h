#pragma once
// Bullet's headers, in the precision of the library that is linked: double in the program, single in single/main.cpp.
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

// Headers link without error with a library of the other precision, and compute nonsense (checkPrecision).
#ifdef MORULA_SINGLE_BULLET
static_assert(sizeof(btScalar) == 4, "Bullet's single-precision headers are needed: bullet");
#else
static_assert(sizeof(btScalar) == 8, "Bullet's double-precision headers are needed: bullet-float64");
#endif
