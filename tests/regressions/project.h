#pragma once
// A project in its own folder, in which tests call `morula` as users do.
#include <cstdlib>
#include <filesystem>

#include "launch.h"

namespace morula::test {

struct Project {
  TemporaryFolder folder;
  Project() { std::filesystem::create_directory(folder / "scenarios"); }

  /// Runs a shell command in the folder `in` of the project, with the program as $M.
  Launched shell(const std::string& command, const std::string& in = ".") const {
    const std::string out = folder / "said.out", err = folder / "said.err";
    const int status = std::system(("cd '" + folder / in + "' && unset CI GITHUB_ACTIONS && M='" + programFile() +
                                    "' && (" + command + ") >'" + out + "' 2>'" + err + "' </dev/null")
                                       .c_str());
    return {WEXITSTATUS(status), readWhole(out), readWhole(err)};
  }
  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(std::filesystem::path(folder / name).parent_path());
    writeWhole(folder / name, text);
  }
  bool has(const std::string& name) const { return std::filesystem::exists(folder / name); }
};

/// A scenario of a lineage of so many cycles.
inline std::string treeOf(int cycles, const std::string& more = "") {
  return "morula: 1\nname: tree\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\nstop: {cycles: " +
         std::to_string(cycles) + "}\n" + more;
}

inline const std::string acceptAll =
    "for f in $(find -L scenarios -name '*.y*ml' | sort); do "
    "$M review $f --accept --by me --why first --quiet || exit 9; done";

}  // namespace morula::test
