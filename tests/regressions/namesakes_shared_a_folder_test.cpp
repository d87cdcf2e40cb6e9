// Two scenario files of one name wrote into one folder, and the second run replaced the pictures of the first. Now the
// second file gets its own folder, with eight digits; a file that was only edited keeps its folder.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;

TEST_CASE("scenarios of one name in two files have folders of their own") {
  const TemporaryFolder folder;
  const auto text = [](int cycles) {
    return "morula: 1\nname: twin\nseed: 5\ndna: 'START: a0'\nstop: {cycles: " + std::to_string(cycles) + "}\n";
  };
  const auto databaseOf = [&](const std::string& file) {
    return jsonOf({"run", folder / file, "--out", folder / "results", "--no-check"})["db"].get<std::string>();
  };
  writeWhole(folder / "a.yaml", text(2));
  writeWhole(folder / "b.yaml", text(3));
  const std::string a = databaseOf("a.yaml");
  CHECK(a == folder / "results/twin-5/run.db");
  const std::string b = databaseOf("b.yaml");
  CHECK(b.starts_with(folder / "results/twin-5-"));
  CHECK(databaseOf("a.yaml") == a);
  CHECK(databaseOf("b.yaml") == b);
  writeWhole(folder / "a.yaml", text(4));
  CHECK(databaseOf("a.yaml") == a);
  writeWhole(folder / "copy.yaml", text(4));  // equal results: nothing can be lost
  CHECK(databaseOf("copy.yaml") == a);
}
