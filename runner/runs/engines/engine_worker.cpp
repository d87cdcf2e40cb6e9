#include "engines/engine_worker.h"

#include <algorithm>
#include <istream>
#include <ostream>

#include "base/error.h"
#include "engines/bullet_world.h"
#include "engines/messages.h"
#include "system/child_process.h"
#include "system/clock.h"

namespace morula {
namespace {

constexpr const char* workerVerb = "engine-worker";

BulletResult runRequest(const BulletRequest& request) {
  BulletWorld world(request.scene);
  BulletResult result;
  for (int i = 1; i <= request.steps; ++i) {
    result.stepSeconds.push_back(timeOf(ClockKind::process, [&] { world.step(); }));
    if (std::binary_search(request.reports.begin(), request.reports.end(), i)) result.reports.push_back(world.cells());
  }
  result.cells = world.cells();
  return result;
}

Json answerTo(const Json& question, std::ostream& out) {
  if (!question.contains("scenario")) return toJson(runRequest(bulletRequestFrom(question)));
  return toJson(runHere(question, [&](std::uint64_t step) {
    out << jsonText({{"step", step}}) << std::endl;  // so that a process that dies has said how far it came
  }));
}

/// The last line that arrived whole; null if there is none.
Json lastMessage(const std::string& said) {
  for (auto end = said.rfind('\n'); end != said.npos && end > 0;) {
    const auto before = said.rfind('\n', end - 1);
    const auto begin = before == said.npos ? 0 : before + 1;
    Json message = tryParseJson(std::string_view(said).substr(begin, end - begin));
    if (message.is_object()) return message;
    end = before;
  }
  return {};
}

}  // namespace

void serveEngine(std::istream& in, std::ostream& out) {
  try {
    out << jsonText({{"answer", answerTo(parseJson(std::string(std::istreambuf_iterator<char>(in), {})), out)}})
        << std::endl;
  } catch (const Json::exception& error) {
    throw InputError(std::string("the question to another engine cannot be read: ") + error.what());
  }
}

BulletResult runInBullet(const BulletRequest& request, const std::string& program) {
  const ChildEnd end = runChild({program, workerVerb}, {.input = jsonText(toJson(request))});
  if (!end.well()) throw FileError("Bullet's process " + program + " " + end.text());
  try {
    return bulletResultFrom(lastMessage(end.said).at("answer"));
  } catch (const Json::exception& error) {
    throw InputError(std::string("Bullet's answer cannot be read: ") + error.what());
  }
}

ExternalRun runExternally(const Scenario& scenario, const ExternalQuestion& question, const std::string& program) {
  const ChildEnd end = runChild({program, workerVerb},
                                {.input = jsonText(toJson(scenario, question)), .cpuSeconds = question.cpuSeconds});
  const Json message = lastMessage(end.said);
  ExternalRun silent;
  if (message.is_object() && message.contains("step") && message["step"].is_number_unsigned())
    message["step"].get_to(silent.step);
  if (end.outOfTime()) silent.why = "no answer within " + std::to_string(question.cpuSeconds) + " s of CPU time";
  else if (!end.well()) silent.why = "its process " + end.text();
  else silent.why = "its answer is cut";
  if (!end.well()) return silent;
  try {
    return externalRunFrom(message.at("answer"));
  } catch (const Json::exception&) { return silent; }
}

}  // namespace morula
