// morula compare, also named morula study compare: the findings of a study.
#include <algorithm>
#include <utility>

#include "analysis/organisms.h"
#include "analysis/study_comparison.h"
#include "analysis/study_state.h"
#include "analysis/tidy.h"
#include "base/error.h"
#include "charts/small_multiples.h"
#include "comparison/organism_grid.h"
#include "files/content.h"
#include "files/folders.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "organism/camera.h"
#include "pictures/pictures.h"
#include "study/plan.h"
#include "study_verbs/study_verbs.h"
#include "system/console.h"

namespace morula::cli {
namespace {

struct CompareCommand {
  std::vector<std::string> what;  // a study
  std::string picture, organisms;
  std::vector<std::string> intoGolden;  // scenarios
  GridMoments moments;
  CompareOptions options;
  bool csv = false;
  std::optional<TidyRows> tidy;
  std::optional<Camera> view;
  FigureOptions figure;
  OutputOptions output;
};

/// Returns true for a picture, by its name or its content.
bool isPicture(const std::string& file) { return file.ends_with(".png") || contentOfFile(file) == Content::picture; }

int act(const CompareCommand& command) {
  if (std::ranges::any_of(command.what, isPicture))
    throw UsageError("compare of pictures is now: morula render ONE.png --compare OTHER.png");
  if (command.what.size() > 1)
    throw UsageError("compare takes one study, not " + std::to_string(command.what.size()) + " files");
  const auto rises = [](const auto& list) {
    return std::adjacent_find(list.begin(), list.end(), std::greater_equal<>()) == list.end();
  };
  GridMoments moments = command.moments;
  moments.figure = command.figure.both();
  if (command.view) moments.camera = *command.view, moments.hasView = true;
  if (!rises(moments.times)) throw UsageError("--at-times: needs rising times, as 0.5,1,2");
  if (!rises(moments.cells)) throw UsageError("--at-cells: needs rising numbers of cells, as 4,16,64");
  const std::filesystem::path file = databaseOf(command.what[0]);
  if (command.tidy) {
    std::string lines;  // as many as fit well through a pipe at once
    writeTidy(file, *command.tidy, [&](std::string_view line) {
      lines += line;
      if (lines.size() > 1 << 16) print(std::exchange(lines, {}));
    });
    print(lines);
    return fine;
  }
  const StudyComparison comparison = compareStudy(readStudyResults(file), command.options);
  const bool hasFile = isStudyFile(command.what[0]);
  const Study now = hasFile ? loadStudy(command.what[0]) : Study{};
  const StudyState state = stateOf(comparison.results, hasFile ? now.allowed : comparison.results.allowed,
                                   hasFile ? differenceFrom(file, now) : PlanDifference{});
  if (const std::string why = whyTooMany(comparison.results, moments); !why.empty() && !command.organisms.empty())
    throw UsageError("--pictures: " + why);
  if (!command.intoGolden.empty()) writeIntoGoldens(comparison.results, command.options, file, command.intoGolden);
  std::vector<std::string> pictures;
  if (!command.picture.empty()) {
    SmallMultiples strips = stripsOf(comparison, unitsOf(comparison.results, file));
    moments.figure.set(strips, figureText);
    writePicture(drawSmallMultiples(strips), command.picture);
    pictures.push_back(command.picture);
  }
  if (!command.organisms.empty()) {
    const auto pages = drawOrganisms(comparison.results, file, moments, command.output.quiet);
    for (std::size_t i = 0; i < pages.size(); ++i) {
      std::filesystem::path name = command.organisms;
      if (pages.size() > 1)
        name.replace_filename(name.stem().string() + '-' + std::to_string(i + 1) + name.extension().string());
      writePicture(pages[i], name);
      pictures.push_back(name.string());
    }
  }
  if (command.csv) {
    print(toCsv(comparison));
  } else if (command.output.json) {
    Json json = toJson(comparison, unitsOf(comparison.results, file));
    json.update(toJson(state));
    if (!pictures.empty()) json["pictures"] = pictures;
    printJson(json);
  } else {
    std::string text = textOf(describe(inUnits(comparison, unitsOf(comparison.results, file))));
    for (const std::string& picture : pictures) text += "\npicture  " + picture;
    print(text + (pictures.empty() ? "" : "\n"));
  }
  if (const std::string counts = countsInWords(state); !counts.empty())
    tell(counts + '\n' + linesOf(state), command.output.quiet);
  return exitCodeOf(state.worst());
}

}  // namespace

std::filesystem::path databaseOf(const std::string& named, bool allowOutside) {
  std::filesystem::path file = named;
  if (isStudyFile(named)) file = studyFolder(loadStudy(file, allowOutside));
  else if (!isFolder(file)) return file;
  if (!fileExists(file / "study.db"))
    throw FileError((file / "study.db").string() + ": not there; morula study merge " + named + " makes it");
  return file / "study.db";
}

void addCompare(CLI::App& app, Action& action) {
  Verb verb(app, action, "compare", "Compare the conditions of a study, with confidence intervals");
  auto& command = verb.does<CompareCommand>(act);
  verb.needs("study", command.what, "FILE",
             "The study.db of morula study merge, the folder that it lies in, or the study file");
  verb.takes("--by", command.options.by, "AXIS,...",
             "Axes whose levels are compared, in the mean over the others; default: all");
  verb.takes("--measure", command.options.measures, "NAME,...", "Only these measures");
  verb.takes("--within", command.options.within,
             "Compare levels also at each level of the other axes that are compared");
  verb.takes("--equivalent", command.options.margins, "MARGIN,...",
             "Test whether differences stay within a margin (two one-sided tests): 0.01, 5% of the mean, "
             "sphericity=0.01");
  verb.takes("--csv", command.csv, "One table for other programs");
  verb.takes("-o,--output", command.picture, "FILE", pictureName("compare", true),
             "Also draw all values: a .png, .svg or .pdf");
  verb.takes("--pictures", command.organisms, "FILE", pictureName("compare", false),
             "Also draw the organisms, a row a condition and a column a moment, of one seed, by running them "
             "again; --moments 1 takes the pictures that the study keeps: a .png; of several pages numbered");
  verb.takes(
      "--colour", command.moments.colouring, "WHAT", parseColouring,
      "Colour of cells in --pictures, as render takes it: substance, clone, clone:N, generation, or a measure of cells; "
      "default: substance");
  verb.takes(
      "--view", command.view, "VIEW", parseView,
      "Direction of view in --pictures, as render takes it: front, iso, or azimuth and elevation in degrees: 30,20");
  verb.takes("--labels", command.moments.labels, "WHAT", parseChoice<Labels>,
             "Labels of the cells in --pictures: name or path");
  addFigure(verb, command.figure, 200, 8192, true);
  verb.takes("--moments", command.moments.count, "N", natural(1, maxGridColumns),
             "Number of moments, evenly from the start to the end; 1: the end of each; default: 5");
  verb.takes("--at-times", command.moments.times, "TIME,...", number(scenario::notNegative), "Draw these times");
  verb.takes("--at-cells", command.moments.cells, "N,...", natural(1, 1'000'000),
             "Draw the moments at which so many cells first live");
  verb.oneOf({"--moments", "--at-times", "--at-cells"});
  verb.onlyWith({"--moments", "--at-times", "--at-cells", "--colour", "--view", "--labels"}, {"--pictures"});
  verb.takes("--tidy", command.tidy, "ROWS", parseChoice<TidyRows>,
             "The values alone as CSV with the labels of all axes, for pandas or R: one a line, of runs or "
             "of their cells");
  verb.onlyWith({"--size"}, {"--output", "--pictures"});
  verb.oneOf({"--csv", "--json", "--tidy"});
  verb.takes("--into-golden", command.intoGolden, "SCENARIO,...",
             "Also write the differences of the first level of --by into the golden of this scenario, which "
             "the study varies; of a study of several into that of each which is named");
  add(verb, command.output);
}

}  // namespace morula::cli
