// The manual for man(1), from the command line's declarations.
#include "options/command_tree.h"

namespace morula::cli {
namespace {

/// Escapes a text for roff, so that no character of it is a request.
std::string roffText(const std::string& text) {
  std::string roff = !text.empty() && (text[0] == '.' || text[0] == '\'') ? "\\&" : "";
  for (const char c : text) roff += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  return roff;
}

std::string optionEntry(const OptionInfo& option) {
  std::string names;
  for (const std::string& name : option.names) names += (names.empty() ? "\\fB" : ", \\fB") + roffText(name) + "\\fR";
  std::string text = ".TP\n" + names + (option.type.empty() ? "" : " \\fI" + roffText(option.type) + "\\fR") + "\n" +
                     roffText(option.help);
  if (!option.shown.empty()) text += " [" + roffText(option.shown) + "]";
  return text + "\n";
}

/// Returns "morula study plan [OPTION]... STUDY".
std::string synopsis(const CommandInfo& command, const std::string& words) {
  std::string text = "\\fBmorula " + roffText(words) + "\\fR";
  bool takesOptions = false;
  for (const OptionInfo& option : command.options) takesOptions |= !option.isPositional;
  if (takesOptions) text += " [\\fIOPTION\\fR]...";
  for (const OptionInfo& option : command.options)
    if (option.isPositional) text += " \\fI" + roffText(option.names[0]) + "\\fR";
  return text;
}

void addCommand(const CommandInfo& command, const std::string& words, std::string& text) {
  if (!command.commands.empty()) {
    for (const CommandInfo& inner : command.commands) addCommand(inner, words + " " + inner.name, text);
    return;
  }
  text += ".SS " + synopsis(command, words) + "\n" + roffText(command.purpose) + ".\n";
  if (command.isAlias) return;
  for (const OptionInfo& option : command.options)
    if (option.names.back() != "--help") text += optionEntry(option);
}

}  // namespace

std::string manualPage(const CommandInfo& program, const std::string& version) {
  std::string text =
      ".\\\" Written by the program itself.\n.TH MORULA 1 \"\" \"Morula " + roffText(version) +
      "\" \"User Commands\"\n.SH NAME\nmorula \\- simulate dividing cells, the same bits every time\n.SH SYNOPSIS\n"
      "\\fBmorula\\fR \\fIVERB\\fR [\\fIOPTION\\fR]... [\\fIFILE\\fR]...\n.SH DESCRIPTION\n" +
      roffText(program.purpose) +
      "\n"
      ".PP\n"
      "A scenario is one experiment in a YAML file. Genes decide what each cell does, and a simulation of soft "
      "bodies decides where it lies. Every run is stored with its provenance and compared with an accepted result.\n"
      ".PP\n"
      "A project is a folder with \\fIscenarios/\\fR and \\fIgolden/\\fR, which holds the accepted results. Start "
      "the program there; results go into \\fIresults/\\fR, and results that wait for a review into "
      "\\fIgolden/.pending/\\fR.\n"
      ".SH VERBS\n";
  for (const CommandInfo& command : program.commands) addCommand(command, command.name, text);
  return text +
         ".SH EXIT STATUS\n0 fine, 1 a check differs, 2 usage, 3 input invalid, 4 numerical failure, 5 study "
         "incomplete, 6 file or database, 70 bug, 130 and 143 interrupted.\n"
         ".SH ENVIRONMENT\n.TP\n\\fBNO_COLOR\\fR\nNo colours on a terminal.\n"
         ".SH FILES\n.TP\n\\fIshare/morula/scenarios\\fR\nScenarios and studies that come with the program, and how to "
         "write one (\\fIREADME.md\\fR).\n.TP\n\\fIshare/morula/golden\\fR\nTheir accepted results.\n"
         ".SH EXAMPLES\n.EX\nmorula init one.yaml\nmorula run one.yaml\nmorula report results/one\\-1\n.EE\n";
}

}  // namespace morula::cli
