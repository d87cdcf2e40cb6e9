#include "report_data/words.h"

#include <map>

#include "system/installation.h"

namespace morula {

Finding failedBecause(Finding::Kind kind, const std::string& before, const std::string& failure) {
  const auto end = failure.find("; ");
  Finding finding{kind, before + failure.substr(0, end)};
  for (std::size_t from = end, to = end; to != failure.npos; from = to) {
    to = failure.find("; ", from + 2);
    finding.why.push_back(failure.substr(from + 2, to == failure.npos ? to : to - from - 2));
  }
  return finding;
}

std::string failedInWords(const CheckResult& failed) {
  if (failed.check == "run") return "the run failed";
  if (failed.kind == "sanity") return "its end is not sane";
  if (failed.kind == "invariant") return "what must always hold does not";
  if (failed.kind == "bullet") return "Bullet comes to something else";
  static const std::map<std::string, std::string> words{
      {"INPUT_CHANGED", "the scenario or its golden changed"},
      {"SETUP", "it starts otherwise"},
      {"LINEAGE", "the lineage differs"},
      {"COMPUTATION", "computed values differ"},
      {"CHAOS", "a last place has grown"},
      {"IMAGE", "the picture differs"},
      {"COST", "the cost differs"},
      {"NONDETERMINISM", "it gives different bits each time"}};
  const auto found = words.find(failed.failureClass);
  return found == words.end() ? failed.failureClass : found->second;
}

const std::string& titleOf(const RunFacts& run) { return run.title; }

Picture pngPicture(const Image& image, const std::string& what, const std::string& caption,
                   const std::string& name, Picture::Size size) {
  return {"image/png", pngFile(image), what, caption, size, name};
}

Picture svgPicture(const Drawing& drawing, const std::string& what, const std::string& caption,
                   Picture::Size size) {
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

}  // namespace morula
