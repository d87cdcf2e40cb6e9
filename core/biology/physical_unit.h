#pragma once
// The body of one cell, as its biology, its division and the measures may see it [Nilsson 2008, table 4.2].
#include <optional>

#include "mesh/mesh.h"

namespace morula {

/// A cell's shape, measured on its surface.
struct BodyShape {
  Mesh surface;   // [length] closed; for a sphere the mesh that draws it
  Point centre;   // [length] the mean of the vertices, which carry the mass
  double volume;  // [length³] by the divergence theorem [Nilsson 2008, eq. 4.4]; for a sphere the ball's
  double area;    // [length²]; for a sphere the ball's
  // [force/length²] Inner minus outer at this volume [Nilsson 2008, eq. 4.3]; absent: without fluid under pressure.
  std::optional<double> pressure;
  bool isBall = false;  // the cell has no surface but that of a ball
  double sag = 0;       // [length] depth below the vertices of the surface that holds the volume; 0 for a sphere
};

class PhysicalUnit {
 public:
  virtual ~PhysicalUnit() = default;

  // Values that the last evaluation of the forces has left. They cost nothing.
  virtual double getMass() const = 0;    // [mass]
  virtual double getVolume() const = 0;  // [length³]
  /// Returns inner minus outer pressure [force/length²] [Nilsson 2008, eq. 4.3]; 0 without fluid under pressure.
  virtual double getPressure() const = 0;

  /// Returns the volume [length³] that the cell would have if nothing pressed on it. With fluid under pressure: its
  /// share of the egg's, as divisions and growth gave it. Otherwise: the volume of its mesh with its rest lengths.
  virtual double getRestVolume() const = 0;
  /// Returns the volume [length³] of the cell's mesh with its rest lengths.
  virtual double getMeshVolume() const = 0;

  /// Returns the shape, measured on first request.
  virtual const BodyShape& getShape() const = 0;
};

}  // namespace morula
