// The name of a study's folder was unquoted in the script for Slurm: a line end in it began another command, and a
// blank, a quote or a '%' led elsewhere. Now the script names this folder and runs nothing else.
#include <filesystem>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
namespace fs = std::filesystem;

namespace {

/// A folder with a study and its scenario.
struct FolderWithStudy : TemporaryFolder {
  FolderWithStudy() {
    succeeds({"init", *this / "my-organism.yaml"});
    succeeds({"init", "--study", "s", *this / "s.study.yaml"});
  }
};

/// Runs a script in the folder; there `morula` and `parallel` only write their arguments into a file, one a line.
int run(const TemporaryFolder& folder, const std::string& shell, const std::string& script) {
  writeWhole(folder / "tool", "#!/bin/sh\nprintf '%s\\n' \"$@\" >>\"$TOLD\"\n");
  fs::permissions(folder / "tool", fs::perms::owner_all);
  return std::system(("cd '" + folder.path() + "' && TOLD='" + folder / "told" +
                      "' SLURM_ARRAY_TASK_ID=1 MORULA=./tool " + shell + " " + script)
                         .c_str());
}

}  // namespace

TEST_CASE("an emitted script names the study's folder and runs nothing else, whatever the folder is called") {
  const FolderWithStudy folder;
  for (const std::string name : {"a b", "$(touch PWNED)", "it's", "`touch PWNED`", "50%", "x;touch PWNED", "\"q"}) {
    CAPTURE(name);
    succeeds({"study", "emit", "slurm", folder / "s.study.yaml", "--out", folder / name, "-o", folder / "script",
              "--force", "--jobs", "2"});
    const std::string script = readWhole(folder / "script");
    CHECK(script.find("\n#SBATCH --output=") != std::string::npos);
    if (name == "50%") CHECK(script.find("50%%/slurm-%A_%a.log") != std::string::npos);
    fs::remove(folder / "told");
    CHECK(run(folder, "bash", "script") == 0);
    CHECK(readWhole(folder / "told").find(folder / name + "\n") != std::string::npos);
    if (std::system("shellcheck --version >/dev/null 2>&1") == 0)
      CHECK(std::system(("shellcheck -e SC2016 '" + folder / "script'").c_str()) == 0);
    else WARN("skipped: no shellcheck here");
  }
  for (const auto& entry : fs::directory_iterator(folder.path())) CHECK(entry.path().filename() != "PWNED");
}

TEST_CASE("no script is emitted for a folder whose name would be lines of it") {
  const FolderWithStudy folder;
  for (const std::string site : {"slurm", "snakemake", "parallel"}) {
    refuses({"study", "emit", site, folder / "s.study.yaml", "--out", folder / "x\ny; touch PWNED #", "-o",
             folder / "script"},
            3, "has a line end or another control character in its name");
    CHECK_FALSE(fs::exists(folder / "script"));
  }
}

TEST_CASE("no script is emitted for a folder with braces, where Snakemake and GNU parallel put in words of their own") {
  const FolderWithStudy folder;
  for (const std::string site : {"slurm", "snakemake", "parallel"}) {
    const auto emitted =
        launch({"study", "emit", site, folder / "s.study.yaml", "--out", folder / "a{1}", "-o", folder / site});
    CHECK(emitted.code == (site == "slurm" ? 0 : 3));
    CHECK((emitted.err.find("has a brace in its name") == std::string::npos) == (site == "slurm"));
    CHECK(fs::exists(folder / site) == (site == "slurm"));
  }
}
