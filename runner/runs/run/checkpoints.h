#pragma once
// The observer that keeps what a run can be resumed from, and what another run can go on from once this one has ended.
#include <cstdint>
#include <optional>
#include <string>

#include "loop/samples.h"
#include "pictures/pictures.h"
#include "store/store.h"

namespace morula {

class Checkpoints : public Observer {
 public:
  /// `samples` and `frames` are kept with the state, and observe before. `every` [steps]; 0: only when a signal ends the
  /// run.
  Checkpoints(Store& store, std::string id, const Samples& samples, const FrameCollector& frames, std::uint64_t every,
              bool quiet)
      : store_(store), id_(std::move(id)), samples_(samples), frames_(frames), every_(every), quiet_(quiet) {}

  void see(const World& world) override;
  std::uint64_t stepsUntilDue(const World& world) const override;
  void interrupted(const World& world) override { keep(world); }
  void resume(const World& world, const Resumed&) override { keepBeforeEnd(world); }
  /// True if the database holds a checkpoint that this run made.
  bool kept() const { return kept_; }
  /// Returns the last state that does not depend on the scene's stop, for runs with a later one; absent if the scene
  /// ended otherwise.
  const std::optional<Checkpoint>& beforeEnd() const { return beforeEnd_; }

 private:
  void keep(const World& world);
  void keepBeforeEnd(const World& world);
  Checkpoint checkpointOf(const World& world) const;

  Store& store_;
  std::string id_;
  const Samples& samples_;
  const FrameCollector& frames_;
  std::uint64_t every_;
  bool quiet_, kept_ = false;
  std::optional<Checkpoint> beforeEnd_;
  std::size_t born_ = 0;  // cells that had ever lived when beforeEnd_ was taken; 0 before
};

}  // namespace morula
