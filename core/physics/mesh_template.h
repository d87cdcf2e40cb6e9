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

struct MeshTemplate {
  Mesh mesh;                        // the egg as loaded, in its size: what rest lengths refer to
  std::vector<std::int32_t> edges;  // [edge][2], first < second
  // [edge] [length] of the mesh as loaded [Nilsson 2008, §4.2.1]; one 0 behind the last
  std::vector<double> restLengths;
  std::vector<double> springWeights;    // [edge] [1] of k_s and k_d (Springs); empty: all 1
  double ringWeight = 6;                // [1] the most that the weights of a vertex' springs sum up to
  double unevenness = 1;                // [1] stability.h
  std::vector<std::int32_t> ringStart;  // [vertex + 1] into ring
  std::vector<RingStep> ring;           // TemplateView
  std::vector<double> ringShare;        // TemplateView
  double sag = 0;                       // [length] measureSag
  double volume = 0;                    // [length³]
  double restSquares = 0;               // [length²] sum over the springs of L₀² times the weight
  double meanRestLength = 0;            // [length]
  RestShape rest;                       // empty where no body is made by shape matching

  int vertexCount() const { return static_cast<int>(mesh.vertices.size()); }
  int edgeCount() const { return static_cast<int>(edges.size() / 2); }
  TemplateView view() const;
};

/// Expects a closed manifold (checkClosedManifold).
MeshTemplate makeTemplate(const Mesh& mesh, Springs springs = Springs::equal);

/// [length] How far inside the smooth surface through the vertices of a closed mesh the surface is that encloses its
/// volume. Of vertices on a sphere: its radius less that of the ball of this volume. Of others: the mean over all
/// vertices of −¼ U·n, with U from a vertex to the mean of its one-ring and the normal n, which is 1 to 4 % less on
/// icospheres; 0 at least.
double measureSag(const Mesh& mesh);

/// [edge] [1] √3 (cot α + cot β)/2, with the angles opposite of the edge: √3 times the length of its dual, between the
/// centres of both circumcircles, over its own. 1 where all triangles are equilateral. Then Σ w d dᵀ over the edges of
/// a mesh is √3 times its area in each direction of the surface, so springs that are stretched alike, l = λ L0, pull
/// with the tension √3 k_s (1 − 1/λ) everywhere [Pinkall & Polthier 1993]. Not less than 0.05: obtuse angles would give
/// springs that push.
std::vector<double> makeSpringWeights(const Mesh& mesh, const std::vector<std::int32_t>& edges);

/// The mesh encloses a volume.
RestShape makeRestShape(const Mesh& mesh);

/// A sphere's: its centre. Mean rest length: the diameter, so that spheres touch at the mean of theirs, as
/// vertices at the mean of their influence radii.
MeshTemplate makeCentre(double diameter);

}  // namespace morula
