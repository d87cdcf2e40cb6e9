#pragma once
// A scene computed in a process of its own, by this program once more: it may hang or die there, and what Bullet
// computes depends on what it did before. One question in JSON on the worker's stdin; on its stdout a line {"step": N}
// after each step of a scenario, and last a line {"answer": …} . Numbers in JSON are written in their shortest exact
// form, vectors of one kind as one flat list x, y, z, x, …; a number that is not finite becomes null, and NaN again.
// Readers throw Json::exception for anything that their writer did not write.
#include <iosfwd>
#include <string>

#include "engines/bullet_scene.h"
#include "engines/external_run.h"
#include "system/json.h"

namespace morula {

/// The worker's side. Throws InputError for a question that cannot be read.
void serveEngine(std::istream& in, std::ostream& out);

/// The caller's side: asks `program`, which is started with the argument "engine-worker". Throws FileError if it cannot
/// be started or fails, InputError if its answer cannot be read; what it said of it is on stderr.
BulletResult runInBullet(const BulletRequest& request, const std::string& program);

/// Runs a scenario with mechanics in another engine; with the engine thesis the scenario has that law already. Never
/// throws for failures on the other side.
ExternalRun runExternally(const Scenario& scenario, const ExternalQuestion& question, const std::string& program);

Json toJson(const BulletRequest& request);
BulletRequest bulletRequestFrom(const Json& json);

Json toJson(const BulletResult& result);
BulletResult bulletResultFrom(const Json& json);

Json toJson(const Scenario& scenario, const ExternalQuestion& question);
/// The scenario as it was sent, and the question.
Scenario scenarioFrom(const Json& json);
ExternalQuestion externalQuestionFrom(const Json& json);

Json toJson(const ExternalRun& run);
ExternalRun externalRunFrom(const Json& json);

}  // namespace morula
