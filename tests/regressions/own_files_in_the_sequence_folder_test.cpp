// `morula run` removed the whole folder `sequence` of an earlier run, with the user's files in it. Now it removes only
// pictures that Morula wrote and that the new run does not replace.
#include <filesystem>

#include "catch.h"
#include "hostile.h"

using namespace morula::test;

TEST_CASE("run: files of the user's in the sequence folder stay") {
  const TemporaryFolder folder;
  const auto sequence = folder.path() + "/body-0/sequence/";
  const auto run = [&](const std::string& every) {
    writeWhole(folder / "body.yaml", smallBody + "record: {pictures: " + every + "}\n");
    succeeds({"run", "--quiet", "--no-check", "--out", folder.path(), folder / "body.yaml"});
  };
  run("0.015625");
  REQUIRE(std::filesystem::exists(sequence + "0002.png"));
  writeWhole(sequence + "notes.txt", "mine\n");
  writeWhole(sequence + "cover.png", readWhole(sequence + "0000.png"));
  const std::string foreign = replaced(readWhole(sequence + "0000.png"), "Morula", "Camera");
  writeWhole(sequence + "0009.png", foreign);
  run("0.03125");
  CHECK(readWhole(sequence + "notes.txt") == "mine\n");
  CHECK(std::filesystem::exists(sequence + "cover.png"));
  CHECK(readWhole(sequence + "0009.png") == foreign);
  CHECK(std::filesystem::exists(sequence + "0001.png"));
  CHECK_FALSE(std::filesystem::exists(sequence + "0002.png"));  // a picture of the longer sequence
}
