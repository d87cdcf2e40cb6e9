#pragma once
// A scene computed in a process of its own, by this program: such a process may hang or die, and Bullet's results
// depend on earlier computations. One question in JSON on the worker's stdin; on its stdout a line {"step": N} after
// each step of a scenario, and last a line {"answer": …}. Numbers in JSON are written in their shortest exact form,
// vectors of one kind as one flat list x, y, z, x, …; a number that is not finite becomes null, and NaN again. Readers
// throw Json::exception for anything that their writer did not write.
#include <iosfwd>
#include <string>

#include "engines/bullet_scene.h"
#include "engines/external_run.h"
#include "system/json.h"

namespace morula {

/// Answers a question, as the worker. Throws InputError for a question that cannot be read.
void serveEngine(std::istream& in, std::ostream& out);

/// Asks `program`, which is started with the words `internal engine-worker`. Throws FileError if the program cannot be
/// started or fails, InputError if its answer cannot be read; its own message is on stderr.
BulletResult runInBullet(const BulletRequest& request, const std::string& program);

/// Runs a scenario with mechanics in another engine. For the engine thesis, the scenario must already have the thesis'
/// contact law. Does not throw for failures on the other side.
ExternalRun runExternally(const Scenario& scenario, const ExternalQuestion& question, const std::string& program);

Json toJson(const BulletRequest& request);
BulletRequest bulletRequestFrom(const Json& json);

Json toJson(const BulletResult& result);
BulletResult bulletResultFrom(const Json& json);

Json toJson(const Scenario& scenario, const ExternalQuestion& question);
/// Reads the scenario as it was sent.
Scenario scenarioFrom(const Json& json);
ExternalQuestion externalQuestionFrom(const Json& json);

Json toJson(const ExternalRun& run);
ExternalRun externalRunFrom(const Json& json);

}  // namespace morula
