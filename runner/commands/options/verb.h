#pragma once
// A verb on the command line. Each option is declared once: name, type and range, default, help, and excluded options.
// The verb's function gets checked values. CLI11 stays in verb.cpp, since its header takes longer to compile than most
// verbs.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "base/choice.h"
#include "base/number_text.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace morula::cli {

/// Returns all allowed values of an option, if they are a list of names; else an empty list.
const std::vector<std::string>& choicesOf(const CLI::Option& option);

/// The action of a verb, called once the command line is understood. Returns the exit code.
using Action = std::function<int()>;

/// Adds a verb to the program or to the verb above, and sets `chosen` when the verb is chosen.
using AddVerb = void(CLI::App& above, Action& chosen);

/// Adds a verb that only groups others, as `study` in `morula study plan`, and returns it.
CLI::App& addGroup(CLI::App& program, const std::string& name, const std::string& purpose);

/// Adds the group `internal` of these verbs, which are for programs. Help does not list the group.
void addInternalVerbs(CLI::App& program, Action& chosen, const std::vector<AddVerb*>& verbs);

/// Adds to a group a verb that does the same as the program's verb of this name. Both have one declaration and one help
/// text.
void addAlias(CLI::App& group, const std::string& verb);
/// Returns true if `addAlias` has added the verb.
bool isAlias(const CLI::App& verb);

/// Reads a value from an option's text. Throws InputError without the option's name.
template <class T>
using Reader = std::function<T(const std::string& text)>;

class Verb {
 public:
  Verb(CLI::App& above, Action& chosen, const std::string& name, const std::string& purpose);

  /// Sets the action of the verb. Returns its options, which hold their defaults: declare each with `needs` or
  /// `takes`.
  template <class Options>
  Options& does(int (*act)(const Options&)) {
    auto options = std::make_shared<Options>();
    does([options, act] { return act(*options); });
    return *options;
  }
  void does(Action action);

  /// Declares a required option; parameters as for `takes`. An empty word is an error.
  template <class... Rest>
  void needs(const std::string& name, Rest&&... rest) {
    takes(name, std::forward<Rest>(rest)...);
    require(name);
  }

  /// Declares an option with one word or with any number of words. The present value of a single word is the default in
  /// the help. If the type ends in ",...", several words may be separated by commas or blanks.
  template <class Words>
  void takes(const std::string& name, Words& words, const std::string& type, const std::string& help) {
    takes(
        name, words, type, [](const std::string& text) { return text; }, help);
  }
  /// Declares a flag.
  void takes(const std::string& name, bool& given, const std::string& help);
  /// Declares an option with a value, a value that may be absent, or a list of values, one for each word.
  template <class T>
  void takes(const std::string& name, T& value, const std::string& type, std::type_identity_t<Reader<T>> read,
             const std::string& help) {
    add(name, type, help, textOf(value), [&value, read](const std::string& text) { value = read(text); });
    setChoices(name, namesOfChoices<T>());
  }
  template <class T>
  void takes(const std::string& name, std::optional<T>& value, const std::string& type,
             std::type_identity_t<Reader<T>> read, const std::string& help) {
    add(name, type, help, value ? textOf(*value) : "", [&value, read](const std::string& text) { value = read(text); });
    setChoices(name, namesOfChoices<T>());
  }
  template <class T>
  void takes(const std::string& name, std::vector<T>& values, const std::string& type,
             std::type_identity_t<Reader<T>> read, const std::string& help) {
    addList(name, type, help, [&values, read](const std::string& text) { values.push_back(read(text)); });
    setChoices(name, namesOfChoices<T>());
  }

  /// Sets the text that the help shows as the default, for an option whose default is not the present value.
  void showDefault(const std::string& name, const std::string& text);

  /// Allows at most one of these options.
  void oneOf(const std::vector<std::string>& names);
  /// Forbids `others` beside `name`, which may be an option and its value ("--style lineage"). The message ends with
  /// `why`, a clause that gives the reason.
  void excludes(const std::string& name, const std::vector<std::string>& others, const std::string& why = "");
  /// Forbids all options but `others` beside `name`. The message ends with `why`, as for `excludes`.
  void allowsOnly(const std::string& name, const std::vector<std::string>& others, const std::string& why);
  /// Requires one of `owners` beside each of `names`.
  void onlyWith(const std::vector<std::string>& names, const std::vector<std::string>& owners);

 private:
  using Take = std::function<void(const std::string& text)>;

  /// Writes a default for the help.
  template <class T>
  static std::string textOf(const T& value) {
    if constexpr (std::is_arithmetic_v<T>) return numberText(static_cast<double>(value), 12);
    else if constexpr (requires { choices<T>[0]; }) return nameOf(value);
    else if constexpr (std::is_convertible_v<T, std::string>) return value;
    else return "";
  }

  template <class T>
  static std::vector<std::string> namesOfChoices() {
    std::vector<std::string> names;
    if constexpr (requires { choices<T>.size(); })
      for (const auto& choice : choices<T>) names.push_back(choice.name);
    return names;
  }

  void setChoices(const std::string& name, const std::vector<std::string>& names);
  void add(const std::string& name, const std::string& type, const std::string& help, const std::string& shown,
           Take take);
  void addList(const std::string& name, const std::string& type, const std::string& help, Take take);
  void require(const std::string& name);

  CLI::App* verb_;
  Action* chosen_;
  struct Checks;                    // what is validated before the action
  std::shared_ptr<Checks> checks_;  // lives as long as the action
};

}  // namespace morula::cli
