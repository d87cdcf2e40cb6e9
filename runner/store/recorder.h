#pragma once
// Takes what is to be stored from a World while it runs, and nothing that was not asked for.
#include <optional>

#include "store/records.h"

namespace morula {

struct World;

class Recorder {
 public:
  /// `every` [time]: sample when the time reaches 0, every, 2·every, … and at the end; absent: no samples at
  /// all.
  explicit Recorder(std::optional<double> every = {}) : every_(every) {}

  /// Call once after makeWorld and once after every step. Costs one comparison unless a sample is due; a
  /// sample is taken at the first step at or after its time and carries the time of that step.
  void observe(const World& world);

  /// True if the last call of `observe` took a sample (for pictures over time).
  bool sampled() const { return sampled_; }

  /// The run has ended: everything recorded, with a last sample, the lineage, connections and changes of the
  /// time step. After a NumericalError pass `failed`: the broken state is then not measured.
  RunResults take(const World& world, bool failed = false);

 private:
  void sample(const World& world);

  std::optional<double> every_;
  std::uint64_t next_ = 0;  // number of the next due sample: due at time next_·every_
  bool sampled_ = false;
  std::vector<Sample> samples_;
};

}  // namespace morula
