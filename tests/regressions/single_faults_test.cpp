// Letting every operation fail, one after the other (tests/faults), found these faults. Drafts of killed runs stayed
// forever. A folder that could not be opened after it was made stayed and was made again and again. Half of an export
// into the current folder could be left. Running out of memory in a library's destructor or at the program's start
// ended in SIGABRT, in a database or a PNG with another exit code.
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "catch.h"
#include "hostile.h"

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // sanitizers' libraries must be loaded first

using namespace morula::test;
namespace fs = std::filesystem;

namespace {

struct Place {
  TemporaryFolder folder;
  Place() {
    fs::create_directory(folder / "in");
    writeWhole(folder / "in/small.yaml", smallScene);
  }
  Launched run(const std::string& fault) const {
    return with(fault, {"run", "--quiet", folder / "in/small.yaml", "--out", folder / "in"});
  }
  /// Runs with a fault; then counted() returns the number of operations of the fault's kind.
  Launched with(const std::string& fault, const Words& words) const {
    writeWhole(folder / "count", std::string(8, '\0'));
    return launch(words, {{"LD_PRELOAD", MORULA_FAILING},
                          {"FAULT", fault},
                          {"FAULT_FOLDER", folder / "in"},
                          {"FAULT_COUNT", folder / "count"}});
  }
  int counted() const {
    int n = 0;
    const std::string bytes = readWhole(folder / "count");
    for (int i = 3; i >= 0; --i) n = n << 8 | static_cast<unsigned char>(bytes.at(i));
    return n;
  }
  std::size_t drafts() const {
    std::size_t n = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder / "in"))
      n += entry.path().filename().string().starts_with(".morula-");
    return n;
  }
};

/// Returns true for a failure of cairo or the C library without memory, which the program cannot prevent.
bool isOfALibrary(const std::string& said) {
  return said.find("longjmp causes uninitialized stack frame") != said.npos;
}

}  // namespace

TEST_CASE("the draft of a killed run is removed by the next one") {
  const Place p;
  CHECK(p.run("rename:1:kill").code == 128 + 9);
  CHECK(p.drafts() == 1);
  CHECK(p.run("write:0:EIO").code == 0);
  CHECK(p.drafts() == 0);
}

TEST_CASE("an export whose folder cannot be opened or put in its place leaves nothing") {
  const Place p;
  REQUIRE(p.run("write:0:EIO").code == 0);
  std::string database;
  for (const auto& entry : fs::recursive_directory_iterator(p.folder / "in"))
    if (entry.path().extension() == ".db") database = entry.path();
  const Words csv{"export", database, "--format", "csv", "-o", p.folder / "in/out"};
  REQUIRE(p.with("read:0:EIO", csv).code == 0);
  const int reads = p.counted();
  fs::remove_all(p.folder / "in/out");
  int refused = 0;
  for (int n = 1; n <= reads; ++n) {
    const auto ended = p.with("read:" + std::to_string(n) + ":EIO", csv);
    CAPTURE(n, ended.err);
    CHECK((ended.code == 0 || ended.code == 6));
    CHECK(fs::exists(p.folder / "in/out") == (ended.code == 0));
    CHECK(p.drafts() == 0);
    refused += ended.code == 6;
    fs::remove_all(p.folder / "in/out");
  }
  CHECK(refused > 1);
  // Exports into the current folder, file by file.
  fs::create_directory(p.folder / "in/here");
  writeWhole(p.folder / "count", std::string(8, 0));
  const std::string line = "cd '" + p.folder / "in/here' && FAULT=rename:15:EIO FAULT_FOLDER='" + p.folder / "in" +
                           "' FAULT_COUNT='" + p.folder / "count' LD_PRELOAD='" MORULA_FAILING "' '" + programFile() +
                           "' export '" + database + "' --format csv -o . >/dev/null 2>&1";
  CHECK(std::system(line.c_str()) != 0);
  CHECK(fs::is_empty(p.folder / "in/here"));
}

TEST_CASE("memory that ends anywhere ends in the exit code of memory, with a sentence") {
  const Place p;
  for (const std::string kind : {"new", "malloc"}) {
    REQUIRE(p.run(kind + ":0:EIO").code == 0);
    const int all = p.counted();
    const auto fails = [&](int n) {
      const auto ended = p.run(kind + ":" + std::to_string(n) + ":EIO");
      CAPTURE(kind, n, all, ended.err);
      if (isOfALibrary(ended.err)) return;
      CHECK((ended.code == 0 || ended.code == 4 || (ended.code == 6 && kind == "malloc")));
      if (ended.code != 0) CHECK_THAT(ended.err, ContainsSubstring("memory"));
    };
    for (int n = 1; n <= 5; ++n) fails(n);
    for (int n = 6; n <= all; n += std::max(1, all / 60)) fails(n);
    for (int n = all - 20; n <= all; ++n) fails(n);  // writing the picture
  }
}

#endif
