#include "report_data/run_words.h"

#include <map>

#include "drawing/png_file.h"
#include "scenario/deciding_values.h"
#include "system/installation.h"

namespace morula {
namespace {

constexpr std::size_t maxKeys = 2;    // max number of parameters in a title
constexpr std::size_t longest = 24;   // [byte] max length of a value in a title
constexpr std::size_t maxNamed = 64;  // max number of runs of one scenario that are distinguished by parameters

using RunGroup = std::vector<RunFacts*>;

void addIds(const RunGroup& group) {
  for (RunFacts* run : group) run->title += " (" + run->run.id + ")";
}

/// Adds the values that differ within the group to the titles of its runs. If the page has no `others`, these values
/// alone are the titles.
void tellApart(const RunGroup& group, bool others) {
  if (group.size() > maxNamed) return addIds(group);
  std::vector<std::map<std::string, std::string>> values;
  std::map<std::string, std::size_t> known;  // how many runs have each key
  for (const RunFacts* run : group) {
    const auto deciding = decidingValues(run->scenario);
    values.emplace_back(deciding.begin(), deciding.end());
    for (const auto& [key, value] : values.back()) ++known[key];
  }
  std::vector<std::string> keys;
  for (const auto& [key, count] : known) {
    bool differs = count < group.size();
    for (const auto& of : values) differs = differs || (of.contains(key) && of.at(key) != values[0].at(key));
    if (differs && key != "seed") keys.push_back(key);
  }
  if (keys.empty() || keys.size() > maxKeys) return addIds(group);
  for (const auto& of : values)
    for (const std::string& key : keys)
      if (of.contains(key) && of.at(key).size() > longest) return addIds(group);
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (!others) group[i]->title.clear();
    for (const std::string& key : keys)
      group[i]->title += (group[i]->title.empty() ? "" : ", ") + key + ' ' +
                         (values[i].contains(key) ? values[i].at(key) : "not given");
  }
}

std::map<std::string, RunGroup> groupsOf(std::vector<RunFacts>& runs) {
  std::map<std::string, RunGroup> groups;
  for (RunFacts& run : runs) groups[run.title].push_back(&run);
  return groups;
}

}  // namespace

Finding failedBecause(Finding::Kind kind, const std::string& before, const std::string& failure) {
  const auto end = failure.find("; ");
  Finding finding{kind, before + failure.substr(0, end)};
  for (std::size_t from = end, to = end; to != failure.npos; from = to) {
    to = failure.find("; ", from + 2);
    finding.why.push_back(failure.substr(from + 2, to == failure.npos ? to : to - from - 2));
  }
  return finding;
}

const std::string& titleOf(const RunFacts& run) { return run.title; }

Picture pngPicture(const Image& image, const std::string& what, const std::string& caption, const std::string& name,
                   Picture::Size size) {
  return {"image/png", pngFile(image), what, caption, size, name};
}

Picture svgPicture(const Drawing& drawing, const std::string& what, const std::string& caption, Picture::Size size) {
  return {"image/svg+xml", drawing.file(PictureFormat::svg), what, caption, size};
}

std::string sourceOf(const RunFacts& run) {
  for (const SourceText& d : run.documents)
    if (d.role == "scenario") return d.path;
  return run.run.record.scenario + ".yaml";
}

std::string commandFor(const RunFacts& run, const std::string& verb, const std::string& options) {
  return programWord() + " " + verb + " " + shellWord(run.database) + " --run " + run.run.id +
         (options.empty() ? "" : " " + options);
}

void nameRuns(std::vector<RunFacts>& runs) {
  for (RunFacts& run : runs)
    run.title =
        (run.label.empty() ? run.run.record.scenario : run.label) + ", seed " + std::to_string(run.run.record.seed);
  for (const auto& [title, group] : groupsOf(runs))
    if (group.size() > 1) tellApart(group, group.size() < runs.size());
  for (const auto& [title, group] : groupsOf(runs))
    if (group.size() > 1 && !title.ends_with(" (" + group[0]->run.id + ")")) addIds(group);
}

}  // namespace morula
