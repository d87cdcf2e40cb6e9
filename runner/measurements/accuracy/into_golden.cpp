#include "accuracy/into_golden.h"

#include "base/error.h"
#include "golden/accept.h"

namespace morula {
namespace {

constexpr int maxShorter = 6;  // max number of halvings of the time of comparison

void write(const Scenario& scenario, std::vector<GoldenItem> stated) {
  const auto file = goldenPath(scenario.file);
  Golden golden = readGoldenFile(file);
  golden.stated = std::move(stated);
  acceptGolden(file, golden, {golden.acceptedBy, golden.why});
}

std::vector<GoldenItem> itemsOf(const StatedErrors& stated) {
  std::vector<GoldenItem> items(stated.errors.begin(), stated.errors.end());
  items.insert(items.end(), stated.unstated.begin(), stated.unstated.end());
  return items;
}

}  // namespace

void refuseIntoGolden(const Scenario& scenario) {
  const auto file = goldenPath(scenario.file);
  refuseWithinCi(file);
  if (readGoldenFile(file).data.scenarioHash != scenario.meaning.text())
    throw InputError(file.string() +
                     ": the scenario has changed since its golden was accepted; accept its result "
                     "first");
}

AccuracyReport stateInGolden(const ReadScenario& read, AccuracyOptions options) {
  const Scenario scenario = read({});
  const bool chosen = options.until.has_value();
  options.brief = true;
  try {
    AccuracyReport report = measureAccuracy(read, options);
    for (int i = 0; !chosen && i < maxShorter && report.times.size() > 1 && !whyNoError(report).empty(); ++i) {
      options.until = report.times[report.times.size() / 2 - 1];
      options.tell("no error can be stated: " + whyNoError(report) + "; trying half the time");
      report = measureAccuracy(read, options);
    }
    write(scenario, itemsOf(report.stated));
    return report;
  } catch (const InputError& error) {
    const std::string why = error.what(), place = scenario.file + ": ";
    if (!scenario.scene.mechanics || chosen) throw;
    write(scenario, {GoldenUnstated{"time", {shortly(why.starts_with(place) ? why.substr(place.size()) : why)}}});
    throw InputError(why + "; the golden file says so now");
  }
}

}  // namespace morula
