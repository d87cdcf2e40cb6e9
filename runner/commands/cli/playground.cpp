// morula playground: one page to try scenarios in a browser, without this program or a network.
#include "report/playground.h"

#include "cli/verbs.h"
#include "files/folders.h"
#include "files/write_file.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "system/installation.h"

namespace morula::cli {
namespace {

struct PlaygroundOptions {
  std::string output = "playground.html", scenarios;
  OutputOptions messages;
};

int act(const PlaygroundOptions& options) {
  std::filesystem::path folder = options.scenarios;
  if (folder.empty()) folder = "scenarios";
  if (const auto installed = installation(); options.scenarios.empty() && installed && !isFolder(folder))
    folder = *installed / "scenarios";
  const std::string page = playgroundPage(folder);
  writeFile(options.output, page, Content::page);
  printEither(options.messages, {{"playground", options.output}, {"bytes", page.size()}}, options.output + "\n");
  return fine;
}

}  // namespace

void addPlayground(CLI::App& app, Action& action) {
  Verb verb(app, action, "playground",
            "Write a page on which scenarios are written, checked and run in a browser, without network");
  auto& options = verb.does<PlaygroundOptions>(act);
  verb.takes("-o,--output", options.output, "FILE", readPageName, "The page, a .html");
  verb.takes("--scenarios", options.scenarios, "FOLDER",
             "Scenarios that the page offers; default: the folder scenarios here, or else those of the installation");
  add(verb, options.messages);
}

}  // namespace morula::cli
