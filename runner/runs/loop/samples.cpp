#include "loop/samples.h"

#include "base/error.h"
#include "simulation/memory.h"
#include "simulation/simulation.h"
#include "system/console.h"

namespace morula {

void Samples::see(const World& world) {
  recorder_.observe(world);
  const double most = world.execution.memoryLimit / 2;
  if (recorder_.bytes() <= most) return;
  throw NumericalError(world.clock.step,
                       "samples, surfaces and hashes take " + bytesText(recorder_.bytes()) +
                           ", more than half of the memory limit of " + bytesText(world.execution.memoryLimit),
                       "record less often (record.every, record.meshes), stop earlier, or raise --memory-limit",
                       Want::memory);
}

void Samples::resume(const World& world, const Resumed& earlier) {
  earlier.eachRecord([&](const RunResults& records) { recorder_.resume(world, records); });
}

}  // namespace morula
