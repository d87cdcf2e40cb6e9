#pragma once
// A body as the biology sees it [Nilsson 2008, table 4.2]. Another physics would offer another PhysicalUnit.
#include "biology/physical_unit.h"
#include "physics/bodies.h"

namespace morula {

class BodyUnit final : public PhysicalUnit {
 public:
  BodyUnit(const Bodies& bodies, int slot) : bodies_(bodies), slot_(slot) {}
  double getMass() const override { return bodies_.mass(slot_); }
  double getVolume() const override { return bodies_.volume[slot_]; }
  double getPressure() const override { return bodies_.pressure[slot_]; }

 private:
  const Bodies& bodies_;
  int slot_;
};

}  // namespace morula
