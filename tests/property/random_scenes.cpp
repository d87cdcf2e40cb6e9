// Tests random scenes for runs that are wrong but look right.
//
//   random_scenes FIRST LAST [FOLDER]     seeds; what fails is shrunk, and written into the folder
//   random_scenes FILE.yaml               one scene, as if it had been drawn
//   random_scenes print SEED              writes what is drawn
//
// Checks of a scene that ends well and sane: own measures agree (own_oracles.h). Without bodies the lineage is the same
// if genes alone decide. Half the step gives a sane run too, or a reason. Resumed from a checkpoint, with other
// instructions, the run has the same bits. Turned and mirrored copies end turned and mirrored. Energy is not gained
// while no event adds any. Refusals must name a place. Failures are counted by their reason, and their advice is tried.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>

#include "base/error.h"
#include "scenario/parameter_table.h"
#include "scene_properties.h"
#include "scenes_by_chance.h"

using namespace morula;
using namespace morula::chance;

namespace {

/// Returns the advice of a message: "KEY VALUE helps", or "use KEY: VALUE".
std::optional<std::pair<std::string, std::string>> adviceIn(const std::string& text) {
  static const std::regex helps(R"(([a-z_]+(?:[.][a-z_-]+)+) ([^ ,;]+) helps)"),
      use(R"(use ([a-z_]+(?:[.][a-z_-]+)+): ([^ ,;]+))");
  std::smatch match;
  if (!std::regex_search(text, match, helps) && !std::regex_search(text, match, use)) return {};
  return std::pair{match[1].str(), match[2].str()};
}

struct Group {
  int count = 0;
  std::map<std::string, int> advised;  // outcomes of scenes that took the advice
  std::string example;
};

struct Tally {
  int sane = 0, cut = 0, finds = 0;
  std::map<std::string, Group> refused, stopped, insane;
  std::set<std::string> drawn;
};

void write(const std::string& folder, std::uint64_t seed, const Verdict& verdict, const Json& smallest) {
  const std::string text =
      fmt::format("# seed {}: {}: {}\n", seed, verdict.find, groupOf(verdict.more)) + sceneText(smallest);
  std::printf("seed %llu: %s: %s\n%s\n", static_cast<unsigned long long>(seed), verdict.find.c_str(),
              verdict.more.c_str(), text.c_str());
  if (folder.empty()) return;
  std::filesystem::create_directories(folder);
  std::ofstream(std::filesystem::path(folder) / fmt::format("random-{}.yaml", seed)) << text;
}

void see(std::uint64_t seed, const std::string& folder, Tally& tally) {
  const Drawn drawn = drawScene(seed);
  tally.drawn.insert(drawn.keys.begin(), drawn.keys.end());
  const Verdict verdict = judge(sceneText(drawn.scenario), seed, !folder.empty());
  const Course& course = verdict.course;
  tally.cut += verdict.tooLong;
  if (!verdict.find.empty()) {
    ++tally.finds;
    int tries = 0;
    write(folder, seed, verdict, shrink(drawn.scenario, [&](const Json& smaller) {
            return ++tries <= 200 && judge(sceneText(smaller), seed, false).find == verdict.find;
          }));
  }
  if (course.sane) {
    ++tally.sane;
    return;
  }
  auto& groups = course.refused ? tally.refused : course.stopped ? tally.stopped : tally.insane;
  Group& group = groups[course.group];
  if (group.count++ == 0)
    group.example = fmt::format("seed {}: {}", seed, course.text.substr(0, course.text.find('\n')));
  if (const auto advice = adviceIn(course.text)) {
    Json better = drawn.scenario;
    const Json value = tryParseJson(advice->second);
    setKey(better, advice->first, value.is_null() ? Json(advice->second) : value);
    std::string became;
    try {
      const Course course = run(readScene(sceneText(better)));
      became = course.sane ? "sane" : course.group;
    } catch (const InputError& e) { became = groupOf(e.what()); }
    ++group.advised[became];
    if (became != "sane") group.example += "\n        with " + advice->first + " " + advice->second + ": " + became;
  }
}

int print(const char* what, const std::map<std::string, Group>& groups, bool examples) {
  int count = 0;
  std::vector<std::pair<int, std::string>> sorted;
  for (const auto& [name, group] : groups) count += group.count, sorted.push_back({-group.count, name});
  std::ranges::sort(sorted);
  std::printf("%s %d\n", what, count);
  for (const auto& [less, name] : sorted) {
    const Group& group = groups.at(name);
    std::printf("  %4d  %s", group.count, name.c_str());
    int advised = 0;
    for (const auto& [became, times] : group.advised) advised += times;
    const auto sane = group.advised.find("sane");
    if (advised > 0)
      std::printf("; its advice, taken %d times, helped %d", advised, sane == group.advised.end() ? 0 : sane->second);
    std::printf("\n");
    if (examples) std::printf("        %s\n", group.example.c_str());
  }
  return count;
}

/// Checks that shrinking a scene that fails only for its drag leaves nothing else.
bool shrinks() {
  Json scenario = drawScene(1).scenario;
  setKey(scenario, "physics.drag", 3.21);
  const auto fails = [](const Json& s) { return s.value(Json::json_pointer("/physics/drag"), 0.0) > 0.5; };
  return shrink(scenario, fails) == Json{{"physics", {{"drag", 1.0}}}};
}

}  // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 4096);
  if (argc == 3 && std::string_view(argv[1]) == "print") {
    std::fputs(sceneText(drawScene(std::strtoull(argv[2], nullptr, 10)).scenario).c_str(), stdout);
    return 0;
  }
  if (argc == 2) {
    std::ifstream file(argv[1]);
    const Verdict verdict = judge({std::istreambuf_iterator<char>(file), {}}, 1, true);
    std::printf("%s: %s\n%s\n", verdict.find.c_str(), verdict.more.c_str(), verdict.course.text.c_str());
    return verdict.find.empty() ? 0 : 1;
  }
  if (argc < 3 || argc > 4) return std::fputs("usage: random_scenes FIRST LAST [FOLDER], or FILE.yaml\n", stderr), 2;
  const std::uint64_t first = std::strtoull(argv[1], nullptr, 10), last = std::strtoull(argv[2], nullptr, 10);
  const std::string folder = argc > 3 ? argv[3] : "";
  if (!shrinks()) return std::puts("a scene that fails is not shrunk"), 1;
  Tally tally;
  for (std::uint64_t seed = first; seed <= last; ++seed) see(seed, folder, tally);
  std::printf("sane: %d\n", tally.sane);
  print("not sane, and said so:", tally.insane, !folder.empty());
  print("stopped:", tally.stopped, !folder.empty());
  const int refused = print("refused:", tally.refused, !folder.empty());
  std::printf("cut short: %d\nkeys drawn: %zu of %zu\nfinds: %d\n", tally.cut, tally.drawn.size(),
              scenario::parameterTable().parameters.size(), tally.finds);
  // Scenes that never run well would prove nothing.
  const int count = static_cast<int>(last - first + 1);
  return tally.finds == 0 && tally.sane >= count / 4 && refused <= count / 2 ? 0 : 1;
}
