#pragma once
// A cell of which just its shape and its mother's division are known.
#include "biology/physical_unit.h"
#include "division/policy.h"
#include "division/record.h"
#include "mesh/measures.h"

namespace morula {

class KnownCell final : public CellContext, PhysicalUnit {
 public:
  KnownCell(const char* name, Points vertices, Faces faces = {}) {
    path = CellPath::parse(name);
    shape_.surface = {{vertices.begin(), vertices.end()}, {faces.begin(), faces.end()}};
    shape_.centre = measureCentroid(vertices);
  }
  std::string substances() const override { return held; }
  const PhysicalUnit* physical() const override { return this; }
  const DivisionRecord* motherDivision() const override { return mother ? &*mother : nullptr; }

  std::string held;  // its substances
  std::optional<DivisionRecord> mother;

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
