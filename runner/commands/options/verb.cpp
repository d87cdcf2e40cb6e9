#include "options/verb.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <set>
#include <utility>

#include "base/error.h"
#include "files/text.h"
#include "system/usage_error.h"

namespace morula::cli {
namespace {

/// Rejects an empty word: it is a slip in a script (an unset variable), and must not pass for an option that was not
/// given.
std::string refuseEmpty(const std::string& word) { return word.empty() ? "is empty; needs a value" : ""; }

/// Returns true if an option was given; for "--style lineage", if it was given this value.
bool isGiven(const CLI::App& verb, const std::string& option) {
  const auto blank = option.find(' ');
  const auto& words = verb.get_option(option.substr(0, blank))->results();
  return blank == option.npos ? !words.empty() : !words.empty() && words.back() == option.substr(blank + 1);
}

/// Passes each given value of the option to `take`.
void takeAll(const CLI::Option& option, const std::function<void(const std::string&)>& take) {
  for (const std::string& text : option.results()) try {
      take(text);
    } catch (const InputError& error) {  // a mistake on the command line, not in a file
      throw UsageError(option.get_name() + ": " + error.what());
    }
}

/// Returns the choices of all options of the command line, which CLI11 does not keep.
std::map<const CLI::Option*, std::vector<std::string>>& choicesOfOptions() {
  static std::map<const CLI::Option*, std::vector<std::string>> all;
  return all;
}

/// Returns the verbs that stand for others, which CLI11 does not know.
std::set<const CLI::App*>& aliases() {
  static std::set<const CLI::App*> all;
  return all;
}

CLI::Option* declare(CLI::App& verb, const std::string& name, const std::string& type, const std::string& help) {
  return verb.add_option(name, help)->type_name(type)->check(refuseEmpty);
}

}  // namespace

const std::vector<std::string>& choicesOf(const CLI::Option& option) { return choicesOfOptions()[&option]; }

void Verb::setChoices(const std::string& name, const std::vector<std::string>& names) {
  if (!names.empty()) choicesOfOptions()[verb_->get_option(name.substr(0, name.find(',')))] = names;
}

struct Verb::Checks {
  std::vector<std::function<void()>> ofOptions, ofValues;  // on options given together; on given values
};

CLI::App& addGroup(CLI::App& program, const std::string& name, const std::string& purpose) {
  auto* group = program.add_subcommand(name, purpose);
  group->require_subcommand(0, 1);
  return *group;
}

void addInternalVerbs(CLI::App& program, Action& chosen, const std::vector<AddVerb*>& verbs) {
  auto& group = addGroup(program, "internal", "What programs ask Morula for");
  for (AddVerb* add : verbs) add(group, chosen);
  group.group("");  // hides the group; set last, since verbs below inherit it
}

void addAlias(CLI::App& group, const std::string& verb) {
  aliases().insert(group.add_subcommand(verb, "The same as morula " + verb));
}

bool isAlias(const CLI::App& verb) { return aliases().contains(&verb); }

Verb::Verb(CLI::App& above, Action& chosen, const std::string& name, const std::string& purpose)
    : verb_(above.add_subcommand(name, purpose)), chosen_(&chosen), checks_(std::make_shared<Checks>()) {}

void Verb::does(Action action) {
  verb_->callback([chosen = chosen_, checks = checks_, action = std::move(action)] {
    *chosen = [checks, action] {
      for (const auto& list : {checks->ofOptions, checks->ofValues})
        for (const auto& check : list) check();
      return action();
    };
  });
}

void Verb::add(const std::string& name, const std::string& type, const std::string& help, const std::string& shown,
               Take take) {
  auto* option = declare(*verb_, name, type, help);
  if (!shown.empty()) option->default_str(shown);
  checks_->ofValues.push_back([option, take = std::move(take)] { takeAll(*option, take); });
}

void Verb::addList(const std::string& name, const std::string& type, const std::string& help, Take take) {
  auto* option = declare(*verb_, name, type, help)->expected(CLI::detail::expected_max_vector_size);
  if (type.ends_with(",...")) option->delimiter(',');
  else if (name.starts_with("-")) option->allow_extra_args(false);  // else --set a=1 FILE would swallow FILE
  checks_->ofValues.push_back([option, take = std::move(take)] { takeAll(*option, take); });
}

void Verb::require(const std::string& name) { verb_->get_option(name)->required(); }
void Verb::takes(const std::string& name, bool& given, const std::string& help) { verb_->add_flag(name, given, help); }
void Verb::showDefault(const std::string& name, const std::string& text) { verb_->get_option(name)->default_str(text); }

void Verb::oneOf(const std::vector<std::string>& names) {
  for (std::size_t i = 0; i + 1 < names.size(); ++i)
    excludes(names[i], {names.begin() + static_cast<std::ptrdiff_t>(i) + 1, names.end()});
}

void Verb::excludes(const std::string& name, const std::vector<std::string>& others, const std::string& why) {
  checks_->ofOptions.push_back([=, verb = verb_] {
    for (const auto& other : others)
      if (isGiven(*verb, name) && isGiven(*verb, other))
        throw UsageError(name + " and " + other + ": give only one of them" + (why.empty() ? "" : "; " + why));
  });
}

void Verb::allowsOnly(const std::string& name, const std::vector<std::string>& others, const std::string& why) {
  checks_->ofOptions.push_back([=, verb = verb_] {
    if (!isGiven(*verb, name)) return;
    for (const auto* option : verb->get_options()) {
      const std::string other = option->get_name();
      if (option->nonpositional() && !option->empty() && other != name &&
          std::ranges::find(others, other) == others.end())
        throw UsageError(name + " and " + other + ": give only one of them; " + why);
    }
  });
}

void Verb::onlyWith(const std::vector<std::string>& names, const std::vector<std::string>& owners) {
  checks_->ofOptions.push_back([=, verb = verb_] {
    for (const auto& owner : owners)
      if (isGiven(*verb, owner)) return;
    for (const auto& name : names)
      if (isGiven(*verb, name)) throw UsageError(name + ": only with " + join(owners, " or ") + "; give it, too");
  });
}

}  // namespace morula::cli
