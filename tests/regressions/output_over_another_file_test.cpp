// render X -o X replaced the scenario, or the database of results, with a picture and ended with 0. Now commands
// replace only files of the kind that they write, whatever the files' endings, and the message names the other file's
// kind.
#include <sys/stat.h>

#include <filesystem>

#include "catch.h"
#include "hostile.h"

using namespace morula::test;

TEST_CASE("a picture does not replace a file of another kind") {
  const TemporaryFolder folder;
  const auto scenario = folder / "scenario.png", database = folder / "out/run.png";
  writeWhole(scenario, smallScene);
  succeeds({"run", "--quiet", "--no-pictures", "--no-check", "--db", database, "--out", folder / "out", scenario});
  writeWhole(folder / "genes.png", "START: a0\n");
  writeWhole(folder / "golden.png", "morula golden 1\n");
  writeWhole(folder / "letter.png", "Dear all\n");
  for (const auto& file : {scenario, database, folder / "genes.png", folder / "golden.png", folder / "letter.png"}) {
    CAPTURE(file);
    const auto before = readWhole(file);
    refuses({"render", "--quiet", "--style", "lineage", "-o", file, scenario}, 6, "would replace");
    CHECK(readWhole(file) == before);
  }
  // The files are drawings and papers of somebody else.
  const std::string svg = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"/>\n";
  writeWhole(folder / "mine.svg", svg);
  writeWhole(folder / "paper.pdf", "%PDF-1.5\n%\xd0\xd4\xc5\xd8\n");
  for (const auto& file : {folder / "mine.svg", folder / "paper.pdf"}) {
    CAPTURE(file);
    const auto before = readWhole(file);
    CHECK(launch({"lineage", "--quiet", "-o", file, scenario}).code == 6);
    CHECK(readWhole(file) == before);
  }
  // The ending .txt is not one of pictures.
  writeWhole(folder / "letter.txt", "Dear all\n");
  CHECK(launch({"render", "--quiet", "--style", "lineage", "-o", folder / "letter.txt", scenario}).code == 2);
  CHECK(readWhole(folder / "letter.txt") == "Dear all\n");
}

TEST_CASE("a picture replaces a picture and an empty file, and no link") {
  const TemporaryFolder folder;
  writeWhole(folder / "small.yaml", smallScene);
  writeWhole(folder / "empty.png", "");
  const auto draw = [&](const std::string& file) {
    return launch({"render", "--quiet", "--style", "lineage", "-o", file, folder / "small.yaml"}).code;
  };
  CHECK(draw(folder / "a.png") == 0);
  CHECK(draw(folder / "a.png") == 0);
  CHECK(draw(folder / "empty.png") == 0);
  std::filesystem::create_symlink("a.png", folder / "link.png");
  CHECK(draw(folder / "link.png") == 6);
  CHECK(std::filesystem::is_symlink(folder / "link.png"));
  std::filesystem::create_directory(folder / "folder.png");
  CHECK(draw(folder / "folder.png") == 6);
  REQUIRE(mkfifo((folder / "pipe.png").c_str(), 0600) == 0);
  CHECK(draw(folder / "pipe.png") == 6);
}

TEST_CASE("reports of a check replace reports only") {
  const TemporaryFolder folder;
  writeWhole(folder / "small.yaml", smallScene);
  const auto check = [&] { return launch({"check", "--quiet", "--reports", folder / "r", folder / "small.yaml"}); };
  check();
  CHECK(check().code != 6);
  writeWhole(folder / "r/report.json", "{\"mine\": 1}\n");
  CHECK(check().code == 6);
  CHECK(readWhole(folder / "r/report.json") == "{\"mine\": 1}\n");
}
