#pragma once
// The command line as it was declared: verbs with their options. Completions of shells and the manual are made from it,
// and so agree with the program.
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace morula::cli {

struct OptionInfo {
  std::vector<std::string> names;    // "-o", "--output"; for a positional word its one name
  std::string type;                  // "FILE", "N,..."; "": a flag
  std::string help, shown;           // shown: the default, or ""
  std::vector<std::string> choices;  // all allowed values, if they are a list
  bool isPositional = false, isRequired = false;
};

struct CommandInfo {
  std::string name, purpose;
  std::vector<OptionInfo> options;    // in the order of the help
  std::vector<CommandInfo> commands;  // verbs below this one that are not hidden
  bool isAlias = false;               // true: the same as the program's verb of this name
};

/// Returns all verbs that are not hidden, of the program that `verb` belongs to.
CommandInfo commandTree(const CLI::App& verb);

std::string bashCompletion(const CommandInfo& program);
std::string zshCompletion(const CommandInfo& program);
std::string fishCompletion(const CommandInfo& program);
/// Returns a page for man(1).
std::string manualPage(const CommandInfo& program, const std::string& version);

}  // namespace morula::cli
