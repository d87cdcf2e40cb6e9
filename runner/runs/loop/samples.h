#pragma once
// The observer that records samples, surfaces and hashes of states (recorder.h).
#include "loop/observer.h"
#include "store/recorder.h"

namespace morula {

class Samples : public Observer {
 public:
  /// `sink` receives records during the run. Without a sink they are kept in memory.
  explicit Samples(RecordOptions options = {}, RecordSink sink = {}) : recorder_(std::move(options), std::move(sink)) {}

  /// Throws NumericalError if records that stay in memory take more than half of the memory limit.
  void see(const World& world) override;
  std::uint64_t stepsUntilDue(const World& world) const override { return recorder_.stepsUntilDue(world); }
  void resume(const World& world, const Resumed& earlier) override;

  const Recorder& recorder() const { return recorder_; }
  /// Everything recorded and still here, when the run has ended [Recorder::take].
  RunResults take(const World& world, const RunEnd& end) {
    return recorder_.take(world, end.status == RunStatus::failed);
  }

 private:
  Recorder recorder_;
};

}  // namespace morula
