#pragma once
// From what a run left behind to charts: a measure over time, who touches whom, which way cells divided.
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "charts/chart.h"
#include "charts/matrix.h"
#include "charts/rose.h"
#include "scenario/scenario.h"
#include "store/records.h"
#include "trees/lineage_tree.h"

namespace morula {

/// A measure, of any scope.
struct MeasureName {
  Scope scope;
  std::string name;
  std::string title;  // "neighbour count"
  std::string unit;   // the scene's
};

/// "volume" or with its scope "cell.volume": without, the first of world, cell and pair that has the name. Throws
/// InputError with the name that was probably meant.
MeasureName parseMeasure(std::string_view text);

/// One line of the world, or one for each cell or pair, over all samples. Few lines have colours of their own and
/// labels at their ends, many have those of their clones. Throws InputError where no sample has the measure, which says
/// what a scenario must record.
Chart seriesOf(const RunResults& results, const MeasureName& measure, const Scenario& scenario);

/// Contact areas of the cells in the last sample that is not after `time`; cells by path. Throws InputError where
/// there is none, or no contact in the scene.
MatrixPicture contactsOf(const RunResults& results, double time, const Scenario& scenario);

/// Which way the axes of divisions point, towards daughter A, seen from the front, from the side and from above. Throws
/// InputError for a run without divisions of cells with bodies.
RosePicture divisionsOf(const RunResults& results, const Scenario& scenario);

/// The tree in the colours of a measure of cells: of each cell the mean over its samples; grey where it has none. Throws
/// InputError as seriesOf, and for measures of other scopes.
void colourTree(TreePicture& tree, const RunResults& results, const MeasureName& measure, const Units& units);

}  // namespace morula
