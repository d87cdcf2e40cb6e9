// `render -o x.mp4` and `-o x.obj` wrote PNGs under these names. Now other names are usage errors that say what can be
// written, before anything is computed or written; one picture can be SVG and PDF, too.
#include <filesystem>

#include "catch.h"
#include "launch.h"

using namespace morula::test;

TEST_CASE("render refuses a name that promises what it cannot write") {
  const TemporaryFolder folder;
  for (const std::string ending : {".mp4", ".obj", ".jpg", ".yaml", ".db"}) {
    // One picture is no film: the message names the options that make one.
    const std::string remedy = ending == ".mp4" ? "needs --turntable N or --frames N, or a name that ends in .png"
                                                : "needs a name that ends in .png";
    refuses({"render", uniqueFour, "--time", "0", "-o", folder / ("x" + ending)}, 2, remedy);
    CHECK(std::filesystem::is_empty(folder.path()));
  }
  for (const std::string name : {"x.png", "x.PNG"}) {
    succeeds({"render", uniqueFour, "--time", "0", "--size", "64", "--style", "lineage", "-o", folder / name});
    CHECK(readWhole(folder / name).starts_with("\x89PNG"));
  }
}
