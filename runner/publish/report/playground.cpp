#include "report/playground.h"

#include "base/error.h"
#include "document/document.h"
#include "drawing/palette.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "page/page.h"
#include "report_data/explorer_data.h"
#include "scenario/scenario.h"
#include "scenario/schema.h"
#include "study/study_file.h"
#include "system/installation.h"
#include "system/json.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

std::string builtPart(const std::string& name) {
  if (const auto file = sharedFile(name)) return readFile(*file);
  throw FileError("playground: " + name + " is not there; " +
                  (installation() ? "the installation does not have it" : "`./morula wasm` in the sources builds it"));
}

/// Returns {name, summary, text, files: [[role, path, content]…]} for each readable scenario.
Json scenariosBelow(const fs::path& folder) {
  Json all = Json::array();
  for (const fs::path& file : filesBelow(folder, ".yaml")) {
    if (isStudy(file)) continue;
    try {
      const Scenario scenario = loadScenario(file);
      Json files = Json::array();
      for (const NamedFile& named : scenario.files) files.push_back({named.role, named.path, named.content});
      all.push_back({{"name", file.lexically_relative(folder).replace_extension().generic_string()},
                     {"summary", scenario.summary},
                     {"text", scenario.bytes},
                     {"files", files}});
    } catch (const InputError&) {}
  }
  if (all.empty()) throw FileError(folder.string() + ": there is no scenario to begin with");
  return all;
}

PageBlock blockOf(const std::string& id, const std::string& title, Document body) { return {id, title, htmlOf(body)}; }

}  // namespace

std::string playgroundPage(const fs::path& scenarios) {
  Json data{{"scenarios", scenariosBelow(scenarios)}, {"schema", parseJson(scenarioSchema())}};
  addPalette(data);
  const std::string without = "This page works in a browser whose JavaScript is switched on.";
  Page page{.title = "Morula playground",
            .summary = "From one cell to an organism, the same bits every time: in this browser, without network",
            .verdict = htmlOf(Document().say("Write a scenario, or begin with one; its mistakes are shown as you type. "
                                             "Run it, and look at its organism while it grows. The state hash is "
                                             "the one that the program gives, bit for bit.")),
            .blocks = {blockOf("playground", "Scenario", Document().add(ProgramPlace{"write", without})),
                       blockOf("explorer", "Organism", Document().add(ProgramPlace{"grow", ""}))},
            .data = jsonText(data),
            .bytes = {{"playground-module", builtPart("wasm/playground.wasm.gz")}},
            .command = programWord() + " playground -o playground.html",
            .program = builtPart("explorer/playground.js"),
            .runsAgain = true};
  return pageFile(page);
}

}  // namespace morula
