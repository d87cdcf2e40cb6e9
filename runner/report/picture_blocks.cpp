// Pictures and charts of runs.
#include <algorithm>

#include "base/number_text.h"
#include "page/html.h"
#include "pictures/pictures.h"
#include "report/run_blocks.h"
#include "report/time_chart.h"

namespace morula {

namespace {

constexpr std::size_t mostLines = 24;     // runs in one chart
constexpr std::size_t mostPictured = 8;   // runs with pictures
constexpr std::size_t treeLimit = 20000;  // cells in a tree that is drawn

std::string treeOf(const RunFacts& facts) {
  const auto describe = [&](StateId state) { return facts.results.stateTexts.at(state); };
  return pngFile(
      drawLineage(lineagePictureOf(facts.results.lineage, describe, facts.run.time, facts.scenario))
          .pixels());
}

Image organismOf(const RunFacts& facts) {
  return drawOrganism(pictureOf(facts.again->simulation.world, facts.scenario));
}

/// Whether its last state can be drawn: that of a failed run may hold what are no numbers.
bool canBeDrawn(const RunFacts& facts) {
  return facts.again && facts.again->simulation.world.bodies &&
         facts.again->simulation.end.status == RunStatus::done;
}

std::string overlay(const std::vector<const RunFacts*>& pictured, const std::vector<RunFacts>& all) {
  if (pictured.size() < 2) return {};
  return "<div id=\"compare\" data-first=\"picture-0\" data-second=\"picture-1\" data-names=\"" +
         htmlText(shown(titleOf(*pictured[0], all)) + " | " + shown(titleOf(*pictured[1], all))) +
         "\"></div>\n";
}

/// Cells over time: one more at each division, one fewer at each death.
std::vector<Spot> cellsOverTime(const RunFacts& facts) {
  std::vector<std::pair<double, int>> changes;
  for (const LineageEntry& cell : facts.results.lineage) {
    changes.push_back({cell.born, 1});
    if (cell.fate != Fate::alive) changes.push_back({cell.ended, -1});
  }
  std::sort(changes.begin(), changes.end());
  std::vector<Spot> points;
  int alive = 0;
  for (const auto& [time, change] : changes) {
    alive += change;
    if (!points.empty() && points.back().x == time) points.back().y = alive;
    else points.push_back({time, double(alive)});
  }
  if (!points.empty()) points.push_back({facts.run.time, double(alive)});
  return points;
}

std::vector<Spot> measureOverTime(const RunFacts& facts, std::size_t measure) {
  std::vector<Spot> points;
  const auto add = [&](const WorldMeasures& world) {
    if (const auto& value = world.values[measure]; value && std::isfinite(*value))
      points.push_back({world.time, *value});
  };
  if (facts.again && facts.again->same)
    for (const WorldMeasures& world : facts.again->frames.worlds) add(world);
  else
    for (const Sample& sample : facts.results.samples) add(sample.world);
  return points;
}

std::string chartOf(const TimeChart& chart, const std::string& meaning) {
  return htmlPicture("image/svg+xml", drawTimeChart(chart).file(PictureFormat::svg),
                     chart.title + " over time", meaning);
}

}  // namespace

PageBlock pictureBlock(const std::vector<RunFacts>& runs) {
  PageBlock block{"pictures", "Pictures", "", {}};
  std::vector<const RunFacts*> pictured;
  std::string html;
  for (const RunFacts& r : runs) {
    if (pictured.size() >= mostPictured) break;
    const std::string title = runs.size() > 1 ? titleOf(r, runs) + ": " : "";
    if (canBeDrawn(r)) {
      html += "<div id=\"picture-" + std::to_string(pictured.size()) + "\">" +
              htmlPicture("image/png", pngFile(organismOf(r)),
                          title + "the organism at time " + numberText(r.run.time, 6) + ", " +
                              counted(r.run.cells, "cell"),
                          title + "the organism at the end") +
              "</div>\n";
      if (runs.size() == 1)
        html += htmlPicture(
            "image/png",
            pngFile(drawOrganism(pictureOf(r.again->simulation.world, r.scenario), Style::wireframe)),
            title + "the same as meshes", title + "the meshes");
      block.commands.push_back(commandFor(r, "render", "-o organism.png"));
      pictured.push_back(&r);
    }
    if (!r.results.lineage.empty() && r.results.lineage.size() <= treeLimit) {
      html += htmlPicture("image/png", treeOf(r),
                          title + "the tree of " + counted(r.results.lineage.size(), "cell"),
                          title + "the lineage");
      block.commands.push_back(commandFor(r, "lineage", "-o lineage.png"));
    }
  }
  block.html = overlay(pictured, runs) + "<div class=\"pictures\">\n" + html + "</div>\n";
  if (block.commands.size() > 4) block.commands.resize(4);
  return block;
}

PageBlock chartBlock(const std::vector<RunFacts>& runs) {
  PageBlock block{"charts", "Charts", "<div class=\"charts\">\n", {}};
  const std::size_t count = std::min(runs.size(), mostLines);
  TimeChart cells{"cells", "living cells", {}};
  for (std::size_t i = 0; i < count; ++i)
    cells.lines.push_back({titleOf(runs[i], runs), cellsOverTime(runs[i]), true});
  block.html += chartOf(cells, "Living cells over time");
  const auto measures = sampledMeasures<Observation>();
  for (std::size_t m = 0; m < measures.size(); ++m) {
    if (std::string_view(measures[m].name) == "cells") continue;
    TimeChart chart{measures[m].name, measures[m].unit, {}};
    for (std::size_t i = 0; i < count; ++i)
      if (auto points = measureOverTime(runs[i], m); points.size() > 1)
        chart.lines.push_back({titleOf(runs[i], runs), std::move(points)});
    if (!chart.lines.empty())
      block.html += chartOf(chart, std::string(measures[m].name) + ": " + measures[m].meaning);
  }
  block.html += "</div>\n";
  if (runs.size() > mostLines)
    block.html += "<p class=\"note\">The first " + std::to_string(mostLines) + " of " +
                  counted(runs.size(), "run") + ".</p>\n";
  block.commands = {"sqlite3 " + shellWord(runs[0].database) + " \"SELECT * FROM sample WHERE run_id = '" +
                    runs[0].run.id + "'\""};
  return block;
}

}  // namespace morula
