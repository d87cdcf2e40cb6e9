// A signal that ended the drawing of a film left its temporary folder of pictures.
#include <csignal>
#include <filesystem>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
namespace fs = std::filesystem;

namespace {

/// A film drawn with a fake ffmpeg that starts and then takes long.
struct Film {
  TemporaryFolder folder;
  Film() {
    fs::create_directory(folder / "bin");
    writeWhole(folder / "bin/ffmpeg", "#!/bin/sh\ncase \"$*\" in *-version) exit 0;; esac\n: >\"$STARTED\"\nexec sleep 5 >/dev/null 2>&1\n");
    fs::permissions(folder / "bin/ffmpeg", fs::perms::owner_all);
    fs::create_directory(folder / "films");
  }
  Launched ended(int signal) const {
    return launch({"render", "scenarios/thesis/unique-four.yaml", "--time", "0", "--size", "64", "--turntable", "2",
                   "-o", folder / "films/a.gif"},
                  {{"PATH", folder / "bin:" + std::getenv("PATH")}, {"STARTED", folder / "started"}}, [&](int process) {
                    while (!fs::exists(folder / "started") && ::kill(process, 0) == 0) ::usleep(2'000);
                    ::kill(process, signal);
                  });
  }
  bool isEmpty() const { return fs::is_empty(folder / "films"); }
};

}  // namespace

TEST_CASE("a film that is interrupted leaves nothing behind") {
  for (const int signal : {SIGTERM, SIGINT}) {
    const Film film;
    CHECK(film.ended(signal).code == 128 + signal);
    CHECK(film.isEmpty());
  }
}

TEST_CASE("what a killed film leaves behind is removed by the next") {
  const Film film;
  CHECK(film.ended(SIGKILL).code == 128 + SIGKILL);
  CHECK_FALSE(film.isEmpty());
  fs::remove(film.folder / "started");
  CHECK(film.ended(SIGTERM).code == 128 + SIGTERM);
  CHECK(film.isEmpty());
}
