#pragma once
// A verb's place on the command line: what it wants to be told. Verbs reach CLI11 through this
// header alone, since CLI11's own takes longer to compile than most verbs.
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace morula::cli {

/// What is to be done once the command line is understood. Returns the exit code.
using Action = std::function<int()>;

/// A verb that only groups others, as `study` in `morula study plan`. Add those to what is returned.
CLI::App& addGroup(CLI::App& program, const std::string& name, const std::string& purpose);

class Verb {
 public:
  Verb(CLI::App& program, Action& chosen, const std::string& name, const std::string& purpose);

  /// What must be given: a word, or one and more. No word may be empty.
  void needs(const std::string& name, std::string& word, const std::string& type, const std::string& help);
  void needs(const std::string& name, std::vector<std::string>& words, const std::string& type,
             const std::string& help);

  /// What may be given. What stands in `word` is the default, which the help shows.
  void takes(const std::string& name, std::string& word, const std::string& type, const std::string& help);
  /// As often as wanted; where the type ends in ",..." also several with commas or blanks between.
  void takes(const std::string& name, std::vector<std::string>& words, const std::string& type,
             const std::string& help);

  /// Given or not.
  void takes(const std::string& name, bool& given, const std::string& help);

  /// What the help shows as an option's default where that is no value which could be given: "as then".
  void showDefault(const std::string& name, const std::string& text);

  /// Not among the verbs for people.
  void hide();

  /// What is done when the verb is chosen.
  void does(Action action);

 private:
  CLI::App* verb_;
  Action* chosen_;
};

}  // namespace morula::cli
