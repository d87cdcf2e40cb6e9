#pragma once
// A cell that knows only what a test gives: its shape, its mother's division, its contacts, its substances and its
// place.
#include "biology/physical_unit.h"
#include "division/division_record.h"
#include "division/policy.h"
#include "mesh/mesh_measures.h"

namespace morula {

class KnownCell final : public CellContext, PhysicalUnit {
 public:
  KnownCell(const char* name, Points vertices, Faces faces = {}) {
    path = CellPath::parse(name);
    shape_.surface = {{vertices.begin(), vertices.end()}, {faces.begin(), faces.end()}};
    shape_.centre = measureCentroid(vertices);
    if (!faces.empty()) shape_.volume = measureVolume(vertices, faces);
  }
  KnownCell(const char* name, const Mesh& mesh) : KnownCell(name, mesh.vertices, mesh.faces) {}
  const PhysicalUnit* physical() const override { return this; }
  const DivisionRecord* motherDivision() const override { return mother ? &*mother : nullptr; }
  std::string substances() const override { return held; }
  std::span<const Neighbour> neighbours() const override { return touched; }
  std::span<const CellContext* const> connected() const override { return holdsOnTo; }
  std::optional<Vector> shell() const override { return semiAxes; }
  std::optional<Vector> nearestShellNormal() const override { return faceNormal; }
  Point organismCentre() const override { return middle; }
  const Vector* inheritedPolarity() const override { return polarity ? &*polarity : nullptr; }

  std::optional<DivisionRecord> mother;
  std::string held;
  std::vector<Neighbour> touched;
  std::vector<const CellContext*> holdsOnTo;
  std::optional<Vector> semiAxes, faceNormal, polarity;
  Point middle;

 private:
  double getMass() const override { return 1; }
  double getVolume() const override { return 1; }
  double getPressure() const override { return 0; }
  double getRestVolume() const override { return 1; }
  double getMeshVolume() const override { return 1; }
  const BodyShape& getShape() const override { return shape_; }
  BodyShape shape_{};
};

}  // namespace morula
