#pragma once
// Pictures of worlds: colours of cells, legends, and the files that are written.
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/multiples.h"
#include "comparison/organism_pair.h"
#include "loop/observer.h"
#include "organism/organism.h"
#include "scenario/scenario.h"
#include "simulation/simulation.h"
#include "trees/lineage_tree.h"

namespace morula {

/// The colours of cells, as the scenario wants them.
class Palette {
 public:
  explicit Palette(const Scenario& scenario) : scenario_(scenario) {}

  /// Returns the colour that the scenario gives the cell, or else the mixture of the colours of all its coloured
  /// substances in "a0 a1 divide"; grey without any.
  Colour colourOf(const CellPath& cell, const std::string& substances);
  /// Returns the colour of a cell with these substances that has none of its own.
  Colour colourOf(const std::string& substances);
  /// Returns the colours used so far, with their names or patterns: "a + b" for a mixture.
  std::vector<LegendEntry> legend() const;

 private:
  const Scenario& scenario_;
  std::map<std::string, Colour> used_;  // by name of the legend's entry
};

/// Returns the organism as it is now. Requires bodies.
OrganismPicture pictureOf(const World& world, const Scenario& scenario);
/// Reserves room for all legend entries in all pictures of a sequence. Each picture shows its own, and the organism
/// does not move when a colour comes or goes.
void shareLegend(std::vector<OrganismPicture>& frames);
/// Returns the lineage so far. Cells with a name are labelled with the name, others with their substances. `describe`
/// returns a state's substances; `end`: present time of the living cells [time]. `experiments`: deeds to be marked.
TreePicture lineagePictureOf(const std::vector<LineageEntry>& cells,
                             const std::function<std::string(StateId)>& describe, double end, const Scenario& scenario,
                             const std::vector<ExperimentRecord>& experiments);
TreePicture lineagePictureOf(const World& world, const Scenario& scenario);

/// Draws our cells, Bullet's, and the distance of each of our vertices from Bullet's surface. `shapes`: vertices of
/// Bullet's cells, in the order of ours.
ComparisonImages imagesBesideBullet(const World& ours, const std::vector<std::vector<Point>>& shapes,
                                    const Scenario& scenario);

/// Keeps the organism's shape at 0, every, 2·every, … and where record.at-cells asks, for a sequence of pictures.
class FrameCollector : public Observer {
 public:
  FrameCollector(const Scenario& scenario, std::optional<double> every)
      : scenario_(scenario), isOn_(every.has_value()), due_(every) {}
  void see(const World& world) override;
  std::uint64_t stepsUntilDue(const World& world) const override;
  void resume(const World& world, const Resumed& earlier) override;
  std::vector<OrganismPicture>& frames() { return frames_; }
  const std::vector<OrganismPicture>& frames() const { return frames_; }

 private:
  bool reaches(std::size_t cells);

  const Scenario& scenario_;
  bool isOn_;  // frames are kept
  Schedule due_;
  std::size_t reached_ = 0;  // count of reached record.atCells
  std::vector<OrganismPicture> frames_;
};

/// Writes a picture in the format of the file's ending (pictureFormat); pixels as PNG. Replaces a picture, but no other
/// kind of file. Throws FileError; no half-written file stays.
void writePicture(const Drawing& drawing, const std::filesystem::path& file);
void writePicture(const Image& image, const std::filesystem::path& file);

/// Returns the ending of a file's name in small letters: ".svg".
std::string endingOf(const std::filesystem::path& file);

/// Returns the format by the ending: ".svg", ".pdf"; PNG for ".png" and without an ending; absent for others.
std::optional<PictureFormat> pictureFormat(const std::filesystem::path& file);

/// Writes organism.png, wireframe.png (with bodies), lineage.png and sequence/0000.png … into the folder. Returns the
/// files. Pictures that an earlier, longer run left in the sequence are removed; other files stay.
std::vector<std::string> writePictures(const World& world, const Scenario& scenario, FrameCollector& collector,
                                       const std::filesystem::path& folder);

}  // namespace morula
