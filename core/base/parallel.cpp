#include "base/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include <map>
#include <memory>
#include <mutex>

namespace morula {

namespace {

tbb::task_arena& arena(int threads) {
  static std::mutex mutex;
  static std::map<int, std::unique_ptr<tbb::task_arena>> arenas;
  const std::lock_guard lock(mutex);
  auto& slot = arenas[threads];
  if (!slot) slot = std::make_unique<tbb::task_arena>(threads);
  return *slot;
}

}  // namespace

void parallelFor(int count, int threads, void (*body)(void*, int), void* context) {
  if (threads <= 1 || count <= 1) {
    for (int i = 0; i < count; ++i) body(context, i);
    return;
  }
  arena(threads).execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<int>(0, count),
        [&](const tbb::blocked_range<int>& range) {
          for (int i = range.begin(); i != range.end(); ++i) body(context, i);
        },
        tbb::static_partitioner{});
  });
}

int threadNumber() {
  const int n = tbb::this_task_arena::current_thread_index();
  return n == tbb::task_arena::not_initialized ? 0 : n;
}

}  // namespace morula
