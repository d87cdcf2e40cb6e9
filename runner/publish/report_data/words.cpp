#include "report_data/words.h"

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

}  // namespace morula
