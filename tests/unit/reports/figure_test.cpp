// Figures for print: at 85 mm, a journal's column, all words have 6 to 8 pt, and none is cut or beyond the page.
#include "catch.h"
#include "charts/chart.h"
#include "charts/charts_of_pairs.h"
#include "charts/small_multiples.h"
#include "comparison/organism_grid.h"
#include "drawing/palette.h"
#include "figures.h"
#include "pictures.h"
#include "trees/lineage_tree.h"

namespace morula {
namespace {

const FigureSize column{.width = 85, .inPrint = true};
const std::string longTitle = "a title that has more words than a column of a journal can hold in one line",
                  longCaption =
                      "a caption of many words, which say what the figure shows, and for how many cells and runs";

template <class Picture>
Picture printed(Picture picture, double textSize, double ratio = 0) {
  picture.title = longTitle, picture.caption = longCaption;
  column.set(picture, textSize, ratio);
  return picture;
}

void check(const Drawing& drawing) {
  const std::string svg = drawing.file(PictureFormat::svg), pdf = drawing.file(PictureFormat::pdf);
  const test::PrintedPage one = test::pageOfSvg(svg), other = test::pageOfPdf(pdf);
  CHECK(test::wrongOn(one, 85) == "");
  CHECK(test::wrongOn(other, 85) == "");
  CHECK(other.height == Approx(one.height).margin(0.02));
  CHECK(other.words.size() > one.words.size() / 2);  // in PDF texts of one line may be one
  CHECK(test::holdsFonts(pdf));
  CHECK(drawing.pixels().width == 1004);  // 85 mm of 300 dots an inch
}

std::vector<LineageNode> treeOf(int divisions) {
  std::vector<LineageNode> nodes;
  std::vector<std::string> paths{""};
  for (int d = 0; d <= divisions; ++d) {
    std::vector<std::string> next;
    for (const std::string& path : paths) {
      nodes.push_back({.path = path,
                       .born = double(d),
                       .ended = d + 1.0,
                       .fate = d < divisions ? Fate::divided : Fate::alive,
                       .label = "cell " + path});
      next.push_back(path + "A"), next.push_back(path + "B");
    }
    paths = next;
  }
  return nodes;
}

}  // namespace

TEST_CASE("Charts at 85 mm have words of 6 to 8 pt, and none is cut", "[figure]") {
  Chart chart;
  for (std::size_t i = 0; i < fewSeries; ++i)
    chart.lines.push_back({"cell ABa" + std::to_string(i), seriesColour(i), {{0, 1.0 * i}, {1, 3 + 0.1 * i}}});
  chart.lines[0].points[1].x = 0.5, chart.lines[0].pointLabels = {"", "ended"};
  chart.xLabel = "time [min]", chart.yLabel = "volume [µm³]";
  chart.xScale = chart.yScale = Axis::Scale::linear;
  for (const std::size_t i : {0, 1, 5})
    chart.legend.push_back({seriesColour(i), "clone of a founder " + std::to_string(i)});
  check(drawChart(printed(chart, figureText)));
  for (const std::size_t n : {3, 12, 60}) {
    MatrixPicture matrix;
    for (std::size_t i = 0; i < n; ++i) matrix.names.push_back("ABp" + std::to_string(i));
    for (std::size_t i = 0; i < n * n; ++i) matrix.values.push_back(double(i));
    matrix.quantity = "contact area [µm²]";
    check(drawMatrix(printed(matrix, figureText)));
  }
  RosePicture roses;
  for (const char* title : {"from the front", "from the right", "from above"})
    roses.roses.push_back({title, "x", "z", {0, 10, 20, 90, 100, 200}});
  check(drawRoses(printed(roses, figureText)));
}

TEST_CASE("Strips at 85 mm have words of 6 to 8 pt, and none is cut", "[figure]") {
  SmallMultiples chart;
  chart.words = {
      longTitle, longCaption, {{seriesColour(0), "rule: the longest axis"}, {seriesColour(1), "rule: neighbours"}}};
  for (int m = 0; m < 3; ++m) {
    Panel panel{
        .title = "A measure with a name that needs more than one line in a panel [µm²/min]", .strips = {}, .lines = {}};
    for (int i = 0; i < 4; ++i)
      panel.strips.push_back({"viscosity: 0.25, holds: spindles of all cells, stage: " + std::to_string(i),
                              seriesColour(i),
                              {1, 2, 3},
                              2,
                              std::pair{1., 3.}});
    panel.meaning =
        "Root mean square distance of the centres of a clone's cells from their mean, in the mean over the clones";
    chart.panels.push_back(panel);
  }
  chart.panels.push_back({.title = "over time",
                          .strips = {},
                          .lines = {{red, {{0, 1}, {5, 3}}, {{0.5, 1.5}, {2, 4}}}},
                          .xLabel = "time [min]",
                          .meaning = longCaption});
  column.set(chart, figureText);
  check(drawSmallMultiples(chart));
  // The wall between columns of panels: 180 mm hold two.
  FigureSize{.width = 180, .inPrint = true}.set(chart, figureText);
  const Drawing wide = drawSmallMultiples(chart);
  CHECK(test::wrongOn(test::pageOfSvg(wide.file(PictureFormat::svg)), 180) == "");
  CHECK(wide.height() < 1.2 * wide.width());
}

TEST_CASE("Trees at 85 mm have labels of 6 to 8 pt or none", "[figure]") {
  for (const int divisions : {1, 3, 4, 6}) {
    TreePicture tree;
    tree.nodes = treeOf(divisions), tree.timeLabel = "time [min]";
    tree.colourBar = ColourBar{"volume [µm³], mean over a cell's samples", 0, 12};
    check(drawLineage(printed(tree, figureText)));
    tree.labelsAll = true;
    if (divisions == 6)
      CHECK_THROWS_WITH(drawLineage(printed(tree, figureText)),
                        ContainsSubstring("the labels of 64 cells do not fit into 85 mm; needs at least "));
    else check(drawLineage(printed(tree, figureText)));
  }
}

TEST_CASE("Organisms at 85 mm have words of 6 to 8 pt beside pixels of 300 dots an inch", "[figure]") {
  OrganismPicture one = picture({ball("A", {-1, 0, 0}, 1, red), ball("B", {1, 0, 0}, 1, blue)});
  one.legend = {{red, "a founder"}, {blue, "another founder"}};
  one.labels = {{0, "ABa"}, {1, "ABp"}};
  one.instruments.scaleBar = one.instruments.axes = true;
  const OrganismPicture alone = printed(one, dotsAsPixels, 1);
  CHECK(alone.width == 1004);
  check(organismDrawing(alone, {Style::solid}));
  OrganismGrid grid;
  grid.columns = {"time 12.5 min", "time 25 min", "time 50 min"};
  for (int row = 0; row < 2; ++row) {
    grid.rows.push_back({"rule: the longest axis", "seed " + std::to_string(row)});
    for (int c = 0; c < 3; ++c) grid.tiles.push_back({one, false, "32 cells at the end, time 48.5 min"});
  }
  for (const Drawing& page : drawOrganismGrid(printed(grid, organismGridText))) check(page);
}

TEST_CASE("A size in pixels with a font gives pixels and points that are asked for", "[figure]") {
  Chart chart;
  chart.lines = {{"", seriesColour(0), {{1, 1}, {2, 2}}}};
  FigureSize{.width = 600, .height = 400, .font = 12}.set(chart, figureText);
  const Drawing drawing = drawChart(chart);
  CHECK(drawing.pixels().width == 600);
  CHECK(drawing.pixels().height == Approx(400).margin(1));  // of the layout's rounding
  CHECK(drawing.file(PictureFormat::svg).find("width=\"600px\"") != std::string::npos);
  const test::PrintedPage page = test::pageOfPdf(drawing.file(PictureFormat::pdf));
  CHECK(page.width == Approx(450));
  for (const auto& words : page.words) CHECK(words.points > 12 * smallText - 0.01);
}

}  // namespace morula
