#pragma once
// Takes what is to be stored from a World while it runs, and nothing that was not asked for.
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/multiples.h"
#include "store/records.h"

namespace morula {

struct World;

struct RecordOptions {
  std::optional<double> every{};  // [time] sample at 0, every, 2·every, … and at the end; absent: at the start
                                  // and at the end only
  std::optional<std::uint64_t> hashEvery{};  // [steps] a link of the chain of hashes at step 0, hashEvery, …
                                             // and at the end; absent: none
  bool hashEnd = false;                      // without hashEvery: one link, at the end
  std::vector<std::uint64_t> atCells{};      // rising; also when so many cells live for the first time
  bool atDivisions = false;                  // also after each step in which cells divided
  std::vector<std::string> measures{};       // on demand, at every sample
  std::optional<Reference> reference{};      // that some of them compare with
  /// Returns the name of a cell; empty: cells go by their paths. Only recorded names depend on it.
  std::function<std::optional<std::string>(const CellPath&)> nameOf{};
  // For cells with bodies
  std::optional<double>
      meshes{};  // [time] a sample with all surfaces at 0, meshes, 2·meshes, …, where atCells asks for
                 // one, and at the end; absent: none
  std::vector<double> meshesAt{};  // [time] rising; also a sample with all surfaces at each
};

class Recorder {
 public:
  /// `sink` receives records now and then, so that their memory does not grow with the run. Without a sink they are
  /// kept until `take`. `enough` [byte]: it goes when it is so much.
  explicit Recorder(RecordOptions options = {}, RecordSink sink = {}, double enough = 1 << 20)
      : options_(std::move(options)),
        sink_(std::move(sink)),
        enough_(enough),
        every_(options_.every),
        meshes_(options_.meshes) {}

  /// Call once after makeWorld and once after every step. Costs two comparisons unless something is due; a
  /// sample is taken at the first step at or after its time and carries the time of that step.
  void observe(const World& world);

  /// After how many steps `observe` has something to do; 1 at least. It need not be called in between.
  std::uint64_t stepsUntilDue(const World& world) const;

  /// Goes on with what was recorded before the world was stopped, in parts or as a whole: samples and hashes up to its
  /// step, apart from a sample that was taken only because the run was stopped. States of cells are those of this
  /// world.
  void resume(const World& world, const RunResults& earlier);

  /// True if the last call of `observe` took a sample (for pictures over time).
  bool sampled() const { return sampled_; }
  /// The samples that are still here.
  const std::vector<Sample>& samples() const { return results_.samples; }
  const std::vector<ChainLink>& chain() const { return results_.chain; }
  /// [byte] That samples and hashes take here.
  double bytes() const { return bytes_; }
  const RecordOptions& options() const { return options_; }
  /// True if what has been recorded goes elsewhere, where it stays when the run fails.
  bool hasSink() const { return static_cast<bool>(sink_); }
  /// Samples and hashes that are still here, with the texts of the states in them; nothing else yet.
  const RunResults& records() const { return results_; }

  /// The run has ended: everything recorded and still here, with a last sample, the lineage, connections and changes of
  /// the time step. After a NumericalError pass `failed`: the broken state is then not measured. The recorder is
  /// empty afterwards.
  RunResults take(const World& world, bool failed = false);

 private:
  void sample(const World& world, bool withSurfaces);
  void keepSurfaces(const World& world, Sample& sample);
  void hash(const World& world);
  /// A sample at `time` [time] sees these contacts, by (a, b). Does nothing unless contact_duration is asked for.
  void keepTouching(const std::vector<ContactMeasures>& contacts, double time);
  void describe(const World& world, StateId state);
  /// Before something is added. What is of the last step stays here: `take` may add surfaces to it.
  void pour();
  void add(Sample sample);
  void add(ChainLink link);
  bool isDue(double time) const { return options_.every ? every_.isDue(time) : isAtStart_; }
  void expectNext(double time) { every_.pass(time), isAtStart_ = false; }
  bool surfacesAreDue(double time) const;
  void expectNextSurfaces(double time);
  /// True if `cells` is a number to look for, or more, for the first time.
  bool reaches(std::uint64_t cells);
  /// True if cells have divided since the last call, and atDivisions asks.
  bool divided(const World& world);

  RecordOptions options_;
  RecordSink sink_;
  double enough_;
  Schedule every_, meshes_;    // when samples, and samples with surfaces, are due
  bool isAtStart_ = true;      // no sample has been taken
  std::size_t nextAt_ = 0;     // of meshesAt
  std::size_t reached_ = 0;    // of atCells
  std::size_t divisions_ = 0;  // that have been seen
  bool sampled_ = false;
  double bytes_ = 0;
  RunResults results_;
  std::optional<Hash> lastLink_;
  // Since when [time] the pairs of the last sample touch, for contact_duration: it follows from the samples.
  std::map<std::pair<CellPath, CellPath>, double> touchingSince_;
};

/// How a run ended, read off its world. `failure`: the NumericalError's text for a failed run, which has no state hash.
RunEnd endOf(const World& world, RunStatus status, const std::string& failure = {}, Want want = Want::nothing);

}  // namespace morula
