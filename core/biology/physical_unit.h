#pragma once
// The physics of one cell, as its biology may see it [Nilsson 2008, table 4.2]. Biology knows no more of physics.

namespace morula {

class PhysicalUnit {
 public:
  virtual ~PhysicalUnit() = default;
  virtual double getMass() const = 0;
  virtual double getVolume() const = 0;
  /// Inner minus outer pressure [Nilsson 2008, eq. 4.3].
  virtual double getPressure() const = 0;
};

}  // namespace morula
