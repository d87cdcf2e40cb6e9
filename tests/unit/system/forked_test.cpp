// Forked processes: their answers, ends and limits.
#include "system/forked.h"

#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <new>
#include <thread>
#include <vector>

#include "base/error.h"
#include "catch.h"

using namespace morula;

namespace {

[[noreturn]] void loopForEver() {
  while (true) ::getppid();
}

}  // namespace

TEST_CASE("the answer of a process arrives, cut off after 16 KiB") {
  Forked process({}, [] { return ForkedAnswer{3, "some words"}; });
  const ForkedEnd end = process.wait();
  CHECK((end.signal == 0 && end.answer.code == 3 && end.answer.text == "some words"));
  Forked talker({}, [] { return ForkedAnswer{0, std::string(1'000'000, 'x')}; });
  CHECK(talker.wait().answer.text == std::string(16384, 'x'));
}

#if !defined(__SANITIZE_THREAD__)  // ThreadSanitizer has a thread of its own, so Forked does not count threads
TEST_CASE("a process with several threads cannot be forked") {
  std::atomic<bool> over = false;
  std::thread other([&] {
    while (!over) std::this_thread::yield();
  });
  CHECK_THROWS_AS(Forked({}, [] { return ForkedAnswer{}; }), BugError);
  over = true;
  other.join();
}
#endif

TEST_CASE("a signal right after the fork ends the new process as a later one would") {
  // The new process does not inherit this process's signal handler, which would end it with exit code 99.
  struct sigaction before {
  }, here{};
  here.sa_handler = [](int) { ::_exit(99); };
  ::sigaction(SIGTERM, &here, &before);
  int ended = 0;
  for (int i = 0; i < 200; ++i) {
    Forked process({}, []() -> ForkedAnswer { loopForEver(); });
    process.stop(SIGTERM);
    ended += process.wait().signal == SIGTERM;
  }
  ::sigaction(SIGTERM, &before, nullptr);
  CHECK(ended == 200);
}

TEST_CASE("a forked process changes only its own memory") {
  int number = 1;
  Forked process({}, [&] { return ForkedAnswer{++number, ""}; });
  CHECK(process.wait().answer.code == 2);
  CHECK(number == 1);
}

TEST_CASE("endedAmong returns only processes that have ended") {
  std::vector<Forked> processes;
  for (int i = 0; i < 3; ++i)
    processes.emplace_back(ForkedLimits{}, [i]() -> ForkedAnswer {
      if (i != 1) loopForEver();
      return {};
    });
  const std::vector<Forked*> all{&processes[0], &processes[1], &processes[2]};
  std::vector<std::size_t> ended;
  while (ended.empty()) ended = endedAmong(all, 10);
  CHECK(ended == std::vector<std::size_t>{1});
  processes[0].stop(SIGTERM);
  CHECK(processes[0].wait().signal == SIGTERM);
  // The destructor of `processes` ends the process that still runs.
}

TEST_CASE("limits end a process and no other") {
  Forked slow({.cpuSeconds = 0.5}, []() -> ForkedAnswer { loopForEver(); });
  const ForkedEnd end = slow.wait();
  CHECK(end.signal == SIGXCPU);
  CHECK(end.cpuSeconds > 0);  // the system decides how much time passes before the signal
  CHECK(signalName(SIGXCPU) == "SIGXCPU");
  if (!memoryCanBeLimited) return;
  const auto allocate = [] {
    try {
      const std::vector<char> large(200'000'000, 'x');
      return ForkedAnswer{large.back() == 'x' ? 0 : 1, ""};
    } catch (const std::bad_alloc&) { return ForkedAnswer{71, ""}; }
  };
  CHECK(Forked({.memory = 100'000'000}, allocate).wait().answer.code == 71);
  CHECK(Forked({.memory = 400'000'000}, allocate).wait().answer.code == 0);
}
