// parallelFor with threads of the standard library instead of oneTBB's (MORULA_THREADS=std), for the thread sanitizer.
// The sanitizer sees how these threads begin and end, but cannot see into oneTBB's library.
#include "base/parallel.h"

#include <algorithm>
#include <cstdint>
#include <future>
#include <utility>
#include <vector>

#include "base/floating_point.h"

namespace morula {
namespace {

thread_local int thisThread = 0;

}  // namespace

void parallelFor(int count, int threads, void (*body)(void*, int), void* context) {
  const int parts = std::max(1, std::min(count, threads));
  const auto run = [&](int part) {
    setFloatingPoint();
    const int before = std::exchange(thisThread, part);
    const auto end = std::int64_t{count} * (part + 1) / parts;
    for (auto i = std::int64_t{count} * part / parts; i < end; ++i) body(context, static_cast<int>(i));
    thisThread = before;
  };
  std::vector<std::future<void>> others;  // their destructors wait for the threads
  for (int part = 1; part < parts; ++part) others.push_back(std::async(std::launch::async, run, part));
  run(0);
  for (auto& other : others) other.get();
}

int threadNumber() { return thisThread; }

}  // namespace morula
