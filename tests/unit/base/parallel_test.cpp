// Work split over threads: each index once, each thread with a number of its own.
#include "base/parallel.h"

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include "catch.h"

using namespace morula;

TEST_CASE("Every index is worked on once, on any number of threads") {
  for (int threads : {1, 2, 3, 7, 16})
    for (int count : {0, 1, 2, 5, 1000}) {
      std::vector<std::atomic<int>> visits(count);
      parallelFor(count, threads, [&](int i) { ++visits[i]; });
      for (const auto& v : visits) CHECK(v == 1);
    }
}

TEST_CASE("Threads have numbers below their number, and no two one at a time") {
  for (int threads : {1, 2, 3, 7}) {
    std::vector<std::atomic<int>> busy(threads);
    std::atomic<int> wrong = 0;
    parallelFor(500, threads, [&](int) {
      const int n = threadNumber();
      if (n < 0 || n >= threads) {
        ++wrong;
        return;
      }
      if (++busy[n] != 1) ++wrong;
      std::this_thread::yield();
      --busy[n];
    });
    CHECK(wrong == 0);
  }
}

TEST_CASE("A loop on one thread has number 0, also within another loop's thread") {
  std::atomic<int> wrong = 0;
  parallelFor(64, 4, [&](int) {
    const int outer = threadNumber();
    parallelFor(3, 1, [&](int) { wrong += threadNumber() != 0; });
    wrong += threadNumber() != outer;
    std::this_thread::sleep_for(std::chrono::microseconds(200));  // gives other threads time to start
  });
  CHECK(wrong == 0);
  CHECK(threadNumber() == 0);
}
