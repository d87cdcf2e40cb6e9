// Child processes, by shell scripts that behave well and badly.
#include "system/child_process.h"

#include <sys/time.h>
#include <sys/wait.h>

#include <csignal>
#include <new>

#include "base/error.h"
#include "catch.h"
#include "system/forked.h"

using namespace morula;

namespace {

ChildEnd shell(const std::string& script, const ChildOptions& options = {}) {
  return runChild({"sh", "-c", script}, options);
}

/// Sends this process a signal every millisecond during its lifetime; interrupted system calls are not restarted.
class Interruptions {
 public:
  Interruptions() {
    struct sigaction quiet {};
    quiet.sa_handler = [](int) {};
    ::sigaction(SIGALRM, &quiet, &before_);
    set(1000);
  }
  ~Interruptions() {
    set(0);
    ::sigaction(SIGALRM, &before_, nullptr);
  }

 private:
  static void set(long microseconds) {
    const itimerval timer{{0, microseconds}, {0, microseconds}};
    ::setitimer(ITIMER_REAL, &timer, nullptr);
  }
  struct sigaction before_ {};
};

}  // namespace

TEST_CASE("A child hears its text to the end, and all that it says is heard") {
  const std::string text(300'000, 'x');  // more than a pipe holds
  const ChildEnd end = runChild({"cat"}, {.input = text});
  CHECK(end.well());
  CHECK(end.said == text);
  CHECK(shell("echo some; exec true", {.input = text}).said == "some\n");  // the child reads none of the text
}

TEST_CASE("How a child ended is told") {
  const ChildEnd three = shell("echo before; exit 3");
  CHECK_FALSE(three.well());
  CHECK((three.code() == 3 && three.said == "before\n" && three.text() == "ended with code 3"));
  const ChildEnd killed = shell("kill -9 $$");
  CHECK((killed.code() == 128 + 9 && killed.text() == "was ended by signal 9" && !killed.outOfTime()));
  CHECK(shell("while :; do :; done", {.cpuSeconds = 1}).outOfTime());
  CHECK(runChild({"/nowhere/program"}).notStarted());
  CHECK(runChild({"no-program-of-this-name"}).notStarted());
  CHECK_FALSE(three.notStarted());
}

TEST_CASE("Signals that interrupt us cut no answer, and the child is waited for") {
  const Interruptions often;
  for (int turn = 0; turn < 5; ++turn) {
    const ChildEnd end = shell("sleep 0.03; echo all; exec >&-; sleep 0.03; exit 5");
    CHECK(end.said == "all\n");
    CHECK(end.code() == 5);
  }
}

TEST_CASE("Where there is no memory for what a child says, it is ended and waited for, and we go on") {
  if (!memoryCanBeLimited) return;
  const auto work = []() -> ForkedAnswer {
    try {
      runChild({"cat", "/dev/zero"}, {.input = std::string(300'000, 'x')});  // cat reads none of the text
    } catch (const std::bad_alloc&) { return {::waitpid(-1, nullptr, WNOHANG) < 0 ? 71 : 1, ""}; }
    return {0, ""};
  };
  CHECK(Forked({.memory = 400'000'000}, work).wait().answer.code == 71);
}
