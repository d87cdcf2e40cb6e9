#pragma once
// The mesh that all cells of a scene share: connectivity and rest lengths, laid out for the kernels.
#include <array>
#include <cstdint>
#include <vector>

#include "mesh/mesh.h"
#include "physics/block.h"
#include "physics/parameters.h"

namespace morula {

/// The mesh at rest as shape matching needs it.
struct RestShape {
  std::vector<double> vertices;     // [vertex][xyz] from their mean [length]
  std::array<double, 6> inverse{};  // (Σ q qᵀ)⁻¹: xx xy xz yy yz zz [1/length²]
  double volume = 0;                // [length³]
};

/// The mesh at rest as bending needs it (bending_kernel.h).
struct Bending {
  std::vector<double> weights;       // [as ring] [1] w; 0 for a repeated neighbour
  std::vector<double> inverseAreas;  // [vertex] [1/length²] 1/a
  double stiffest = 0;               // [1/length²] largest stiffness of all vertices together for κ = 1
};

struct MeshTemplate {
  Mesh mesh;                        // the egg as loaded, in its size: what rest lengths refer to
  std::vector<std::int32_t> edges;  // [edge][2], first < second
  // [edge] [length] of the mesh as loaded [Nilsson 2008, §4.2.1]; one 0 behind the last
  std::vector<double> restLengths;
  std::vector<double> springWeights;    // [edge] [1] of k_s and k_d (Springs); empty: all 1
  double ringWeight = 6;                // [1] max sum of the weights of a vertex' springs
  double unevenness = 1;                // [1] stability.h
  std::vector<std::int32_t> ringStart;  // [vertex + 1] into ring
  std::vector<RingStep> ring;           // TemplateView
  std::vector<double> ringShare;        // TemplateView
  double sag = 0;                       // [length] measureSag
  double volume = 0;                    // [length³]
  double restSquares = 0;               // [length²] sum over the springs of L₀² times the weight
  double meanRestLength = 0;            // [length]
  RestShape rest;                       // empty without shape matching
  Bending bending;                      // empty without bending

  int vertexCount() const { return static_cast<int>(mesh.vertices.size()); }
  int edgeCount() const { return static_cast<int>(edges.size() / 2); }
  TemplateView view() const;
};

/// Makes the template of a closed manifold (checkClosedManifold).
MeshTemplate makeTemplate(const Mesh& mesh, Springs springs = Springs::equal);

/// Measures how far [length] the surface that encloses a closed mesh's volume lies inside of the smooth surface through
/// its vertices. For vertices on a sphere: its radius minus the radius of the ball of this volume. Else: the mean over
/// all vertices of −¼ U·n, with U from a vertex to the mean of its one-ring and the normal n, which is 1 to 4 % less on
/// icospheres; at least 0.
double measureSag(const Mesh& mesh);

/// Returns the springs' weights [edge] [1], √3 (cot α + cot β)/2 with the angles opposite the edge: √3 times the length
/// of its dual, between the centres of both circumcircles, over its own. 1 where all triangles are equilateral. Then Σ
/// w d dᵀ over the edges of a mesh is √3 times its area in each direction of the surface, so springs stretched alike, l
/// = λ L0, pull with the tension √3 k_s (1 − 1/λ) everywhere [Pinkall & Polthier 1993]. At least 0.05: obtuse angles
/// would give springs that push.
std::vector<double> makeSpringWeights(const Mesh& mesh, const std::vector<std::int32_t>& edges);

/// Makes the shape at rest of a mesh, which must enclose a volume.
RestShape makeRestShape(const Mesh& mesh);

/// Makes the mesh at rest as bending needs it, with the weights of makeSpringWeights over √3.
Bending makeBending(const MeshTemplate& mesh);

/// Makes the template of a sphere, its centre. The mean rest length is the diameter, so that spheres touch at the mean
/// of their diameters, as vertices touch at the mean of their influence radii.
MeshTemplate makeCentre(double diameter);

}  // namespace morula
