#include "base/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "base/floating_point.h"

namespace morula {
namespace {

tbb::task_arena& arena(int threads) {
  static std::mutex mutex;
  static std::map<int, std::unique_ptr<tbb::task_arena>> arenas;
  static std::unique_ptr<tbb::global_control> limit;  // without a limit, TBB does not exceed the number of cores
  const std::lock_guard lock(mutex);
  auto& slot = arenas[threads];
  if (!slot) {
    const auto most = static_cast<std::size_t>(std::max(threads, arenas.rbegin()->first));
    limit.reset();  // of several limits the lowest would count
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, most);
    slot = std::make_unique<tbb::task_arena>(threads);
  }
  return *slot;
}

// Number of this thread in the innermost parallelFor, even if that is a plain loop in the body of another.
thread_local int thisThread = 0;

struct Numbered {
  explicit Numbered(int n) : before(std::exchange(thisThread, n)) {}
  ~Numbered() { thisThread = before; }
  Numbered(const Numbered&) = delete;
  Numbered& operator=(const Numbered&) = delete;
  int before;
};

}  // namespace

void parallelFor(int count, int threads, void (*body)(void*, int), void* context) {
  if (threads <= 1 || count <= 1) {
    const Numbered first(0);
    for (int i = 0; i < count; ++i) body(context, i);
    return;
  }
  arena(threads).execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<int>(0, count),
        [&](const tbb::blocked_range<int>& range) {
          setFloatingPoint();
          const Numbered own(tbb::this_task_arena::current_thread_index());
          for (int i = range.begin(); i != range.end(); ++i) body(context, i);
        },
        tbb::static_partitioner{});
  });
}

int threadNumber() { return thisThread; }

}  // namespace morula
