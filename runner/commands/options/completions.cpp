// Completions for bash, zsh and fish, from the command line's declarations.
#include <fmt/format.h>

#include <functional>

#include "files/text.h"
#include "options/command_tree.h"

namespace morula::cli {
namespace {

using Visit = std::function<void(const CommandInfo& command, const std::string& words)>;

/// Visits each command that has an action, with its words: "run", "study plan".
void eachCommand(const CommandInfo& of, const Visit& visit, const std::string& before = "") {
  for (const CommandInfo& command : of.commands)
    if (command.commands.empty()) visit(command, before + command.name);
    else eachCommand(command, visit, before + command.name + " ");
}

std::vector<const CommandInfo*> groupsOf(const CommandInfo& program) {
  std::vector<const CommandInfo*> groups;
  for (const CommandInfo& command : program.commands)
    if (!command.commands.empty()) groups.push_back(&command);
  return groups;
}

std::string listOf(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); }

std::string listOf(const std::vector<CommandInfo>& commands) {
  std::vector<std::string> names;
  for (const CommandInfo& command : commands) names.push_back(command.name);
  return listOf(names);
}

bool takesFolder(const OptionInfo& option) { return option.type == "FOLDER"; }
bool takesFile(const OptionInfo& option) {
  return option.type.starts_with("FILE") || option.type == "WHAT" || option.type == "PATH" ||
         option.type == "SCENARIO" || option.type == "PROGRAM";
}

std::string escaped(const std::string& text, const std::string& characters) {
  std::string safe;
  for (const char c : text) safe += (characters.find(c) == characters.npos ? "" : "\\") + std::string(1, c);
  return safe;
}

}  // namespace

std::string bashCompletion(const CommandInfo& program) {
  std::string verbs = "    '') words=" + shellWord(listOf(program.commands)) + " options='--help --version' ;;\n",
              groups, values;
  for (const CommandInfo* group : groupsOf(program)) {
    groups += "    " + group->name + ") if [ \"$COMP_CWORD\" -gt 2 ]; then verb=\"$verb ${COMP_WORDS[2]}\"; fi ;;\n";
    verbs += "    " + group->name + ") words=" + shellWord(listOf(group->commands)) + " options=--help ;;\n";
  }
  eachCommand(program, [&](const CommandInfo& command, const std::string& name) {
    std::string options, words;
    for (const OptionInfo& option : command.options) {
      if (option.isPositional) words += listOf(option.choices);
      else options += (options.empty() ? "" : " ") + listOf(option.names);
      if (option.isPositional || option.type.empty()) continue;
      const std::string kind = !option.choices.empty() ? "words=" + shellWord(listOf(option.choices))
                               : takesFolder(option)   ? "files=-d"
                               : takesFile(option)     ? "files=-f"
                                                       : "words=''";
      for (const std::string& of : option.names)
        values += "    " + shellWord(name + " " + of) + ") options='' words='' files=''; " + kind + " ;;\n";
    }
    verbs += "    " + shellWord(name) + ") options=" + shellWord(options) +
             (words.empty() ? " files=-f" : " words=" + shellWord(words)) + " ;;\n";
  });
  return "# bash completion for morula; written by the program itself\n"
         "_morula() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} verb=${COMP_WORDS[1]} "
         "options='' words='' files=''\n"
         "  if [ \"$COMP_CWORD\" = 1 ]; then verb=; fi\n"
         "  case $verb in\n" +
         groups + "  esac\n  case $verb in\n" + verbs + "  esac\n  case \"$verb $before\" in\n" + values +
         "  esac\n"
         "  case $word in -*) words=$options files='' ;; esac\n"
         "  mapfile -t COMPREPLY < <(compgen -W \"$words\" ${files:+\"$files\"} -- \"$word\")\n"
         "  if [ -n \"$files\" ]; then compopt -o filenames 2>/dev/null; fi\n"
         "}\n"
         "complete -F _morula morula\n";
}

