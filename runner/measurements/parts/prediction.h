#pragma once
// Predicts the costs of a run, part by part. Cells follow from the genes, steps and contacts from a trial run of its
// beginning, rates from this machine. Times are those of one thread.
#include <optional>
#include <string>
#include <vector>

#include "document/document.h"
#include "parts/binding_limit.h"
#include "parts/parts.h"
#include "parts/trial_run.h"

namespace morula {

struct PartCost {
  Part part;
  std::optional<double> seconds;  // [s] CPU time; absent: too little to be measured
  std::optional<double> bytes;    // memory at the largest number of cells
  // Share of the steps and the work between them; absent for parts without a time or after the steps.
  std::optional<double> share = {}, nsPerVertexStep = {};
  std::optional<double> bytesPerVertex = {};  // for parts with memory of bodies
  bool afterwards = false;                    // true: works after the last step, so it has no share of the steps
};

struct Prediction {
  Life life;
  std::uint64_t cells = 0;  // max number of living cells
  int vertices = 0;         // the egg's vertices; 0 without bodies
  // Counts of the whole run; exact as far as the trial run went
  double steps = 0, vertexSteps = 0, pairs = 0, searches = 0;
  bool triedWhole = false;      // true: the trial run reached the end
  double triedTime = 0;         // [time] end of the trial run
  std::vector<PartCost> costs;  // costs of all engaged parts
  std::vector<Part> absent;
  std::optional<BindingLimit> binding;  // of an automatic time step; at the end of the trial run
  std::vector<std::string> remarks;

  double seconds() const;  // [s] time of the steps and the work between them
  double bytes() const;
};

struct PredictionOptions {
  RunAsk ask = {};
  Execution execution = {};
  double trial = 8e6;                            // size of the trial run, in steps times vertices
  std::optional<double> secondsPerPicture = {};  // time of a picture with bodies
};

/// Predicts the costs. Throws InputError and NumericalError as the run would.
Prediction predictCost(const Scenario& scenario, const PredictionOptions& options);

/// Returns the scenario with physics.integrator quasi-static, which moves from rest to rest, so that its cost can be predicted,
/// too. Absent if it settles already or has no bodies. Throws InputError with the keys that exclude it.
std::optional<Scenario> settledInstead(const Scenario& scenario);

/// Returns a duration as "350 ms", "12.5 s", "40 min".
std::string timeText(double seconds);

/// costTable and absentTable return the tables of the parts' costs and of absent parts.
Table costTable(const Prediction& prediction);
Table absentTable(const Prediction& prediction);
/// Describes a prediction for people.
Document describe(const Prediction& prediction, const std::string& title);

}  // namespace morula
