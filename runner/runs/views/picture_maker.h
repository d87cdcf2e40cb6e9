#pragma once
// Pictures of a world as they are wished for: from where, what is added to the cells, what colours tell.
#include <optional>
#include <string>
#include <vector>

#include "diagnose/vertex_forces.h"
#include "views/cell_colours.h"

namespace morula {

/// How solid the cells are that have a substance which fits the pattern [biology/substance_pattern.h]; "*": all.
struct CellOpacity {
  std::string pattern;
  double opacity = 1;  // 0 to 1
};

enum class Labels { none, name, path };
template <>
inline constexpr auto choices<Labels> =
    std::to_array<Choice<Labels>>({{Labels::none, "none", "nothing is written at cells"},
                                   {Labels::name, "name", "names; of a cell without one its path"},
                                   {Labels::path, "path", "paths"}});

struct PictureWishes {
  Colouring colouring;
  Camera camera;
  int width = 900, height = 900, samples = 2;  // as OrganismPicture
  Print print = {};
  bool transparent = false;
  std::optional<ClipPlane> clip;
  bool normals = false, connections = false, axes = false, scaleBar = false;
  Labels labels = Labels::none;
  std::vector<CellOpacity> opacities;  // a later one counts more
  std::vector<ForceKind> forces;       // each once
};

/// Pictures that share colours, legend, framing and the scale of their arrows. Arrows take much more memory than the
/// forces that they show, so that a picture gets its own only when it is asked for.
class Pictures {
 public:
  std::size_t size() const { return pictures_.size(); }
  /// Number i, counted from 0, as it is drawn.
  OrganismPicture operator[](std::size_t i) const;

 private:
  friend class PictureMaker;
  std::vector<OrganismPicture> pictures_;
  std::vector<ForceKind> kinds_;                   // of forces that are shown
  std::vector<std::vector<ForcesByKind>> forces_;  // [picture][cell]; empty: none are shown
  double lengthPerForce_ = 1;
};

/// Makes pictures of one world at one or more times.
class PictureMaker {
 public:
  /// Throws InputError for forces of a scenario whose integrator has none.
  PictureMaker(const Scenario& scenario, PictureWishes wishes);

  /// A picture of the world as it is now.
  void add(const World& world);
  /// The pattern of an opacity that fits no substance of any cell so far, if there is one.
  std::optional<std::string> strangeOpacity() const;
  /// All of them, in the order in which they were added.
  Pictures take();

 private:
  void scaleForces();
  void finishLegends();

  const Scenario& scenario_;
  PictureWishes wishes_;
  Pictures made_;
  std::vector<std::vector<std::optional<double>>> values_;
  std::vector<bool> opacityFits_;  // [of wishes_.opacities] a cell so far
  std::optional<World> scratch_;   // where forces are evaluated
};

/// Labels all cells of the world in its picture.
void addLabels(OrganismPicture& picture, const World& world, const Scenario& scenario, Labels labels);

/// Returns the colour of arrows for a kind of force.
Colour forceColour(ForceKind kind);

}  // namespace morula
