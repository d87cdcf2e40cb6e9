#pragma once
// Pictures of a world as they are wished for: from where, what is added to the cells, what colours tell.
#include <optional>
#include <string>
#include <vector>

#include "diagnose/vertex_forces.h"
#include "pictures/cell_colours.h"

namespace morula {

/// How solid the cells are that have a substance which fits the pattern [biology/substance_pattern.h]; "*": all.
struct CellOpacity {
  std::string pattern;
  double opacity = 1;  // 0 to 1
};

enum class Labels { none, name, path };  // a cell without a name is labelled with its path

struct PictureWishes {
  Colouring colouring;
  Camera camera;
  int width = 900, height = 900, samples = 2;  // as OrganismPicture
  bool transparent = false;
  std::optional<ClipPlane> clip;
  bool normals = false, connections = false, axes = false, scaleBar = false;
  Labels labels = Labels::none;
  std::vector<CellOpacity> opacities;  // a later one counts more
  std::vector<ForceKind> forces;       // each once
};

/// Makes pictures of one world at one or more times. Those of several times share colours, legend and framing.
class PictureMaker {
 public:
  PictureMaker(const Scenario& scenario, PictureWishes wishes)
      : scenario_(scenario), wishes_(std::move(wishes)) {}

  /// A picture of the world as it is now, without forces.
  void add(const World& world);
  /// The wished forces in the picture that was added last, of this world.
  void addForces(World& world);
  /// All of them, in the order in which they were added.
  std::vector<OrganismPicture> take();

 private:
  const Scenario& scenario_;
  PictureWishes wishes_;
  std::vector<OrganismPicture> pictures_;
  std::vector<std::vector<std::optional<double>>> values_;
};

/// Of arrows for a kind of force.
Colour forceColour(ForceKind kind);

/// [length/force] so that the longest of the arrows of these kinds is `longest` [length] long; 1 where there is none.
double arrowScale(const std::vector<ForcesByKind>& forces, const std::vector<ForceKind>& kinds,
                  double longest);

}  // namespace morula
