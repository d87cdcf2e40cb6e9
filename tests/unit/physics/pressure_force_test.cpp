// The pressure force is P times the volume's gradient, and pushes a closed mesh nowhere [Nilsson 2008,
// eq. 4.3–4.5].
#include "catch.h"
#include "lab.h"

using namespace morula;

namespace {

PhysicsParameters gasOnly() {
  PhysicsParameters p = softCell();
  p.membrane.stiffness = 0;
  p.membrane.damping = 0;
  p.pressure = {4, 0.7};
  return p;
}

/// dV/dx of one component of one vertex by central differences. V is of third degree in all components but
/// linear in each one, so the difference is exact but for rounding, whatever the step.
double slopeOfVolume(std::vector<Point> x, const Mesh& mesh, int v, double Point::*component) {
  const double h = 0.125, at = x[v].*component;
  x[v].*component = at + h;
  const double above = measureVolume(x, mesh.faces);
  x[v].*component = at - h;
  return (above - measureVolume(x, mesh.faces)) / (2 * h);
}

}  // namespace

TEST_CASE("Pressure is that of an ideal gas") {
  for (const auto& [name, mesh, handles] : zoo::all()) {
    INFO(name);
    const Lab lab = evaluated({gasOnly(), mesh});
    CHECK(lab.bodies.pressure[0] == Approx(4 / zoo::volumeOf(mesh) - 0.7).epsilon(1e-12));
  }
}

TEST_CASE("The pressure force on each vertex is P dV/dx") {
  for (const auto& [name, mesh, handles] : zoo::all()) {
    INFO(name);
    const Lab lab = evaluated({gasOnly(), mesh});
    const double pressure = lab.bodies.pressure[0];
    Worst largest, error;
    for (int v = 0; v < lab.bodies.vertexCount(); v += 1 + lab.bodies.vertexCount() / 50) {
      const Vector f = lab.force(0, v);
      const Vector expected = pressure * Vector{slopeOfVolume(mesh.vertices, mesh, v, &Point::x),
                                                slopeOfVolume(mesh.vertices, mesh, v, &Point::y),
                                                slopeOfVolume(mesh.vertices, mesh, v, &Point::z)};
      largest.see(norm(expected));
      error.see(norm(f - expected));
    }
    CHECK(error <= 1e-11 * largest);
  }
}

TEST_CASE("Each face of a vertex gives it a third of the pressure on that face") {
  const Mesh mesh = zoo::crumpled(makeIcosphere(1), 0.2, 5);
  const Lab lab = evaluated({gasOnly(), mesh});
  std::vector<Vector> expected(mesh.vertices.size());
  for (const auto& [a, b, c] : mesh.faces) {
    const Vector area = 0.5 * cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
    for (int v : {a, b, c}) expected[v] += (lab.bodies.pressure[0] / 3) * area;
  }
  for (int v = 0; v < lab.bodies.vertexCount(); ++v) CHECK(norm(lab.force(0, v) - expected[v]) < 1e-14);
}

TEST_CASE("The pressure forces of a closed mesh sum to rounding, and so do their moments") {
  for (const auto& [name, mesh, handles] : zoo::all()) {
    INFO(name);
    const Lab lab = evaluated({gasOnly(), mesh});
    Vector sum, moment;
    double size = 0;
    const Point centre = measureCentroid(mesh.vertices);
    for (int v = 0; v < lab.bodies.vertexCount(); ++v) {
      sum += lab.force(0, v);
      moment += cross(mesh.vertices[v] - centre, lab.force(0, v));
      size += norm(lab.force(0, v));
    }
    const double extent = norm(measureBox(mesh.vertices).high - measureBox(mesh.vertices).low);
    const double rounding =
        name == "far away" ? 1e-12 : 1e-14;  // coordinates of 3000 leave fewer digits to differences
    CHECK(norm(sum) <= rounding * size);
    CHECK(norm(moment) <= rounding * size * extent);
  }
}
