// morula internal describe: the command line for shells and for man(1), as it is installed.
#include "base/error.h"
#include "cli/verbs.h"
#include "options/command_tree.h"
#include "options/exit_codes.h"
#include "store/build_info.h"
#include "system/console.h"

namespace morula::cli {

enum class DescriptionFor { bash, zsh, fish, man };

}  // namespace morula::cli

namespace morula {

template <>
inline constexpr auto choices<cli::DescriptionFor> = std::to_array<Choice<cli::DescriptionFor>>({
    {cli::DescriptionFor::bash, "bash", "completions of bash"},
    {cli::DescriptionFor::zsh, "zsh", "completions of zsh"},
    {cli::DescriptionFor::fish, "fish", "completions of fish"},
    {cli::DescriptionFor::man, "man", "the page of the manual"},
});

}  // namespace morula

namespace morula::cli {

void addDescribe(CLI::App& above, Action& action) {
  Verb verb(above, action, "describe", "Print the verbs and options as completions for a shell, or as a page for man");
  const auto form = std::make_shared<DescriptionFor>();
  verb.does([form, &above] {
    const CommandInfo program = commandTree(above);
    switch (*form) {
      case DescriptionFor::bash: print(bashCompletion(program)); break;
      case DescriptionFor::zsh: print(zshCompletion(program)); break;
      case DescriptionFor::fish: print(fishCompletion(program)); break;
      case DescriptionFor::man: print(manualPage(program, buildInfo().version)); break;
    }
    return fine;
  });
  verb.needs("form", *form, "FORM", parseChoice<DescriptionFor>, namesOf<DescriptionFor>());
}

}  // namespace morula::cli
