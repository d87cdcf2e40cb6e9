// Two tests of the terminal failed with "no terminal to be had" on systems without pseudo-terminals. Now they are
// skipped there, with a message.
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include "catch.h"
#include "launch.h"

using namespace morula::test;

// The test runs in a process without /dev: in its own user and mount namespace, if the system allows one.
TEST_CASE("launchOnTerminal tells that there is no terminal, and throws nothing") {
  enum Outcome { told, notTold, notAllowed };
  const int child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    if (unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0 && unshare(CLONE_NEWNS) != 0) _exit(notAllowed);
    // Mounts must not reach other processes.
    if (mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) _exit(notAllowed);
    if (mount("none", "/dev", "tmpfs", 0, nullptr) != 0) _exit(notAllowed);
    try {
      _exit(launchOnTerminal({"--version"}) ? notTold : told);
    } catch (...) { _exit(notTold); }
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(WIFEXITED(status));
  if (WEXITSTATUS(status) == notAllowed) {
    WARN("skipped: no mount namespaces here");
    return;
  }
  CHECK(WEXITSTATUS(status) == told);
}

TEST_CASE("where there is a terminal, it is used") {
  const auto run = launchOnTerminal({"--version"});
  if (!run) {
    WARN(skippedWithoutTerminal);
    return;
  }
  CHECK(run->code == 0);
}
