// The error of a quasi-static scene: the distance from rest at the end of each settling.
#include "accuracy/accuracy.h"
#include "base/error.h"
#include "loop/simulate.h"

namespace morula {

Table measureSettlings(Scenario scenario, const Execution& how) {
  const Simulation run = simulate(scenario, how);
  requireEnough(run.end);
  if (run.end.status != RunStatus::done) throw InputError(scenario.file + ": " + run.end.failure);
  const std::vector<FieldOf<SettlingRecord>> fields{
      {{"step", "step", "step"}, [](const SettlingRecord& s) { return Cell(s.step); }},
      {{"time", "time", "time"}, [](const SettlingRecord& s) { return number(s.time); }},
      {{"cells", "cells", "cells"}, [](const SettlingRecord& s) { return Cell(s.cells); }},
      {{"evaluations", "evaluations", "evaluations"}, [](const SettlingRecord& s) { return Cell(s.evaluations); }},
      {{"residual", "residual", "residual"}, [](const SettlingRecord& s) { return number(s.residual, 2); }},
      {{"energy_left", "energy_left", "energy left"}, [](const SettlingRecord& s) { return number(s.energyLeft, 2); }},
      {{"displacement_left", "displacement_left", "Distance to rest of the farthest vertex"},
       [](const SettlingRecord& s) { return number(s.displacementLeft, 2); }}};
  return tableOf("Distance from rest at the end of settlings", fields, *run.world.settlings);
}

}  // namespace morula
