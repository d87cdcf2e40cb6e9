#pragma once
// The observer that keeps what a run can be resumed from.
#include <cstdint>
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
  /// True if the database holds a checkpoint that this run made.
  bool kept() const { return kept_; }

 private:
  void keep(const World& world);

  Store& store_;
  std::string id_;
  const Samples& samples_;
  const FrameCollector& frames_;
  std::uint64_t every_;
  bool quiet_, kept_ = false;
};

}  // namespace morula
