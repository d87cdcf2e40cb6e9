#pragma once
// The body of one cell, as its biology, its division and the measures may see it [Nilsson 2008, table 4.2].
#include <optional>

#include "mesh/mesh.h"

namespace morula {

/// A cell's shape, measured of its surface.
struct BodyShape {
  Mesh surface;   // [length] closed; of a sphere the mesh that it is drawn with
  Point centre;   // [length] the mean of the vertices, which carry the mass
  double volume;  // [length³] by the divergence theorem [Nilsson 2008, eq. 4.4]; of a sphere the ball's
  double area;    // [length²]; of a sphere the ball's
  // [force/length²] Inner minus outer at this volume [Nilsson 2008, eq. 4.3]; absent: without fluid under pressure.
  std::optional<double> pressure;
  bool isBall = false;  // it has no surface but that of a ball
  double sag = 0;       // [length] how far below its vertices the surface is that holds its volume; 0 of a sphere
};

class PhysicalUnit {
 public:
  virtual ~PhysicalUnit() = default;

  // Values that the last evaluation of the forces has left. They cost nothing.
  virtual double getMass() const = 0;    // [mass]
  virtual double getVolume() const = 0;  // [length³]
  /// [force/length²] Inner minus outer pressure [Nilsson 2008, eq. 4.3]; 0 without fluid under pressure.
  virtual double getPressure() const = 0;

  /// [length³] What its volume would be if nothing pressed on it: with fluid under pressure its share of
  /// the egg's, which divisions and growth have given it; otherwise that of its mesh with its rest lengths.
  virtual double getRestVolume() const = 0;
  /// [length³] That of its mesh with its rest lengths.
  virtual double getMeshVolume() const = 0;

  /// Measured when it is first asked for.
  virtual const BodyShape& getShape() const = 0;
};

}  // namespace morula
