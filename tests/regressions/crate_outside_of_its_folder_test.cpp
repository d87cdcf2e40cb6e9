// export --ro-crate wrote to places that a stranger's database named: run_document.role or path could be absolute or
// climb with `..`. Now every file of a crate lies in its folder, under a safe and unique name.
#include <filesystem>
#include <set>

#include "catch.h"
#include "hostile.h"
#include "stored.h"

using namespace morula::test;
namespace fs = std::filesystem;

namespace {

/// Makes a run in the folder `in` and returns its database.
std::string storedIn(const TemporaryFolder& folder) {
  const auto database = folder / "in/run.db";
  writeWhole(folder / "small.yaml", smallScene);
  succeeds({"run", "--quiet", "--no-check", "--no-pictures", "--db", database, "--out", folder / "in",
            folder / "small.yaml"});
  return database;
}

}  // namespace

TEST_CASE("export: names from a database stay in the crate") {
  const TemporaryFolder folder;
  const std::string database = storedIn(folder);
  const std::string outside = folder / "outside";
  int number = 0;
  for (const std::string& name :
       {outside, outside + "/x", std::string("../../outside"), std::string(".."), std::string("."),
        std::string("a/../../../outside"), std::string("..\\outside"), std::string(400, 'x'),
        std::string("\x1b[31m\n\xff"), std::string("run.db"), std::string("resolved.json"), std::string()})
    for (const char* column : {"role", "path"}) {
      CAPTURE(name, column);
      change(database, std::string("UPDATE run_document SET ") + column + " = ?", name);
      const auto crate = folder / ("out/crate" + std::to_string(++number));
      const auto run = launch({"export", database, "--ro-crate", crate});
      CAPTURE(run.err);
      CHECK((run.code == 0 || run.code == 6));
      CHECK_FALSE(fs::exists(outside));
      for (const auto& entry : fs::directory_iterator(folder.path()))
        CHECK(std::set<std::string>{"in", "out", "small.yaml"}.contains(entry.path().filename().string()));
      for (const auto& entry : fs::directory_iterator(folder / "out"))
        CHECK(entry.path().filename().string().starts_with("crate"));
      if (run.code != 0) continue;
      std::size_t files = 0;
      for (const auto& entry : fs::recursive_directory_iterator(crate)) {
        files += entry.is_regular_file();
        CHECK(harmfulByte(entry.path().string()) == "");
      }
      CHECK(files >= 4);  // two documents, the database and the metadata
    }
}

TEST_CASE("export: no file is copied because a database names its scenario elsewhere") {
  const TemporaryFolder folder;
  const std::string database = storedIn(folder);
  writeWhole(folder / "secret.golden", "morula golden 1\nhunter2\n");
  change(database, "UPDATE run_document SET path = ? WHERE role = 'scenario'", folder / "secret.yaml");
  fs::create_symlink("../secret.golden", folder / "in/organism.png");
  succeeds({"export", database, "--ro-crate", folder / "crate"});
  for (const auto& entry : fs::recursive_directory_iterator(folder / "crate"))
    if (entry.is_regular_file()) CHECK(readWhole(entry.path().string()).find("hunter2") == std::string::npos);
}