std::string zshCompletion(const CommandInfo& program) {
  const auto described = [](const std::vector<CommandInfo>& commands) {
    std::string list;
    for (const CommandInfo& command : commands)
      list += " " + shellWord(escaped(command.name, ":") + ":" + command.purpose);
    return list;
  };
  const auto actionOf = [](const OptionInfo& option) -> std::string {
    if (!option.choices.empty()) return "(" + listOf(option.choices) + ")";
    return takesFolder(option) ? "_files -/" : takesFile(option) ? "_files" : " ";
  };
  const auto argument = [&](const OptionInfo& option) {
    const std::string type = escaped(option.type, ":"),
                      value = option.type.empty() ? "" : ":" + type + ":" + actionOf(option);
    std::string list;
    if (option.isPositional) return " " + shellWord("*" + value);
    for (const std::string& name : option.names)
      list += " " + shellWord((option.type.ends_with("...") || option.names.back() == "--set" ? "*" : "") + name + "[" +
                              escaped(option.help, "[]:\\") + "]" + value);
    return list;
  };
  std::string cases, groups;
  const auto caseOf = [&](const CommandInfo& command) {
    std::string text = command.name + ") _arguments";
    for (const OptionInfo& option : command.options) text += argument(option);
    return text + " ;;\n";
  };
  for (const CommandInfo& command : program.commands) {
    if (command.commands.empty()) {
      cases += "    " + caseOf(command);
      continue;
    }
    cases += "    " + command.name + ") _morula_" + command.name + " ;;\n";
    groups += "_morula_" + command.name + "() {\n  local state line\n  local -a verbs=(" + described(command.commands) +
              ")\n  _arguments -C '1:verb:->verb' '*::word:->rest'\n  case $state in\n    verb) _describe "
              "verb verbs ;;\n    rest) case $words[1] in\n";
    for (const CommandInfo& inner : command.commands) groups += "      " + caseOf(inner);
    groups += "    esac ;;\n  esac\n}\n";
  }
  return "#compdef morula\n# zsh completion for morula; written by the program itself\n" + groups +
         "_morula() {\n  local state line\n  local -a verbs=(" + described(program.commands) +
         ")\n  _arguments -C '--help[Help]' '--version[Version]' '1:verb:->verb' '*::word:->rest'\n  case $state in\n"
         "    verb) _describe verb verbs ;;\n    rest) case $words[1] in\n" +
         cases + "    esac ;;\n  esac\n}\n_morula \"$@\"\n";
}

std::string fishCompletion(const CommandInfo& program) {
  const auto quotedForFish = [](const std::string& text) { return "'" + escaped(text, "\\'") + "'"; };
  std::string text =
      "# fish completion for morula; written by the program itself\n"
      "function __morula_at\n"
      "  set -l words (commandline -opc)\n"
      "  set -l last (math 1 + (count $argv))\n"
      "  test (count $words) -ge $last; and test \"$words[2..$last]\" = \"$argv\"\n"
      "end\n"
      "function __morula_needs\n"
      "  test (count (commandline -opc)) -eq (math 1 + (count $argv)); and begin; not set -q argv[1]; or "
      "__morula_at $argv; end\n"
      "end\n";
  const auto offer = [&](const std::vector<CommandInfo>& commands, const std::string& after) {
    for (const CommandInfo& command : commands)
      text += "complete -c morula -n '__morula_needs" + after + "' -f -a " + command.name + " -d " +
              quotedForFish(command.purpose) + "\n";
  };
  offer(program.commands, "");
  for (const CommandInfo* group : groupsOf(program)) offer(group->commands, " " + group->name);
  eachCommand(program, [&](const CommandInfo& command, const std::string& words) {
    const std::string begin = "complete -c morula -n '__morula_at " + words + "'";
    for (const OptionInfo& option : command.options) {
      if (option.isPositional) {
        if (!option.choices.empty()) text += begin + " -f -a " + quotedForFish(listOf(option.choices)) + "\n";
        continue;
      }
      text += begin;
      for (const std::string& name : option.names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (!option.choices.empty()) text += " -x -a " + quotedForFish(listOf(option.choices));
      else if (takesFolder(option)) text += " -x -a '(__fish_complete_directories)'";
      else if (!option.type.empty()) text += takesFile(option) ? " -r -F" : " -x";
      text += " -d " + quotedForFish(option.help) + "\n";
    }
  });
  return text;
}

}  // namespace morula::cli
