#include "tasks/shard.h"

#include "base/error.h"
#include "yaml/numbers.h"

namespace morula {

Shard parseShard(const std::string& text) {
  const auto refuse = [&] {
    throw InputError("'" + text + "' is no share; needs NUMBER/OF with 1 ≤ NUMBER ≤ OF ≤ 1000000, as 3/40");
  };
  const auto slash = text.find('/');
  if (slash == text.npos) refuse();
  const auto number = scenario::parseNatural(text.substr(0, slash)),
             of = scenario::parseNatural(text.substr(slash + 1));
  constexpr std::uint64_t most = 1'000'000;
  if (!number.wrong.empty() || !of.wrong.empty() || number.value < 1 || number.value > of.value || of.value > most)
    refuse();
  return {static_cast<std::size_t>(number.value), static_cast<std::size_t>(of.value)};
}

std::vector<std::size_t> tasksOf(const Shard& shard, std::size_t count) {
  std::vector<std::size_t> tasks;
  for (std::size_t task = shard.number - 1; task < count; task += shard.of) tasks.push_back(task);
  return tasks;
}

}  // namespace morula
