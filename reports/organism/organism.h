#pragma once
// The organism in three dimensions, drawn off-screen: no display, no window, no graphics card. Knows nothing
// of the simulator: cells with vertices and colours are all that it needs.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/vec3.h"
#include "drawing/annotations.h"
#include "mesh/mesh.h"
#include "organism/instruments.h"

namespace morula {

struct CellShape {
  std::string path;             // the lineage path; only used in messages
  std::vector<Point> vertices;  // [length] in the order that its faces count them
  Colour colour = neutralGrey;
  double opacity = 1;            // 0 (not drawn) to 1 (solid); lower: what is behind shines through
  std::vector<Face> faces{};     // its own mesh; empty: the picture's
  std::vector<double> shares{};  // of its vertices, for maps of something: 0 to 1 on the scale of
                                 // drawing/palette.h; empty: all have its colour
};

/// A straight line in space, for forces, normals and connections.
struct LineMark {
  Point from, to;  // [length]
  Colour colour;
  bool throughCells = false;  // also seen where cells stand before it
  bool arrow = false;         // with a head at `to`
};

/// A plane normal · x = offset, beyond which everything is cut away.
struct ClipPlane {
  Vector normal;      // any length but 0
  double offset = 0;  // [length · |normal|]
};

/// Words at a cell.
struct CellLabel {
  std::size_t cell = 0;  // its number in the picture, from 0
  std::string text;      // UTF-8
};

/// The part of space that fills the picture. Give all pictures of a sequence the same one and it does not jump.
struct Framing {
  Point centre;         // [length] what the eye looks at
  double distance = 1;  // [length] of the eye from the centre
};

struct Camera {
  Vector towardsEye{0.35, -1, 0.45};  // from the organism to the eye; any length but 0
  Vector up{0, 0, 1};                 // what is up in the picture; not parallel to towardsEye
  std::optional<Framing> framing;     // absent: fitFraming's
};

struct OrganismPicture {
  std::vector<Face> faces;  // the mesh of all cells that have none of their own
  std::vector<CellShape> cells;
  std::optional<Vector> shell;  // semi-axes [length] > 0, about the origin; a faint rim, 2 % outside
  std::vector<LineMark> lines;
  std::vector<CellLabel> labels;  // of cells that are seen, as many as have room; the caption says how many have not
  std::optional<ClipPlane> clip;  // of cells and lines; translucent cells are hollow. The shell stays whole.
  Instruments instruments;
  bool transparent = false;  // where nothing is drawn: no paper
  Camera camera;
  std::string title;    // top left; all texts are UTF-8
  std::string caption;  // one line under the title, for example time and cells
  std::vector<LegendEntry> legend;
  int width = 900, height = 900;  // [pixel] 16 to 8192; width · height · samples² at most 50 million
  int samples = 2;                // per pixel side, 1 to 4; higher: smoother edges, slower, more memory
};

enum class Style {
  solid,      // smooth lit surfaces, dark outlines where cells meet
  wireframe,  // the mesh's edges in the cells' colours, hidden ones hidden
};

inline const std::vector<Face>& facesOf(const OrganismPicture& picture, const CellShape& cell) {
  return cell.faces.empty() ? picture.faces : cell.faces;
}

/// Draws the picture; equal input gives equal pixels. No cells (an empty organism) give the background, shell
/// and texts. Throws InputError for sizes and opacities out of range, a cell whose vertex count does not fit
/// its faces or shares, shares out of range, a camera without a direction, and coordinates that are not finite.
Image drawOrganism(const OrganismPicture& picture, Style style = Style::solid);

/// Solid and wireframe side by side, 2·width × height.
Image drawSolidAndWireframe(const OrganismPicture& picture);

/// The nearest framing in which the shell is whole, or without a shell all cells that are drawn (opacity > 0);
/// and all lines.
Framing fitFraming(const OrganismPicture& picture);

/// One framing in which all of these pictures are whole. Throws InputError for none.
Framing fitFraming(const std::vector<OrganismPicture>& sequence);
/// Returns the framing of pictures that are made when they are needed, each twice.
Framing fitFraming(std::size_t count, const std::function<OrganismPicture(std::size_t)>& picture);

/// One framing in which the picture is whole from each of these sides: for an eye that goes around. Throws InputError
/// for none.
Framing commonFraming(const OrganismPicture& picture, const std::vector<Camera>& cameras);

/// [length] The mean of its vertices.
Point middleOf(const CellShape& cell);

/// [length] The mean distance of a vertex from its cell's middle, of the first `cells` of the picture; 1 without any.
double meanRadius(const OrganismPicture& picture, std::size_t cells);

/// The unit normals at a cell's vertices: means over their faces with the weights that are exact on a sphere,
/// sin(angle) / (product of the lengths of the two edges) [Max 1999].
std::vector<Vector> vertexNormals(const std::vector<Point>& vertices, const std::vector<Face>& faces);

/// Adds a line of this length along the normal of every vertex, as the thesis draws them.
void addNormals(OrganismPicture& picture, double length, Colour colour = {0x33, 0x66, 0xcc});

}  // namespace morula
