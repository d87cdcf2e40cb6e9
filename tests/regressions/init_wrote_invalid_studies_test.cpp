// `init --study` and `--base` wrote their texts unquoted into YAML: they could inject keys, and Morula refused some of
// the written files. Now a written file is valid and holds these texts.
#include <filesystem>

#include "catch.h"
#include "launch.h"

using namespace morula::test;

TEST_CASE("a study that init writes is valid, or is not written") {
  const TemporaryFolder folder;
  for (const std::string name : {"../x", "a\nb: c", "a: b", "", "x #y", "[a]"}) {
    CAPTURE(name);
    const auto run = launch({"init", "--study", name, folder / "s.study.yaml"});
    CHECK((run.code == 2 || run.code == 3));
    CHECK_FALSE(std::filesystem::exists(folder / "s.study.yaml"));
  }
  for (const std::string base :
       {"a: b\n- c.yaml", "it's, [here].yaml", "\"quoted\" #1.yaml", "- x.yaml", "42.yaml", "no"}) {
    CAPTURE(base);
    succeeds({"init", folder / "organism.yaml", "--force"});
    if (base.find('\n') == base.npos)
      std::filesystem::copy_file(folder / "organism.yaml", folder / base,
                                 std::filesystem::copy_options::overwrite_existing);
    const auto run = launch({"init", "--study", "s", "--base", base, folder / "s.study.yaml", "--force"});
    if (run.code == 0) succeeds({"validate", folder / "s.study.yaml"});  // a name with a line end may be refused
  }
}
