// Verbs that show a scenario or a run were only tried on ordinary cells. This test tries render, lineage and explain on
// every kind of shipped scenario, cut short.
#include <filesystem>
#include <regex>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
namespace fs = std::filesystem;

namespace {

struct Kind {
  std::string file;
  std::string stop;   // replaces the scenario's stop
  std::string cycle;  // replaces the scenario's cycle; "" keeps it
};

const std::vector<Kind> kinds{{"thesis/elegans-1024", "{cycles: 3}", ""},  // a lineage only
                              {"thesis/unique-four", "{time: 0.03}", "{length: 0.01}"},
                              {"organisms/spheres", "{time: 0.03}", "{length: 0.01}"},
                              {"organisms/shape-matching", "{time: 0.03}", "{length: 0.01}"},
                              {"organisms/coarsening", "{time: 0.03}", "{length: 0.01}"},
                              {"hard/die-in-crowd", "{time: 0.03}", ""},  // several start cells
                              {"hard/thesis-law", "{time: 0.03}", ""},
                              {"hard/stiff-xpbd", "{time: 0.03}", ""},
                              {"hard/single-precision", "{time: 0.03}", ""},
                              {"hard/sliver-rod", "{time: 0.03}", ""}};  // a mesh from a file

/// Writes the shipped scenario, cut short, into the folder and returns its file.
std::string cutShort(const Kind& kind, const TemporaryFolder& folder) {
  const fs::path original = fs::absolute("scenarios/" + kind.file + ".yaml");
  std::string text = readWhole(original.string());
  text = std::regex_replace(text, std::regex("\nstop:[^\n]*"), "\nstop: " + kind.stop);
  if (!kind.cycle.empty()) text = std::regex_replace(text, std::regex("\ncycle:[^\n]*"), "\ncycle: " + kind.cycle);
  const std::regex named("file: ([^ },\n]+)");
  for (std::sregex_iterator at(text.begin(), text.end(), named), end; at != end; ++at)
    fs::copy_file(original.parent_path() / (*at)[1].str(), folder / fs::path((*at)[1].str()).filename().string());
  text = std::regex_replace(text, std::regex("file: [^ },\n]*/"), "file: ");
  text = std::regex_replace(text, std::regex("\ncheck:.*(\n +.*)*"), "");  // checks apply to the full run
  text += "\ncheck: {}\n";  // explain reads the hashes that only checked runs keep
  const std::string file = folder / "kind.yaml";
  writeWhole(file, text);
  return file;
}

void checkFine(const Words& words) {
  const auto run = succeeds(words, {{"CI", ""}});
  CAPTURE(words);
  CHECK_FALSE((run.out.empty() && run.err.empty()));
}

}  // namespace

TEST_CASE("render, lineage and explain do their work for every kind of scenario") {
  for (const Kind& kind : kinds) {
    CAPTURE(kind.file);
    const TemporaryFolder folder;
    const std::string file = cutShort(kind, folder), picture = folder / "kind.png";
    const bool bodies = readWhole(file).find("\nphysics:") != std::string::npos;
    checkFine({"lineage", file, "--json"});
    for (const std::string style : {"lineage", "solid"})
      if (bodies || style == "lineage") {
        checkFine({"render", file, "--style", style, "--size", "100", "-o", picture});
        CHECK(readWhole(picture).starts_with("\x89PNG"));
        fs::remove(picture);
      }
    const auto run = launch({"run", file, "--out", folder / "out", "--no-pictures"}, {{"CI", ""}});
    CAPTURE(run.err, run.out);
    CHECK((run.code == 0 || run.out.find("not sane at the end") != run.out.npos));  // cut short before it is at rest
    for (const auto& entry : fs::recursive_directory_iterator(folder / "out"))
      if (entry.path().extension() == ".db") {
        checkFine({"lineage", entry.path().string()});
        checkFine({"render", entry.path().string(), "--style", "lineage", "--size", "100", "-o", picture});
        checkFine({"explain", file, "--db", entry.path().string()});
      }
  }
}
