#pragma once
// Takes the records of a World while it runs, and only those that were asked for.
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
  std::vector<std::uint64_t> atCells{};      // rising; a further sample when so many cells live for the first time
  bool atDivisions = false;                  // true: a further sample after each step in which cells divided
  std::vector<std::string> measures{};       // measures that every sample takes on demand
  std::optional<Reference> reference{};      // the reference of measures that compare with one
  /// Returns the name of a cell; empty: cells go by their paths. Only recorded names depend on it.
  std::function<std::optional<std::string>(const CellPath&)> nameOf{};
  // The surfaces of cells with bodies
  std::optional<double>
      meshes{};  // [time] a sample with all surfaces at 0, meshes, 2·meshes, …, where atCells asks for
                 // one, and at the end; absent: none
  std::vector<double> meshesAt{};  // [time] rising; a further sample with all surfaces at each
};

class Recorder {
 public:
  /// `sink` receives records now and then, so that their memory does not grow with the run. Without a sink they are
  /// kept until `take`. `enough`: the amount of records [byte] that is given to the sink.
  explicit Recorder(RecordOptions options = {}, RecordSink sink = {}, double enough = 1 << 20)
      : options_(std::move(options)),
        sink_(std::move(sink)),
        enough_(enough),
        every_(options_.every),
        meshes_(options_.meshes) {}

  /// Records the world if something is due. Call it once after makeWorld and once after every step. If nothing is due
  /// it costs two comparisons. A sample is taken at the first step at or after its time and carries that step's time.
  void observe(const World& world);

  /// Returns the number of steps, at least 1, until `observe` has something to do. Calls before can be left out.
  std::uint64_t stepsUntilDue(const World& world) const;

  /// Restores the records made before the world was stopped, in parts or as a whole: samples and hashes up to its step.
  /// A sample that was taken only because the run was stopped is left out. `world` describes the states of cells.
  void resume(const World& world, const RunResults& earlier);

  /// True if the last call of `observe` took a sample (for pictures over time).
  bool sampled() const { return sampled_; }
  /// Returns the samples that the sink has not received.
  const std::vector<Sample>& samples() const { return results_.samples; }
  const std::vector<ChainLink>& chain() const { return results_.chain; }
  /// Returns the memory of samples and hashes that the sink has not received [byte].
  double bytes() const { return bytes_; }
  const RecordOptions& options() const { return options_; }
  /// Returns true if records go to a sink, where they stay when the run fails.
  bool hasSink() const { return static_cast<bool>(sink_); }
  /// Returns samples and hashes that the sink has not received, with the texts of the states in them, and nothing else.
  const RunResults& records() const { return results_; }

  /// Ends the recording. Returns all records that the sink has not received, with a last sample, the lineage,
  /// connections and changes of the time step. `failed`: after a NumericalError, so the broken state is not measured.
  /// The recorder is empty afterwards.
  RunResults take(const World& world, bool failed = false);

 private:
  void sample(const World& world, bool withSurfaces);
  void keepSurfaces(const World& world, Sample& sample);
  void hash(const World& world);
  /// Notes the contacts of a sample at `time` [time], sorted by (a, b). Does nothing unless contact_duration is asked
  /// for.
  void keepTouching(const std::vector<ContactMeasures>& contacts, double time);
  void describe(const World& world, StateId state);
  /// Gives records to the sink if there are enough; called before each addition. So the records of the last step stay,
  /// and `take` can add surfaces to them.
  void pour();
  void add(Sample sample);
  void add(ChainLink link);
  bool isDue(double time) const { return options_.every ? every_.isDue(time) : isAtStart_; }
  void expectNext(double time) { every_.pass(time), isAtStart_ = false; }
  bool surfacesAreDue(double time) const;
  void expectNextSurfaces(double time);
  /// Returns true if `cells` reaches a number of atCells for the first time.
  bool reaches(std::uint64_t cells);
  /// Returns true if atDivisions is set and cells have divided since the last call.
  bool divided(const World& world);

  RecordOptions options_;
  RecordSink sink_;
  double enough_;
  Schedule every_, meshes_;    // when samples, and samples with surfaces, are due
  bool isAtStart_ = true;      // no sample has been taken
  std::size_t nextAt_ = 0;     // the next time in meshesAt
  std::size_t reached_ = 0;    // how many numbers of atCells have been reached
  std::size_t divisions_ = 0;  // entries of the lineage at the last look for divisions
  bool sampled_ = false;
  double bytes_ = 0;
  RunResults results_;
  std::optional<Hash> lastLink_;
  // The time [time] since when each pair of the last sample touches, for contact_duration; it follows from the samples.
  std::map<std::pair<CellPath, CellPath>, double> touchingSince_;
};

/// Returns the end of a run. `failure`: the text of its NumericalError; a failed run has no state hash.
RunEnd endOf(const World& world, RunStatus status, const std::string& failure = {}, Want want = Want::nothing);

}  // namespace morula
