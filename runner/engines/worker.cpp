#include "engines/worker.h"

#include <algorithm>
#include <ctime>
#include <sstream>

#include "base/error.h"
#include "engines/bullet_world.h"
#include "engines/wire.h"
#include "system/child_process.h"

namespace morula {

namespace {

double cpuSeconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

void serveBullet(std::istream& in, std::ostream& out) {
  const BulletRequest request = readRequest(in);
  BulletWorld world(request.scene);
  BulletResult result;
  for (int i = 0; i < request.steps; ++i) {
    const double before = cpuSeconds();
    world.step();
    result.stepSeconds.push_back(cpuSeconds() - before);
    if (std::binary_search(request.reports.begin(), request.reports.end(), i + 1))
      result.reports.push_back(world.cells());
  }
  result.cells = world.cells();
  writeResult(out, result);
}

BulletResult runInBullet(const BulletRequest& request, const std::string& program) {
  std::ostringstream text;
  writeRequest(text, request);
  const ChildEnd end = runChild({program, "bullet-worker"}, {.input = text.str()});
  if (!end.well()) throw FileError("Bullet's process " + program + " " + end.text());
  std::istringstream in(end.said);
  return readResult(in);
}

}  // namespace morula
