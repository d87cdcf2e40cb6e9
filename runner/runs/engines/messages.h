#pragma once
// What the program and its worker (engine_worker.h) tell each other, as JSON. Numbers are written in their shortest
// exact form, vectors of one kind as one flat list x, y, z, x, …; a number that is not finite becomes null, and NaN again.
// What reads throws Json::exception for anything that its counterpart did not write.
#include "engines/bullet_scene.h"
#include "engines/external_run.h"
#include "system/json.h"

namespace morula {

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
