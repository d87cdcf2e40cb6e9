#pragma once
// A scene computed in a process of its own, by this program once more: it may hang or die there, and what Bullet computes
// depends on what it did before. One question in JSON on the worker's stdin; on its stdout a line {"step": N} after each
// step of a scenario, and last a line {"answer": …} (messages.h).
#include <iosfwd>
#include <string>

#include "engines/bullet_scene.h"
#include "engines/external_run.h"

namespace morula {

/// The worker's side. Throws InputError for a question that cannot be read.
void serveEngine(std::istream& in, std::ostream& out);

/// The caller's side: asks `program`, which is started with the argument "engine-worker". Throws FileError if it cannot be
/// started or fails, InputError if its answer cannot be read; what it said of it is on stderr.
BulletResult runInBullet(const BulletRequest& request, const std::string& program);

/// The same of a scenario with mechanics; with the engine thesis it has that law already. Never throws for what goes wrong
/// on the other side.
ExternalRun runExternally(const Scenario& scenario, const ExternalQuestion& question, const std::string& program);

}  // namespace morula
