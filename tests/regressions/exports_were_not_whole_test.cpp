// A kill or a full disk left part of an exported folder under its final name, and the next call said "is there
// already". Now only whole folders get their name, and the next export removes the remains of killed ones.
#include <algorithm>
#include <csignal>
#include <filesystem>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
namespace fs = std::filesystem;

namespace {

struct Exports {
  TemporaryFolder folder;
  std::string database = folder / "run.db";
  Exports() { succeeds({"run", uniqueFour, "--db", database, "--no-pictures", "--no-check"}); }
  Words command(const std::string& kind) const {
    if (kind == "crate") return {"export", database, "--ro-crate", folder / "out"};
    return {"export", database, "--format", kind, "-o", folder / "out"};
  }
  Words files(const std::string& name) const {
    Words list;
    if (fs::exists(folder / name))
      for (const auto& entry : fs::recursive_directory_iterator(folder / name)) list.push_back(entry.path());
    std::sort(list.begin(), list.end());
    return list;
  }
  bool hasDrafts() const {
    return std::ranges::any_of(fs::directory_iterator(folder.path()), [](const fs::directory_entry& entry) {
      return entry.path().filename().string().starts_with(".morula-");
    });
  }
};

}  // namespace

TEST_CASE("an export that cannot be finished leaves no folder") {
  const Exports e;
  for (const std::string kind : {"csv", "vtk", "ply", "gltf", "crate"}) {
    CAPTURE(kind);
    // Files may not grow beyond a kilobyte: the first files are written, a later one fails.
    std::string line = "ulimit -f 2; '" + programFile() + "'";
    for (const std::string& word : e.command(kind)) line += " '" + word + "'";
    CHECK(std::system((line + " >/dev/null 2>&1").c_str()) != 0);
    CHECK(e.files("out").empty());
    CHECK_FALSE(fs::exists(e.folder / "out"));
    CHECK(launch(e.command(kind)).code == 0);
    CHECK(e.files("out").size() > 1);
    CHECK_FALSE(e.hasDrafts());
    fs::remove_all(e.folder / "out");
  }
}

TEST_CASE("an export that is killed at any moment leaves no folder or a whole one") {
  const Exports e;
  succeeds(e.command("csv"));
  const auto whole = e.files("out");
  for (int i = 0; i < 30; ++i) {
    fs::remove_all(e.folder / "out");
    launch(e.command("csv"), {}, [&](int process) {
      ::usleep(static_cast<useconds_t>(3'000 * i));
      ::kill(process, SIGKILL);
    });
    const auto left = e.files("out");
    CHECK((left.empty() || left == whole));
  }
  fs::remove_all(e.folder / "out");
  succeeds(e.command("csv"));  // this export removes the drafts of killed ones
  CHECK_FALSE(e.hasDrafts());
}

TEST_CASE("an export goes into an empty folder that is there, also the current one, and with a slash") {
  const Exports e;
  fs::create_directory(e.folder / "out");
  CHECK(launch({"export", e.database, "--format", "csv", "-o", e.folder / "out/"}).code == 0);
  CHECK(e.files("out").size() > 1);
  fs::create_directory(e.folder / "here");
  CHECK(std::system(("cd '" + e.folder / "here' && '" + programFile() + "' export ../run.db --ro-crate . >/dev/null")
                        .c_str()) == 0);
  CHECK(fs::exists(e.folder / "here/ro-crate-metadata.json"));
}
