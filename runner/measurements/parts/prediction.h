#pragma once
// Predicts the costs of a run, part by part: cells from the genes, steps and contacts from a trial run of its
// beginning, rates from this machine. Times are those of one thread.
#include <optional>
#include <string>
#include <vector>

#include "document/document.h"
#include "parts/parts.h"
#include "parts/trial_run.h"

namespace morula {

struct PartCost {
  Part part;
  std::optional<double> seconds;  // [s] of CPU time; none: too little to be told from the others
  std::optional<double> bytes;    // at the largest number of cells
  // Shares of the steps and what goes on between them; none of what has no time, or comes afterwards.
  std::optional<double> share = {}, nsPerVertexStep = {};
  std::optional<double> bytesPerVertex = {};  // of bodies
  bool afterwards = false;                    // once the cells have stopped: no share of the steps
};

struct Prediction {
  Life life;
  std::uint64_t cells = 0;  // the most that live at a time
  int vertices = 0;         // of the egg; 0 without bodies
  // The whole run, as it is predicted; exact as far as the trial run went.
  double steps = 0, vertexSteps = 0, pairs = 0, searches = 0;
  bool triedWhole = false;      // from beginning to end
  double triedTime = 0;         // [time] how far
  std::vector<PartCost> costs;  // of all parts that are engaged
  std::vector<Part> absent;
  std::vector<std::string> remarks;

  double seconds() const;  // [s] of the steps and all between them
  double bytes() const;
};

struct PredictionOptions {
  RunAsk ask = {};
  Execution execution = {};
  double trial = 8e6;                            // steps times vertices
  std::optional<double> secondsPerPicture = {};  // of those with bodies
};

/// Throws InputError and NumericalError as the run would.
Prediction predictCost(const Scenario& scenario, const PredictionOptions& options);

/// The scenario with physics.integrator fire, from rest to rest, whose cost may be predicted likewise. Absent: it
/// settles already, or has no bodies. Throws InputError with the keys that do not go with it.
std::optional<Scenario> settledInstead(const Scenario& scenario);

/// "350 ms", "12.5 s", "40 min".
std::string timeText(double seconds);

/// Make the tables of the parts' costs and of absent parts.
Table costTable(const Prediction& prediction);
Table absentTable(const Prediction& prediction);
/// For people.
Document describe(const Prediction& prediction, const std::string& title);

}  // namespace morula
