// Programs inherit much from their callers. With SIGCHLD ignored, waiting for child processes failed: a study and a
// film ended with "No child processes". Without /proc a study ended as a bug: "stoi". On systems that gave no threads,
// drawing waited forever for OpenGL's threads.
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "catch.h"
#include "hostile.h"

using namespace morula::test;

TEST_CASE("a study runs where its parent ignores the ends of others, and where there is no /proc") {
  const TemporaryFolder folder;
  writeWhole(folder / "small.yaml", smallScene);
  writeWhole(folder / "few.study.yaml",
             "morula-study: 1\nname: few\nbase: small.yaml\nseeds: 1\nmeasures: [cells]\n"
             "vary: {cycles: {two: {stop.cycles: 2}, three: {stop.cycles: 3}}}\n");
  Words places{"env --ignore-signal=CHLD "};
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // sanitizers read their memory map in /proc
  places.push_back("unshare -m sh -c 'mount -t tmpfs none /proc && exec \"$@\"' x ");
#endif
  for (const std::string& as : places) {
    const auto ended = [&](const std::string& program) {
      const int status = std::system(("cd '" + folder.path() + "' && " + as + program + " >said 2>&1").c_str());
      return WEXITSTATUS(status);
    };
    if (ended("true") != 0) {
      WARN("skipped: this system does not allow " + as);
      continue;
    }
    const int code = ended("'" + programFile() + "' study run few.study.yaml --no-predict --out out && rm -r out");
    INFO(as << readWhole(folder / "said"));
    CHECK(code == 0);
  }
}

TEST_CASE("a picture is drawn where no threads are to be had") {
  const TemporaryFolder folder;
  writeWhole(folder / "body.yaml", smallBody);
  const auto drawn = [&](const std::string& as, const std::string& picture) {
    return std::system(("cd '" + folder.path() + "' && chmod 777 . && " + as + " '" + programFile() +
                        "' render body.yaml -o " + picture + " >said 2>&1")
                           .c_str());
  };
  const std::string alone = "timeout 600 " +
                            std::string(::geteuid() == 0 ? "setpriv --reuid 65533 --clear-groups " : "") +
                            "prlimit --nproc=1";
  if (std::system((alone + " '" + programFile() + "' --version >/dev/null 2>&1").c_str()) != 0) {
    WARN("skipped: this system does not allow " + alone);
    return;
  }
  REQUIRE(drawn("", "usual.png") == 0);
  const int status = drawn(alone, "alone.png");
  INFO(readWhole(folder / "said"));
  CHECK(status == 0);
  CHECK(readWhole(folder / "alone.png") == readWhole(folder / "usual.png"));
}
