#include "options/program.h"

#include <CLI/CLI.hpp>
#include <csignal>
#include <system_error>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "base/floating_point.h"
#include "database/store_error.h"
#include "files/text.h"
#include "options/exit_codes.h"
#include "options/old_words.h"
#include "store/build_info.h"
#include "system/console.h"
#include "system/signals.h"
#include "system/usable_memory.h"

namespace morula::cli {
namespace {

std::string typed;

std::string versionText() {
  const auto& build = buildInfo();
  return "morula " + build.version + " (" + build.gitCommit + ", " + build.gitState + "; " + build.compiler + ", " +
         build.target + ")";
}

/// Returns the names of the verbs that are not hidden.
std::vector<std::string> verbNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const auto* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!verb->get_group().empty()) names.push_back(verb->get_name());
  return names;
}

/// Returns the innermost verb that was chosen, or the program.
const CLI::App* chosenOf(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? &app : chosenOf(*chosen.front());
}

/// Returns "run" or "study plan".
std::string titleOf(const CLI::App& verb) {
  const auto* above = verb.get_parent();
  return (above && above->get_parent() ? titleOf(*above) + " " : "") + verb.get_name();
}

/// Throws for a misspelt verb, since CLI11 would only say that a verb is required.
void checkVerb(const CLI::App& app, const std::string& word) {
  const std::string before = app.get_parent() ? titleOf(app) + ": " : "";
  if (word.empty()) throw UsageError(before + "no verb; one of " + join(verbNames(app)) + ", or --help");
  if (word.starts_with("-")) return;
  const auto verbs = app.get_subcommands([&](const CLI::App* verb) { return verb->get_name() == word; });
  if (!verbs.empty()) return;
  const auto names = verbNames(app);
  if (word.ends_with(".yaml") || word.ends_with(".yml"))
    throw UsageError(before + "'" + word + "' is not a verb; did you mean morula " +
                     (app.get_parent() ? titleOf(app) + " " : "") + names.front() + " " + word + "?");
  const auto near = closest(word, names);
  throw UsageError(before + "unknown verb '" + word + "'; " +
                   (near.empty() ? "one of " + join(names) : "did you mean " + near + "?"));
}

/// Throws for words that the verb did not expect, and suggests an option.
void checkLeftovers(const CLI::App& verb) {
  auto leftovers = verb.remaining();
  std::erase(leftovers, "--");  // CLI11 takes the words after this mark as files, and leaves the mark itself
  if (leftovers.empty()) return;
  const auto word = leftovers.front().substr(0, leftovers.front().find('='));
  std::vector<std::string> options;
  for (const auto* option : verb.get_options())
    for (const auto& name : option->get_lnames()) options.push_back("--" + name);
  const auto near = closest(word, options);
  throw UsageError(
      titleOf(verb) + ": '" + word + "' is not expected; " +
      (near.empty() ? "morula " + titleOf(verb) + " --help lists the options" : "did you mean " + near + "?"));
}

/// Turns an error of CLI11 into a sentence.
std::string sentenceOf(const CLI::ParseError& error, const CLI::App& verb) {
  const std::string text = error.what(), option = text.substr(0, text.find(':'));
  if (text.find(" required but received ") != text.npos) return option + ": given more than once; keep one";
  if (text.ends_with(" missing")) return option + ": needs a value";
  if (dynamic_cast<const CLI::RequiredError*>(&error))
    return text + "; morula " + titleOf(verb) + " --help tells what it takes";
  return text;
}

Action parse(int argc, char** argv, std::span<AddVerb* const> verbs) {
  checkOldWords({argv + 1, argv + std::max(argc, 1)});
  // The app lives as long as the action, which reads its options.
  const auto owner =
      std::make_shared<CLI::App>("Morula grows organisms from one cell, the same bits every time.", "morula");
  CLI::App& app = *owner;
  app.footer(
      "Exit codes: 0 fine, 1 a check differs, 2 usage, 3 input invalid, 4 numerical failure, 5 study "
      "incomplete, 6 file or database,\n"
      "70 bug, 130 and 143 interrupted.");
  app.require_subcommand(0, 1);  // a file may have the name of another verb
  app.set_version_flag("--version", versionText());
  Action action;
  const std::string word = argc > 1 ? argv[1] : "";
  const auto all = [](CLI::App*) { return true; };
  for (AddVerb* add : verbs) {
    add(app, action);
    if (app.get_subcommands(all).back()->get_name() == word) break;  // the options of all verbs take a millisecond
  }
  for (auto* verb : app.get_subcommands(all)) {
    verb->allow_extras();
    for (auto* inner : verb->get_subcommands(all)) inner->allow_extras();
  }
  checkVerb(app, word);
  for (auto* verb : app.get_subcommands(all)) {
    if (verb->get_name() != word || verb->get_subcommands(all).empty()) continue;
    const std::string inner = argc > 2 ? argv[2] : "";
    checkVerb(*verb, inner);
    for (const auto* below : verb->get_subcommands(all)) {
      if (below->get_name() != inner || !isAlias(*below)) continue;
      std::vector<char*> words{argv[0]};  // without the group
      words.insert(words.end(), argv + 2, argv + argc);
      return parse(static_cast<int>(words.size()), words.data(), verbs);
    }
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    print(app.help());  // the help of the innermost verb that was chosen
    return [] { return fine; };
  } catch (const CLI::CallForVersion&) {
    print(versionText() + "\n");
    return [] { return fine; };
  } catch (const CLI::ParseError& error) {
    const auto* chosen = chosenOf(app);
    if (chosen == &app)
      throw UsageError("'" + word + "' is not expected; one of " + join(verbNames(app)) + ", or --help");
    checkLeftovers(*chosen);
    throw UsageError(titleOf(*chosen) + ": " + sentenceOf(error, *chosen));
  }
  if (const auto* chosen = chosenOf(app); chosen != &app) checkLeftovers(*chosen);
  if (!action) throw UsageError("no verb; one of " + join(verbNames(*chosenOf(app))) + ", or --help");
  return [owner, action] { return action(); };
}

}  // namespace

std::string commandLine() { return typed; }

int runProgram(int argc, char** argv, std::span<AddVerb* const> verbs) {
  setFloatingPoint();
  endOutOfMemoryWith(numerical);
  std::signal(SIGXFSZ,
              SIG_IGN);           // a write beyond the limit of file sizes then fails, as on a full disk
  std::signal(SIGCHLD, SIG_DFL);  // a caller may have set it to ignore, which makes waiting for processes impossible
  try {
    for (int i = 0; i < argc; ++i) typed += i ? ' ' + shellWord(argv[i]) : "morula";
    reserveStandardStreams();
    const int code = parse(argc, argv, verbs)();
    flushOutput();
    return code;
  } catch (const UsageError& error) {
    tellError(error.what());
    return usage;
  } catch (const InputError& error) {
    tellInputError(error.what());
    return input;
  } catch (const NumericalError& error) {
    tellError(error.what());
    return numerical;
  } catch (const NondeterminismError& error) {
    tellError(error.what());
    return differs;
  } catch (const Interrupted& by) { return signalled + by.signal; } catch (const FileError& error) {
    tellError(error.what());
    return file;
  } catch (const std::bad_alloc&) {
    tellError(std::string("there is no more memory; ") + outOfMemoryRemedy);
    return numerical;
  } catch (const std::system_error& error) {  // from the standard library, on files or threads
    tellError(error.what());
    return file;
  } catch (const std::exception& error) {
    tellError(std::string("a bug of Morula's, please report it: ") + error.what());
    return bug;
  }
}

}  // namespace morula::cli
