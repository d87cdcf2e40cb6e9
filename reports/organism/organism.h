#pragma once
// The organism in three dimensions, drawn off-screen: no display, no window, no graphics card. Cells are vertices and
// colours; nothing here depends on the simulator.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/vec3.h"
#include "drawing/annotations.h"
#include "mesh/convex_shell.h"
#include "organism/instruments.h"

namespace morula {

struct CellShape {
  std::string path;             // the lineage path; only used in messages
  std::vector<Point> vertices;  // [length] in the order of the faces' numbers
  Colour colour = neutralGrey;
  double opacity = 1;            // 0 (not drawn) to 1 (solid)
  std::vector<Face> faces{};     // the cell's own mesh; empty: the picture's
  std::vector<double> shares{};  // one per vertex, for maps: 0 to 1 on scaleColour's scale;
                                 // empty: all vertices have the cell's colour
  bool isWall = false;           // the wall of a shell, which is not held by it (shell_wall.h)
};

/// A straight line in space, for forces, normals and connections.
struct LineMark {
  Point from, to;  // [length]
  Colour colour;
  bool throughCells = false;  // visible through cells in front
  bool arrow = false;         // with a head at `to`
};

/// A plane normal · x = offset; parts beyond the plane are cut away.
struct ClipPlane {
  Vector normal;      // any length but 0
  double offset = 0;  // [length · |normal|]
};

/// The label of a cell.
struct CellLabel {
  std::size_t cell = 0;  // index in the picture's cells
  std::string text;      // UTF-8
};

/// The part of space that fills the picture. A sequence of pictures with one framing does not jump.
struct Framing {
  Point centre;         // [length] the point that the eye looks at
  double distance = 1;  // [length] from the eye to the centre
};

struct Camera {
  Vector towardsEye{0.35, -1, 0.45};  // from the organism to the eye; any length but 0
  Vector up{0, 0, 1};                 // the picture's upward direction; not parallel to towardsEye
  std::optional<Framing> framing;     // absent: fitFraming's
};

struct OrganismPicture {
  std::vector<Face> faces;  // the mesh of all cells without their own
  std::vector<CellShape> cells;
  std::optional<Vector> shell;  // semi-axes [length] > 0, about the origin; a faint rim, 2 % outside
  std::vector<ShellPlane> shellPlanes;  // of a shell that is a mesh, and drawn as a cell; as `shell`, it holds the cells
                                        // in it: they are drawn inside (shell_wall.h)
  std::vector<LineMark> lines;
  std::vector<CellLabel> labels;  // for visible cells, as many as fit; the caption counts the missing ones
  std::optional<ClipPlane> clip;  // cuts cells and lines; translucent cells are hollow. The shell stays whole.
  Instruments instruments;
  bool transparent = false;  // no paper where nothing is drawn
  Camera camera;
  std::string title;    // top left; all texts are UTF-8
  std::string caption;  // one line under the title, for example time and cells
  std::vector<LegendEntry> legend;
  int width = 900, height = 900;  // [pixel] 16 to 8192; width · height · samples² at most 50 million
  Print print = {};
  int samples = 2;  // per pixel side, 1 to 4; higher: smoother edges, slower, more memory
};

enum class Style {
  solid,      // smooth lit surfaces, dark outlines between cells
  wireframe,  // the mesh's edges in the cells' colours; hidden edges are hidden
};

inline const std::vector<Face>& facesOf(const OrganismPicture& picture, const CellShape& cell) {
  return cell.faces.empty() ? picture.faces : cell.faces;
}

/// Draws the picture; equal input gives equal pixels. An organism without cells gives background, shell and text.
/// Throws InputError for sizes, opacities and shares out of range, a cell whose vertex count does not fit its faces or
/// shares, a camera without a direction, and coordinates that are not finite.
Image drawOrganism(const OrganismPicture& picture, Style style = Style::solid);

/// Draws one scene for each style, side by side, with one title, caption and legend: words are text, the scenes pixels.
Drawing organismDrawing(const OrganismPicture& picture, const std::vector<Style>& styles);

/// Returns the nearest framing that contains all lines, and the shell or, without a shell, all visible cells.
Framing fitFraming(const OrganismPicture& picture);

/// Returns one framing that contains all of these pictures. Throws InputError if there is none.
Framing fitFraming(const std::vector<OrganismPicture>& sequence);
/// Returns the framing of pictures that `picture` makes on demand, each twice.
Framing fitFraming(std::size_t count, const std::function<OrganismPicture(std::size_t)>& picture);

/// Returns one framing that contains the picture from each of these cameras. Throws InputError if there is none.
Framing commonFraming(const OrganismPicture& picture, const std::vector<Camera>& cameras);

/// Returns the mean of the cell's vertices [length].
Point middleOf(const CellShape& cell);

/// Returns the mean distance [length] of a vertex from its cell's middle, over the first `cells` cells; 1 without any.
double meanRadius(const OrganismPicture& picture, std::size_t cells);

/// Returns the unit normals at a cell's vertices: means over their faces with the weights that are exact on a sphere,
/// sin(angle) / (product of the lengths of the two edges) [Max 1999].
std::vector<Vector> vertexNormals(const std::vector<Point>& vertices, const std::vector<Face>& faces);

/// Adds a line of this length along the normal of every vertex.
void addNormals(OrganismPicture& picture, double length, Colour colour = {0x33, 0x66, 0xcc});

}  // namespace morula
