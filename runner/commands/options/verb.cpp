#include "options/verb.h"

#include <CLI/CLI.hpp>
#include <utility>

namespace morula::cli {

namespace {

/// An empty word is a slip in a script (an unset variable), never an answer: it must not pass for an option
/// that was not given.
std::string whatIsWrong(const std::string& word) { return word.empty() ? "is empty; needs a value" : ""; }

}  // namespace

CLI::App& addGroup(CLI::App& program, const std::string& name, const std::string& purpose) {
  auto* group = program.add_subcommand(name, purpose);
  group->require_subcommand(0, 1);
  return *group;
}

Verb::Verb(CLI::App& program, Action& chosen, const std::string& name, const std::string& purpose)
    : verb_(program.add_subcommand(name, purpose)), chosen_(&chosen) {}

void Verb::needs(const std::string& name, std::string& word, const std::string& type,
                 const std::string& help) {
  verb_->add_option(name, word, help)->required()->type_name(type)->check(whatIsWrong);
}

void Verb::needs(const std::string& name, std::vector<std::string>& words, const std::string& type,
                 const std::string& help) {
  verb_->add_option(name, words, help)->required()->type_name(type)->check(whatIsWrong);
}

void Verb::takes(const std::string& name, std::string& word, const std::string& type,
                 const std::string& help) {
  auto* option = verb_->add_option(name, word, help)->type_name(type)->check(whatIsWrong);
  if (!word.empty()) option->capture_default_str();
}

void Verb::takes(const std::string& name, std::vector<std::string>& words, const std::string& type,
                 const std::string& help) {
  auto* option = verb_->add_option(name, words, help)->type_name(type)->check(whatIsWrong);
  if (type.ends_with(",...")) option->delimiter(',');
  else if (name.starts_with("-")) option->allow_extra_args(false);  // or --set a=1 FILE would swallow FILE
}

void Verb::takes(const std::string& name, bool& given, const std::string& help) {
  verb_->add_flag(name, given, help);
}

void Verb::showDefault(const std::string& name, const std::string& text) {
  verb_->get_option(name)->default_str(text);
}

void Verb::hide() { verb_->group(""); }

void Verb::does(Action action) {
  verb_->callback([chosen = chosen_, action = std::move(action)] { *chosen = action; });
}

}  // namespace morula::cli
