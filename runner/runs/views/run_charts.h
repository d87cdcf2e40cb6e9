#pragma once
// From what a run left behind to charts: a measure over time, who touches whom, which way cells divided.

#include "charts/chart.h"
#include "charts/charts_of_pairs.h"
#include "observation/asked_measure.h"
#include "scenario/scenario.h"
#include "store/records.h"
#include "trees/lineage_tree.h"
#include "views/cell_colours.h"

namespace morula {

/// One line of the world, or one for each cell or pair that is asked for, over all samples. Few lines have colours of
/// their own and labels at their ends, many have those of their clones. Throws InputError where no sample has the
/// measure, which says what a scenario must record.
Chart seriesOf(const RunResults& results, const AskedMeasure& measure, const Scenario& scenario);

/// Contact areas of the cells in the last sample that is not after `time`; cells by path. Throws InputError where
/// there is none, or no contact in the scene.
MatrixPicture contactsOf(const RunResults& results, double time, const Scenario& scenario);

/// Draws the directions of the axes of divisions, towards daughter A, seen from the front, from the side and from
/// above. Throws InputError for a run without divisions of cells with bodies.
RosePicture divisionsOf(const RunResults& results, const Scenario& scenario);

/// The tree in the colours of clones, generations or a measure of cells: of each cell the mean over its samples; grey
/// where it has none. Throws InputError as seriesOf. Nothing for substances.
void colourTree(TreePicture& tree, const RunResults& results, const Colouring& colouring, const Scenario& scenario);

}  // namespace morula
