// Reading files, and which files may be overwritten.
#include <sys/stat.h>

#include "base/error.h"
#include "catch.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "files/write_file.h"
#include "temporary_folder.h"

using namespace morula;
namespace fs = std::filesystem;

TEST_CASE("files are read whole, up to a size") {
  TemporaryFolder folder;
  writeText(folder / "a", std::string(5000, 'x'));
  CHECK(readFile(folder / "a") == std::string(5000, 'x'));
  CHECK(readFile(folder / "a", 5000).size() == 5000);
  CHECK_THROWS_WITH(readFile(folder / "a", 4999), ContainsSubstring("holds more than"));
  CHECK(readHead(folder / "a", 3) == "xxx");
  CHECK(readHead(folder / "none", 3).empty());
  CHECK(readFile("/proc/self/status").find("Name:") != std::string::npos);
}

TEST_CASE("only regular files are read, and nothing is waited for") {
  TemporaryFolder folder;
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  CHECK_THROWS_WITH(readFile(folder / "pipe"), ContainsSubstring("is a pipe"));
  CHECK_THROWS_WITH(readFile(folder.path()), ContainsSubstring("is a folder"));
  CHECK_THROWS_WITH(readFile("/dev/zero"), ContainsSubstring("is a device"));
  CHECK_THROWS_WITH(readFile(folder / "none"), ContainsSubstring("No such file"));
  CHECK_THROWS_AS(readFile(folder / std::string(300, 'n')), FileError);
  CHECK(readHead(folder / "pipe", 3).empty());
}

TEST_CASE("files are told by what they hold") {
  for (const auto& [head, content] : {std::pair{"", Content::empty},
                                      {"\x89PNG\r\n\x1a\n...", Content::picture},
                                      {"morula golden 1\n", Content::golden},
                                      {"<<<<<<< HEAD\nmorula golden 1\n", Content::golden},
                                      {"# mine\nmorula: 1\n", Content::scenario},
                                      {"morula-study: 1\n", Content::scenario},
                                      {"START: a0\n", Content::dna},
                                      {"### morula check\n\n", Content::report},
                                      {"Dear all,\n", Content::other}})
    CHECK(contentOf(head) == content);
  CHECK(contentOf(std::string_view("SQLite format 3\0", 16)) == Content::database);
}

TEST_CASE("a file replaces its own kind only, and no link") {
  TemporaryFolder folder;
  const auto file = folder / "a";
  const std::string picture = "\x89PNG\r\n\x1a\n", dna = "START: a0\n";
  writeFile(file, picture, Content::picture);
  writeFile(file, picture + "2", Content::picture);
  CHECK(readText(file) == picture + "2");
  CHECK_THROWS_WITH(writeFile(file, dna, Content::dna), ContainsSubstring("is a picture, which DNA would replace"));
  CHECK_THROWS_AS(writeNewFile(file, dna), FileError);
  CHECK(readText(file) == picture + "2");
  overwriteFile(file, dna);
  CHECK(readText(file) == dna);
  fs::create_symlink("elsewhere", folder / "link");
  CHECK_THROWS_WITH(overwriteFile(folder / "link", dna), ContainsSubstring("symbolic link"));
  CHECK_THROWS_WITH(writeFile(folder.path(), dna, Content::dna), ContainsSubstring("folder"));
  CHECK_FALSE(fs::exists(folder / "elsewhere"));
  CHECK(namesIn(folder.path()) == std::vector<fs::path>{"a", "link"});  // no draft is left
}

TEST_CASE("where names lead") {
  TemporaryFolder folder;
  fs::create_directories(folder / "in/below");
  fs::create_symlink("..", folder / "in/up");
  CHECK(liesWithin(folder / "in/x", folder / "in"));
  CHECK(liesWithin(folder / "in/below/none/x", folder / "in"));
  CHECK(liesWithin(folder / "in/below/../x", folder / "in"));
  CHECK_FALSE(liesWithin(folder / "in/../x", folder / "in"));
  CHECK_FALSE(liesWithin(folder / "in/up/x", folder / "in"));
  CHECK_FALSE(liesWithin(folder / "inside", folder / "in"));
  fs::create_symlink("loop", folder / "loop");
  CHECK_THROWS_AS(fileExists(folder / "loop"), FileError);
  CHECK_THROWS_AS(fileExists(folder / std::string(300, 'n')), FileError);
  CHECK_FALSE(fileExists(folder / "none/none"));
  CHECK_THROWS_AS(namesIn(folder / "none"), FileError);
  CHECK_THROWS_AS(requireAbsent(folder / "in"), FileError);
}
