#pragma once
// The comparison of a run with a table of measured cells (morula run --against). It changes nothing in the run.
#include <map>
#include <string>
#include <vector>

#include "document/table.h"
#include "loop/observer.h"
#include "observation/organism_measures.h"
#include "scenario/scenario.h"
#include "tracks/measured.h"

namespace morula {

/// Observes the places of cells at the stages of a table. A stage at a time is compared with the first state at or
/// after this time, as samples are taken; where cells settle, with the state that holds then. A stage of n cells is
/// compared with the middle of the longest time in which exactly n cells live, to a hundredth of that.
class Against final : public Observer {
 public:
  /// `measured` must outlive the observer.
  explicit Against(const std::vector<tracks::MeasuredStage>& measured);
  void see(const World& world) override;
  std::uint64_t stepsUntilDue(const World& world) const override;
  /// Returns each stage of the table, compared, when the run has ended.
  std::vector<AgainstStage> take(const World& world);

 private:
  struct Moment {
    double time = 0;                                 // [time]
    std::vector<std::pair<CellPath, Point>> places;  // [length] of all living cells, by path
    std::optional<double> f1;                        // of contacts, if the table lists some
  };
  struct Longest {
    double duration = -1;  // [time]
    Moment middle;
  };
  Moment momentOf(const World& world, const tracks::MeasuredStage& stage) const;
  void seeTimes(const World& world);
  void closeStage(double end);
  static AgainstStage compare(const tracks::MeasuredStage& stage, const Moment& moment, std::uint64_t number);

  const std::vector<tracks::MeasuredStage>& measured_;
  std::map<const tracks::MeasuredStage*, Moment> found_;
  std::map<int, const tracks::MeasuredStage*> byCells_;
  std::vector<const tracks::MeasuredStage*> byTime_;  // rising
  std::size_t next_ = 0;                              // in byTime_
  // The present stage
  int cells_ = 0;
  double begin_ = 0;  // [time]
  std::uint64_t seen_ = 0, stride_ = 1;
  std::vector<Moment> kept_;  // each stride_-th state
  std::map<int, Longest> longest_;
};

/// Returns a stage in words: "8 cells", "48 min".
std::string stageWords(const AgainstStage& stage, const Units& units);
/// Returns the comparison for people, with `most` stages, and the number of further ones.
Table againstTable(const std::vector<AgainstStage>& stages, const Scenario& scenario, std::size_t most = 40);
/// Returns sentences on places in another unit than the scene, or in a frame that mirrors.
std::vector<std::string> againstRemarks(const std::vector<AgainstStage>& stages, const Units& units);
/// Returns the comparison as JSON, in the scene's units; cells by distance, the farthest first.
Json againstJson(const std::vector<AgainstStage>& stages, const Scenario& scenario);

}  // namespace morula
