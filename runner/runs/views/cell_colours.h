#pragma once
// The colours of cells: by substances, clone, generation, or any measure of a cell.
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/axis.h"
#include "observation/measures.h"
#include "organism/organism.h"
#include "scenario/scenario.h"
#include "simulation/simulation.h"

namespace morula {

struct Colouring {
  enum class By { substance, clone, generation, measure };
  By by = By::substance;
  int founders = 2;       // of clones: cells that stand so many divisions below the egg, 1 to 4
  std::string measure{};  // of cells, as AskedMeasure::name [observation/asked_measure.h]
};

/// "substance", "clone", "clone:3", "generation" or a measure of cells, also of some alone (shell_share of AAA*).
/// Throws InputError with what it may be, and the measure that was probably meant.
Colouring parseColouring(std::string_view text);

/// The ancestor that the cell's clone is called by, `founders` divisions below the egg; a cell above it stands for
/// itself.
std::string founderOf(const std::string& path, int founders);
/// Makes the legend for cloneColour of these founders. Founders that share a colour, as an egg and its first daughter
/// do, share an entry.
std::vector<LegendEntry> cloneLegend(const std::set<std::string>& founders, const Scenario& scenario);

/// The ends of a colour bar for this range: one value where the ends differ by rounding alone.
Range withoutRounding(Range range);

/// The values from which colours follow, in the order of the world's cells: the measure's value, absent if it is not
/// measured; the generation; nothing for other colourings.
std::vector<std::optional<double>> colourValues(const World& world, const Colouring& colouring,
                                                const Scenario& scenario);

/// Colours the first cells of each picture by these values, which belong to them, and says in legend and colour bar
/// what colours mean: the same in all of the pictures; the bar's ends are the least and the greatest value of a cell
/// that is drawn (opacity > 0) in any of them. Nothing for substances.
void colourCells(std::vector<OrganismPicture>& pictures, const std::vector<std::vector<std::optional<double>>>& values,
                 const Colouring& colouring, const Scenario& scenario);

}  // namespace morula
