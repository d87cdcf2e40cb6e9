#pragma once
// The properties of each cell model: one row of a table per model (cell_model.cpp). Code that depends on the model asks
// what its cells have, not which model it is. To add a model: its value and its name in
// parameters.h, a file with its row, a line in the table.
#include "physics/parameters.h"

namespace morula {

struct Bodies;
struct PhysicsKernels;
struct PhysicsStages;
struct StabilityLimits;

struct CellModelKind {
  // Parts that the model's cells have. A scenario gives no parameters of parts that they lack.
  bool hasMesh = true;        // the egg's surface; else one vertex, the centre of a sphere
  bool hasMembrane = false;   // springs along edges around a fluid: physics.membrane, physics.pressure
  bool hasRestShape = false;  // physics.shape-matching
  const char* limitedBy;      // name of the cause of StabilityLimits::spring, for people

  /// Sets the stages that find the inner forces [PhysicsStages]. `surfaces`: as in chooseStages.
  void (*chooseForces)(PhysicsStages&, const PhysicsKernels&, const PhysicsParameters&, bool surfaces);
  /// Returns the stability limits of one cell, as measureLimits does.
  StabilityLimits (*limits)(const Bodies&, int slot);
};

extern const CellModelKind shellCells, shapeMatchingCells, sphereCells;
const CellModelKind& kindOf(CellModel model);

}  // namespace morula
