#pragma once
// The command line as it was declared: verbs, and what each takes. Completions of shells and the manual are made of it,
// so that they never say anything else than the program does.
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace morula::cli {

struct OptionInfo {
  std::vector<std::string> names;    // "-o", "--output"; of a positional word its one name
  std::string type;                  // "FILE", "N,..."; "": given or not
  std::string help, shown;           // shown: the default, "" without
  std::vector<std::string> choices;  // all that may be given, where that is a list
  bool isPositional = false, isRequired = false;
};

struct CommandInfo {
  std::string name, purpose;
  std::vector<OptionInfo> options;    // in the order of the help
  std::vector<CommandInfo> commands;  // of a group; those for people
};

/// The whole program, for people.
CommandInfo commandTree(const CLI::App& app);

std::string bashCompletion(const CommandInfo& program);
std::string zshCompletion(const CommandInfo& program);
std::string fishCompletion(const CommandInfo& program);
/// A page for man(1).
std::string manualPage(const CommandInfo& program, const std::string& version);

}  // namespace morula::cli
