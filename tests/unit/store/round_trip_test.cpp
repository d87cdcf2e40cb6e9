// Values written to a file come back to the last bit.
#include <bit>
#include <cmath>

#include "catch.h"
#include "example_run.h"

using namespace morula;

namespace {

bool sameBits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

/// Returns true if both values have the same bits, or both are absent.
bool sameBits(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? sameBits(*a, *b) : a == b;
}

template <class Of>
void requireSame(const Measured<Of>& a, const Measured<Of>& b) {
  for (std::size_t i = 0; i < sampledMeasures<Of>().size(); ++i) {
    INFO(sampledMeasures<Of>()[i].name);
    REQUIRE(sameBits(a.values[i], b.values[i]));
  }
}

struct Stored : ResultsFile {
  std::string id;
  explicit Stored(const RunResults& results, const RunRecord& record = exampleRecord()) : id(store.begin(record)) {
    store.finish(id, exampleEnd(), results);
    store = Store::openForReading(file);
  }
};

}  // namespace

TEST_CASE("a run's row comes back") {
  const RunRecord record = exampleRecord();
  Stored stored(exampleResults());
  const std::vector<StoredRun> runs = stored.store.runs();
  REQUIRE(runs.size() == 1);
  const StoredRun& run = runs[0];
  REQUIRE(run.id == runId(record));
  REQUIRE(run.id.size() == 16);
  REQUIRE(run.status == RunStatus::done);
  REQUIRE(run.stateHash == exampleEnd().stateHash->text());
  REQUIRE(run.steps == 700);
  REQUIRE(run.cells == 1);
  REQUIRE(sameBits(run.time, 0.1 + 0.2));
  REQUIRE(run.failure.empty());
  REQUIRE(run.started.size() == 20);
  REQUIRE(run.ended >= run.started);
  REQUIRE(run.record.scenario == record.scenario);
  REQUIRE(run.record.command == record.command);
  REQUIRE(run.record.isa == "avx2");
  REQUIRE(run.record.threads == 2);
  REQUIRE(run.record.build.libraries == record.build.libraries);
  for (const auto& [column, label, before, now] : compareConditions(record, run.record)) {
    INFO(column);
    REQUIRE(before == now);
  }
  REQUIRE(stored.store.documents(run.id) == record.documents);
}

TEST_CASE("a seed beyond SQLite's integers comes back") {
  RunRecord record = exampleRecord();
  record.seed = 0xfedcba9876543210u;
  Stored stored({}, record);
  REQUIRE(stored.store.find("").record.seed == record.seed);
}

TEST_CASE("every table comes back") {
  const RunResults in = exampleResults();
  Stored stored(in);
  const RunResults out = stored.store.results(stored.id);

  REQUIRE(out.lineage.size() == in.lineage.size());
  for (std::size_t i = 0; i < in.lineage.size(); ++i) {
    const LineageEntry &a = in.lineage[i], &b = out.lineage[i];
    REQUIRE(a.path == b.path);
    REQUIRE(sameBits(a.born, b.born));
    REQUIRE(sameBits(a.ended, b.ended));
    REQUIRE(a.bornStep == b.bornStep);
    REQUIRE(a.endedStep == b.endedStep);
    REQUIRE(a.fate == b.fate);
    REQUIRE(in.stateTexts.at(a.state) == out.stateTexts.at(b.state));
  }
  REQUIRE(out.names == in.names);

  REQUIRE(out.samples.size() == in.samples.size());
  for (std::size_t i = 0; i < in.samples.size(); ++i) {
    const WorldMeasures &a = in.samples[i].world, &b = out.samples[i].world;
    REQUIRE(sameBits(a.time, b.time));
    REQUIRE(a.step == b.step);
    requireSame(a, b);
    REQUIRE(in.samples[i].cells.size() == out.samples[i].cells.size());
    for (std::size_t c = 0; c < in.samples[i].cells.size(); ++c) {
      const CellMeasures &m = in.samples[i].cells[c], &n = out.samples[i].cells[c];
      REQUIRE(m.path == n.path);
      REQUIRE(in.stateTexts.at(m.state) == out.stateTexts.at(n.state));
      requireSame(m, n);
    }
    REQUIRE(in.samples[i].contacts.size() == out.samples[i].contacts.size());
    for (std::size_t c = 0; c < in.samples[i].contacts.size(); ++c) {
      REQUIRE(in.samples[i].contacts[c].a == out.samples[i].contacts[c].a);
      REQUIRE(in.samples[i].contacts[c].b == out.samples[i].contacts[c].b);
      requireSame(in.samples[i].contacts[c], out.samples[i].contacts[c]);
    }
  }

  REQUIRE(out.connections.size() == in.connections.size());
  for (std::size_t i = 0; i < in.connections.size(); ++i) {
    REQUIRE(out.connections[i].a == in.connections[i].a);
    REQUIRE(out.connections[i].b == in.connections[i].b);
    REQUIRE(sameBits(out.connections[i].made, in.connections[i].made));
    REQUIRE(sameBits(out.connections[i].released, in.connections[i].released));
    REQUIRE(out.connections[i].cause == in.connections[i].cause);
  }
  REQUIRE(out.timeSteps == in.timeSteps);
  REQUIRE(out.divisions == in.divisions);
  REQUIRE(out.chain == in.chain);
  REQUIRE(out.checks == in.checks);
}

TEST_CASE("the lineage alone comes back in order of birth, whatever order it was given in") {
  RunResults in = exampleResults();
  std::swap(in.lineage[0], in.lineage[2]);
  Stored stored(in);
  const RunResults out = stored.store.lineage(stored.id);
  REQUIRE(out.lineage.size() == 3);
  REQUIRE(out.lineage[0].path.isEgg());
  REQUIRE(out.lineage[1].path.text() == "A");
  REQUIRE(out.lineage[2].path.text() == "B");
  REQUIRE(out.samples.empty());
}

// SQLite does not keep these two numbers; docs and comments promise exactly this.
TEST_CASE("−0 comes back as 0 and what is not a number as not measured") {
  RunResults in = exampleResults();
  in.samples[1].cells[0]["x"] = -0.0;
  in.samples[1].cells[0]["pressure"] = std::nan("");
  Stored stored(in);
  const RunResults out = stored.store.results(stored.id);
  REQUIRE(sameBits(out.samples[1].cells[0].at("x"), 0.0));
  REQUIRE_FALSE(out.samples[1].cells[0]["pressure"]);
}

TEST_CASE("a run is found by the beginning of its id") {
  Stored stored(exampleResults());
  REQUIRE(stored.store.find(stored.id).id == stored.id);
  REQUIRE(stored.store.find(stored.id.substr(0, 5)).id == stored.id);
  REQUIRE(stored.store.find("").id == stored.id);
  REQUIRE_THROWS_WITH(stored.store.find("xyz"), ContainsSubstring("no run xyz"));
}
