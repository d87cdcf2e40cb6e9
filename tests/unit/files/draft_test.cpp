// Drafts: files that take their place when they are whole, and remains of processes that died.
#include "files/draft.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "catch.h"
#include "files/folders.h"
#include "temporary_folder.h"

using namespace morula;

TEST_CASE("a draft is nothing to a reader until it takes its place, and then all of it") {
  const TemporaryFolder folder;
  writeText(folder / "a.txt", "before");
  {
    Draft draft(folder / "a.txt");
    draft.write("af");
    draft.write("ter");
    CHECK(readText(folder / "a.txt") == "before");
    draft.takePlace();
  }
  CHECK(readText(folder / "a.txt") == "after");
  { Draft(folder / "a.txt").write("never whole"); }
  CHECK(readText(folder / "a.txt") == "after");
  CHECK(namesIn(folder.path()).size() == 1);
  CHECK_THROWS_AS(Draft(folder / "none/a.txt"), FileError);
}

namespace {

/// Leaves a draft as a killed process does: nothing is cleaned up.
void dieWriting(const std::filesystem::path& file) {
  const pid_t child = fork();
  if (child == 0) {
    Draft draft(file);
    draft.write("half");
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
}

}  // namespace

TEST_CASE("what a dead process has left is removed, and what a living one writes stays") {
  const TemporaryFolder folder;
  dieWriting(folder / "a.txt");
  writeText(folder / ".morula-mine", "");
  writeText(folder / "theirs.part", "");
  REQUIRE(namesIn(folder.path()).size() == 3);
  Draft living(folder / "b.txt");  // this process's first draft in the folder, so it looks for remains
  CHECK(namesIn(folder.path()).size() == 3);
  living.write("not yet");
  CHECK(removeAbandonedDrafts(folder.path()) == 0);
  dieWriting(folder / "c.txt");
  CHECK(namesIn(folder.path()).size() == 4);
  CHECK(removeAbandonedDrafts(folder.path()) == 1);
  CHECK(namesIn(folder.path()).size() == 3);
  living.takePlace();
  CHECK(readText(folder / "b.txt") == "not yet");
  CHECK(removeAbandonedDrafts(folder / "none") == 0);
}
