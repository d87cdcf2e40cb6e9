#include "options/command_tree.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "options/verb.h"

namespace morula::cli {
namespace {

OptionInfo describe(const CLI::Option& option) {
  OptionInfo info{.names = {},
                  .type = option.get_type_size() == 0 ? "" : option.get_type_name(),
                  .help = option.get_description(),
                  .shown = option.get_default_str(),
                  .choices = choicesOf(option),
                  .isPositional = !option.nonpositional(),
                  .isRequired = option.get_required()};
  for (const std::string& name : option.get_snames()) info.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) info.names.push_back("--" + name);
  if (info.isPositional) info.names = {option.get_name(true)};
  return info;
}

CommandInfo describe(const CLI::App& app) {
  CommandInfo info{
      .name = app.get_name(), .purpose = app.get_description(), .options = {}, .commands = {}, .isAlias = isAlias(app)};
  for (const CLI::Option* option : app.get_options()) info.options.push_back(describe(*option));
  for (const CLI::App* inner : app.get_subcommands([](const CLI::App* verb) { return !verb->get_group().empty(); }))
    info.commands.push_back(describe(*inner));
  return info;
}

}  // namespace

CommandInfo commandTree(const CLI::App& verb) {
  const CLI::App* program = &verb;
  while (program->get_parent()) program = program->get_parent();
  CommandInfo tree = describe(*program);
  for (CommandInfo& group : tree.commands)
    for (CommandInfo& inner : group.commands)
      if (inner.isAlias) inner.options = std::ranges::find(tree.commands, inner.name, &CommandInfo::name)->options;
  return tree;
}

}  // namespace morula::cli
