#pragma once
// Bullet in a process of its own: one simulation per process, for its results are the same again only in a
// fresh one.
#include <iosfwd>
#include <string>

#include "engines/bullet_scene.h"
#include "system/child_process.h"  // ownProgram

namespace morula {

/// The worker's side: reads one request, runs it, writes the result. A NaN in the request or result passes
/// through.
void serveBullet(std::istream& in, std::ostream& out);

/// The caller's side: starts `program` with the argument "bullet-worker", hands the request over and waits.
/// Throws FileError if it cannot be started or fails; what it said is on stderr then.
BulletResult runInBullet(const BulletRequest& request, const std::string& program);

}  // namespace morula
