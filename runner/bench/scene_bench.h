#pragma once
// All rows of one packed scene: which measurements it calls for, taken in turn, round after round.
#include "bench/bench.h"
#include "bench/bullet_subject.h"
#include "bench/subject.h"
#include "bench/work.h"

namespace morula {

/// A row without its shares, for which the machine's limits must be known; and what they follow from.
struct MeasuredRow {
  BenchRow row;
  std::optional<Work> work;  // per vertex and step
};

class SceneBench {
 public:
  /// `whole`: with all that it is compared with. Otherwise only what this variant of a scene changes.
  SceneBench(const BenchOptions& options, const PackedScene& packed, std::string name, bool whole);

  void round();
  std::vector<MeasuredRow> rows() const;

 private:
  /// One row while it is measured: its samples, [s] per vertex and step.
  struct Series {
    BenchRow row;
    std::vector<double> samples;
    std::vector<double> searches;  // step: of the searches that its samples leave out
  };
  bool wants(Stage stage) const;
  bool needsSteps() const { return wants(Stage::step) || wants(Stage::rebuild); }
  Series& series(const std::string& engine, Stage stage, const std::string& isa, int threads = 1,
                 bool wall = false, const std::string& search = "");
  void measureStages(Isa isa);
  void measureSearches();
  void measureSteps();
  void measureThreads();
  BenchRow rowOf(const std::string& engine, Stage stage) const;
  BulletSubject bulletSubject(Baseline baseline) const;
  double pairsPerVertex() const;
  double rebuildsPerStep() const;
  Work workOf(Stage stage) const;
  void finish(const Series& series, std::vector<MeasuredRow>& rows) const;
  void finish(const BulletSubject& subject, Baseline baseline, std::vector<MeasuredRow>& rows) const;

  const BenchOptions& options_;
  PackedScene packed_;
  std::string name_;
  bool whole_, everyStage_;
  std::vector<Isa> isas_;
  Subject subject_;
  int steps_;  // of a round
  std::vector<Series> all_;
  std::vector<std::pair<Baseline, BulletSubject>> bullets_;
};

}  // namespace morula
