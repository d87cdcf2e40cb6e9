#include "accuracy/into_golden.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.h"
#include "base/number_text.h"
#include "golden/accept.h"

namespace morula {
namespace {

constexpr int maxShorter = 6;       // max number of halvings of the time of comparison
constexpr double rounding = 1e-12;  // smaller errors count as none

/// Rounds an error to two digits, since it is measured and no result.
double twoDigits(double a) { return std::stod(fmt::format("{:.1e}", a)); }

void write(const Scenario& scenario, std::vector<GoldenItem> stated) {
  const auto file = goldenPath(scenario.file);
  Golden golden = readGoldenFile(file);
  golden.stated = std::move(stated);
  acceptGolden(file, golden, {golden.acceptedBy, golden.why});
}

/// Returns a failure without the figures and advice at its end.
std::string shortly(const std::string& why) { return why.substr(0, std::min(why.find("; "), why.find(", and "))); }

Cell sizeCell(const std::optional<double>& size) { return size ? number(*size, 2) : Cell("not known"); }

const GoldenError* find(const Golden& golden, const ErrorQuantity& q) {
  for (const GoldenError* e : all<GoldenError>(golden.stated))
    if (e->quantity == q.name) return e;
  return nullptr;
}

/// Returns the reasons for missing errors: "mesh: icosphere 3 takes about 12 s of CPU time".
std::string whyUnstated(const Golden& golden) {
  std::string text;
  for (const GoldenUnstated* u : all<GoldenUnstated>(golden.stated))
    text += (text.empty() ? "" : "; ") + u->of + ": " + u->why.text;
  return text;
}

/// Returns the reason why there is no error to state; "" if there is one.
std::string whyNoError(const AccuracyReport& report) {
  const AccuracyRow& own = report.own;
  if (!own.failure.empty()) return own.failure;
  if (!own.error)
    return "other cells live than in the reference, or they divide across another plane, from the first comparison on";
  const double left = report.reference.left.error;
  if (!std::isfinite(left)) return "no reference has converged";
  if (left > std::max(*own.error / 2, rounding))
    return fmt::format("the reference's own is {:.2g}, the scenario's {:.2g}", left, *own.error);
  return "";
}

/// Returns the reason why the comparison ended before the last time.
std::string whyShorter(double until, bool parted, const std::string& otherwise) {
  return fmt::format("after {}: {}", numberText(until, 3), parted ? "other cells live" : otherwise);
}

std::vector<GoldenItem> statedIn(const AccuracyReport& report) {
  if (const std::string why = whyNoError(report); !why.empty()) return {GoldenUnstated{"time", {shortly(why)}}};
  const AccuracyRow& own = report.own;
  const MeshError& mesh = report.mesh;
  const LevelError* const level = mesh.error() ? mesh.find(mesh.own) : nullptr;
  std::vector<GoldenItem> stated;
  for (const ErrorQuantity& q : errorQuantities) {
    if (q.ofPairs && !own.touch && !mesh.touch) continue;
    if (q.of == &StateError::pressure && mesh.none) continue;  // spheres have no pressure
    GoldenError e{q.name, twoDigits(own.errors.*q.of), own.until, {}, {}};
    if (mesh.none) e.mesh = 0, e.meshUntil = own.until;
    if (level) e.mesh = twoDigits(level->worst.*q.of), e.meshUntil = mesh.until;
    stated.push_back(e);
  }
  const std::string plane = "a cell divides across another plane";
  if (own.until < report.times.back())
    stated.push_back(GoldenUnstated{"time", {whyShorter(own.until, own.partedAt.has_value(), plane)}});
  if (!mesh.none && !level)
    stated.push_back(GoldenUnstated{"mesh", {shortly(mesh.unknown.empty() ? mesh.limit : mesh.unknown)}});
  else if (level && mesh.until < own.until)
    stated.push_back(GoldenUnstated{
        "mesh", {whyShorter(mesh.until, mesh.partedAt.has_value(), mesh.cut ? plane : shortly(mesh.limit))}});
  return stated;
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
    write(scenario, statedIn(report));
    return report;
  } catch (const InputError& error) {
    const std::string why = error.what(), place = scenario.file + ": ";
    if (scenario.scene.mechanics && !chosen)
      write(scenario, {GoldenUnstated{"time", {shortly(why.starts_with(place) ? why.substr(place.size()) : why)}}});
    throw;
  }
}

bool hasBodies(const Golden& golden) {
  return std::ranges::any_of(golden.data.parameters, [](const auto& p) { return p.first.starts_with("physics."); });
}

Document statedErrors(const Golden& golden) {
  Document text;
  std::vector<ErrorQuantity> rows;
  for (const ErrorQuantity& q : errorQuantities)
    if (find(golden, q)) rows.push_back(q);
  const auto of = [&](const ErrorQuantity& q) -> const GoldenError& { return *find(golden, q); };
  const std::vector<FieldOf<ErrorQuantity>> fields{
      {"Quantity", [](const ErrorQuantity& q) { return nameOf(q) + " [" + q.unit + "]"; }},
      {"Error of the time step", [=](const ErrorQuantity& q) { return number(of(q).time, 2); }},
      {"up to time", [=](const ErrorQuantity& q) { return number(of(q).until); }},
      {"Error of the mesh", [=](const ErrorQuantity& q) { return sizeCell(of(q).mesh); }},
      {"up to time", [=](const ErrorQuantity& q) { return number(of(q).meshUntil); }},
  };
  if (!rows.empty())
    text.add(tableOf("Errors of these settings", fields, rows))
        .note("Each is the largest over all cells and times of comparison; later no path is left to be compared.");
  if (const std::string why = whyUnstated(golden); !why.empty()) text.say("Not stated: " + why + ".");
  const std::vector<FieldOf<GoldenStatistic>> means{
      {"Mean at the end of", [](const GoldenStatistic& s) { return s.measure; }},
      {"against", [](const GoldenStatistic& s) { return s.against; }},
      {"differs by", [](const GoldenStatistic& s) { return number(s.difference, 3); }},
      {"from", [](const GoldenStatistic& s) { return number(s.low, 3); }},
      {"to, in 95 of 100", [](const GoldenStatistic& s) { return number(s.high, 3); }},
      {"Runs of each", [](const GoldenStatistic& s) { return s.runs; }},
  };
  if (!golden.statistics.empty()) text.add(tableOf("Beyond, over many runs", means, golden.statistics));
  return text;
}

namespace {

/// Returns "0.05 (0.04 to 0.06)", or why there is no interval.
std::string statisticText(const GoldenStatistic& s) {
  const std::string difference = numberText(s.difference, 2);
  if (s.runs == 1) return difference + " (one path)";
  if (s.low == s.high) return difference + " (every run)";
  return fmt::format("{} ({} to {})", difference, numberText(s.low, 2), numberText(s.high, 2));
}

/// Returns a table with a row for each measure of each golden, and a column for each compared setting.
std::string statisticsAsMarkdown(const std::vector<Golden>& goldens) {
  using Row = std::pair<const Golden*, std::string>;  // golden and measure
  std::vector<Row> rows;
  std::set<std::string> settings;
  for (const Golden& golden : goldens)
    for (const GoldenStatistic& s : golden.statistics) {
      settings.insert(s.against);
      if (const Row row{&golden, s.measure}; std::ranges::find(rows, row) == rows.end()) rows.push_back(row);
    }
  std::vector<FieldOf<Row>> fields{{"Scenario", [](const Row& row) { return row.first->data.scenario; }},
                                   {"Mean of", [](const Row& row) { return row.second; }}};
  for (const std::string& against : settings)
    fields.push_back({against, [=](const Row& row) {
                        for (const GoldenStatistic& s : row.first->statistics)
                          if (s.measure == row.second && s.against == against) return statisticText(s);
                        return std::string();
                      }});
  return "\n## At the end, over many runs\n\n"
         "Where chaos sets in before the end, means over runs are compared whose eggs begin a millionth of a radius apart:\n"
         "the mean with the scenario's own settings less that with others, and its 95 % interval. An interval that holds 0\n"
         "shows no error; of twenty intervals one misses the true difference by chance. Where nothing lets the runs part,\n"
         "they are one path, whose difference has no interval; nor has a difference that is the same in every run. They are\n"
         "written by `morula study compare --into-golden` from studies in\n"
         "[scenarios/policies](../scenarios/policies/README.md).\n\n" +
         markdownOf(tableOf("Statistics", fields, rows));
}

}  // namespace

std::string statedErrorsAsMarkdown(std::vector<Golden> goldens) {
  std::ranges::sort(goldens, {}, [](const Golden& g) { return g.data.scenario; });
  std::vector<FieldOf<Golden>> fields{{"Scenario", [](const Golden& g) { return g.data.scenario; }}};
  const auto until = [](const Golden& g, auto member) {
    const GoldenError* const e = find(g, errorQuantities[0]);
    return e ? number(std::optional<double>(e->*member), 3) : Cell();
  };
  const auto both = [](const GoldenError* e) {
    return e ? fmt::format("{} / {}", numberText(e->time, 2), e->mesh ? numberText(*e->mesh, 2) : "?") : std::string();
  };
  for (const ErrorQuantity& q : errorQuantities)
    fields.push_back({nameOf(q), [=](const Golden& g) { return both(find(g, q)); }});
  fields.push_back({"until, time", [=](const Golden& g) { return until(g, &GoldenError::until); }});
  fields.push_back({"until, mesh", [=](const Golden& g) { return until(g, &GoldenError::meshUntil); }});
  fields.push_back({"not stated", whyUnstated});
  std::string units;
  for (const ErrorQuantity& q : errorQuantities) units += "- " + nameOf(q) + " [" + q.unit + "]\n";
  return "# The errors that goldens state\n\n"
         "`morula review golden/*/*.golden --stated` prints this file. Each size is the largest over all cells and times\n"
         "of comparison, that of the time step / of the mesh, ? where it is not known, up to the time that stands beside it:\n"
         "the end of the scene, before chaos sets in, or before the first event that differs (other cells, a division across\n"
         "another plane). Neighbours are a share over all times. Scenes without bodies have no errors. [How they are\n"
         "measured](../runner/measurements/accuracy/README.md).\n\n" +
         units + "\n" + markdownOf(tableOf("Errors", fields, goldens)) + statisticsAsMarkdown(goldens);
}

}  // namespace morula
