// Stated errors for people: of one report or golden, and of all goldens as golden/ERRORS.md.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "accuracy/state_error.h"
#include "accuracy/stated_errors.h"
#include "base/number_text.h"

namespace morula {
namespace {

/// Returns the quantity of this name; one with the name alone if a golden has another one.
ErrorQuantity quantityOf(const GoldenError& error) {
  for (const ErrorQuantity& q : errorQuantities)
    if (error.quantity == q.name) return q;
  return {error.quantity.c_str(), "", nullptr};
}

const GoldenError* find(const std::vector<GoldenError>& errors, const ErrorQuantity& q) {
  const auto found = std::ranges::find(errors, q.name, &GoldenError::quantity);
  return found == errors.end() ? nullptr : &*found;
}

Cell sizeCell(const std::optional<double>& size) { return size ? number(*size, 2) : Cell("not known"); }

/// Returns the reasons for missing errors: "mesh: icosphere 3 takes about 12 s of CPU time".
std::string whyUnstated(const std::vector<GoldenUnstated>& unstated) {
  std::string text;
  for (const GoldenUnstated& u : unstated) text += (text.empty() ? "" : "; ") + u.of + ": " + u.why.text;
  return text;
}

std::string whyUnstated(const Golden& golden) {
  std::vector<GoldenUnstated> unstated;
  for (const GoldenUnstated* u : all<GoldenUnstated>(golden.stated)) unstated.push_back(*u);
  return whyUnstated(unstated);
}

/// Returns "-0.0041 to 0.0017", or why there is no interval.
std::string intervalText(const GoldenStatistic& s) {
  if (s.onePath) return "one path";
  return s.low == s.high ? "no spread" : numberText(s.low, 2) + " to " + numberText(s.high, 2);
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
                          if (s.measure == row.second && s.against == against)
                            return fmt::format("{} ({})", numberText(s.difference, 2), intervalText(s));
                        return std::string();
                      }});
  return "\n## At the end, over many runs\n\n"
         "Where chaos sets in before the end, means over runs are compared whose eggs begin a millionth of a radius apart:\n"
         "the mean with the scenario's own settings less that with others, and its 95 % interval. An interval that holds 0\n"
         "shows no error; of twenty intervals one misses the true difference by chance. *One path*: the runs of both settings\n"
         "stay together, to 1e-9 of their values, so there is a difference and no interval. *No spread*: to three digits the\n"
         "interval has no width. They are written by `morula study compare --into-golden` from studies in\n"
         "[scenarios/policies](../scenarios/policies/README.md).\n\n" +
         markdownOf(tableOf("Statistics", fields, rows));
}

/// An error of the time step / of the mesh; ? where it is not known.
std::string pairText(const std::optional<double>& time, const std::optional<double>& mesh) {
  const auto text = [](const std::optional<double>& error) { return error ? numberText(*error, 2) : std::string("?"); };
  return text(time) + " / " + text(mesh);
}

/// Returns a table with a row for each golden and a column for each quantity.
std::string errorsAsMarkdown(const std::vector<Golden>& goldens, bool atRest) {
  std::vector<FieldOf<Golden>> fields{{"Scenario", [](const Golden& g) { return g.data.scenario; }}};
  for (const ErrorQuantity& q : errorQuantities)
    fields.push_back({nameOf(q), [=](const Golden& g) {
                        const std::vector<GoldenError> errors = errorsOf(g);
                        const GoldenError* const e = find(errors, q);
                        if (!e) return std::string();
                        return atRest ? pairText(e->rest, e->meshRest) : pairText(e->worst, e->meshWorst);
                      }});
  if (atRest) return markdownOf(tableOf("At rest", fields, goldens));
  const auto until = [](const Golden& g, auto member) {
    const std::vector<GoldenError> errors = errorsOf(g);
    const GoldenError* const e = find(errors, errorQuantities[0]);
    return e ? number(std::optional<double>(e->*member), 3) : Cell();
  };
  fields.push_back({"until, time", [=](const Golden& g) { return until(g, &GoldenError::until); }});
  fields.push_back({"until, mesh", [=](const Golden& g) { return until(g, &GoldenError::meshUntil); }});
  fields.push_back({"not stated", [](const Golden& g) {
                      const std::string why = whyUnstated(g);
                      return !hasOldErrors(g) ? why : why.empty() ? "at rest" : "at rest; " + why;
                    }});
  return markdownOf(tableOf("At worst", fields, goldens));
}

}  // namespace

Document describeErrors(const std::vector<GoldenError>& errors) {
  using Row = GoldenError;
  const std::vector<FieldOf<Row>> fields{
      {"Quantity",
       [](const Row& e) {
         const ErrorQuantity q = quantityOf(e);
         return nameOf(q) + " [" + q.unit + "]";
       }},
      {"Time step, at rest", [](const Row& e) { return sizeCell(e.rest); }},
      {"at worst", [](const Row& e) { return number(e.worst, 2); }},
      {"up to time", [](const Row& e) { return number(e.until); }},
      {"Mesh, at rest", [](const Row& e) { return sizeCell(e.meshRest); }},
      {"at worst", [](const Row& e) { return sizeCell(e.meshWorst); }},
      {"up to time", [](const Row& e) { return number(e.meshUntil); }},
  };
  return Document()
      .add(tableOf("Errors of these settings", fields, errors))
      .note(
          "Each is that of the cell with the largest error. At rest: the median over the times of comparison without a "
          "birth, a death or a first contact within 10 steps. At worst: " +
          numberText(worstMargin) +
          " times the largest over all times of comparison. Later no path is left to be compared.");
}

Document describeStated(const StatedErrors& stated) {
  Document text;
  if (!stated.errors.empty())
    text.add(describeErrors(stated.errors))
        .say(fmt::format("compared at {} times, {} of them at rest; {} events", stated.times, stated.quietTimes,
                         stated.events));
  if (const std::string why = whyUnstated(stated.unstated); !why.empty()) text.say("not stated: " + why);
  return text;
}

bool hasBodies(const Golden& golden) {
  return std::ranges::any_of(golden.data.parameters, [](const auto& p) { return p.first.starts_with("physics."); });
}

Document statedErrors(const Golden& golden) {
  Document text;
  if (const std::vector<GoldenError> errors = errorsOf(golden); !errors.empty()) text.add(describeErrors(errors));
  if (hasOldErrors(golden)) text.note("Above " + std::string(oldErrorNote) + ", and it stands under at worst.");
  if (const std::string why = whyUnstated(golden); !why.empty()) text.say("Not stated: " + why + ".");
  const std::vector<FieldOf<GoldenStatistic>> means{
      {"Mean at the end of", [](const GoldenStatistic& s) { return s.measure; }},
      {"against", [](const GoldenStatistic& s) { return s.against; }},
      {"differs by", [](const GoldenStatistic& s) { return number(s.difference, 3); }},
      {"in 95 of 100", intervalText},
      {"Runs of each", [](const GoldenStatistic& s) { return s.runs; }},
  };
  if (!golden.statistics.empty()) text.add(tableOf("Beyond, over many runs", means, golden.statistics));
  return text;
}

std::string statedErrorsAsMarkdown(std::vector<Golden> goldens) {
  std::ranges::sort(goldens, {}, [](const Golden& g) { return g.data.scenario; });
  std::vector<Golden> atRest = goldens;
  std::erase_if(atRest, [](const Golden& g) { return hasOldErrors(g) || errorsOf(g).empty(); });
  const bool someOld = std::ranges::any_of(goldens, hasOldErrors);
  std::string units;
  for (const ErrorQuantity& q : errorQuantities) units += "- " + nameOf(q) + " [" + q.unit + "]\n";
  std::string text =
      "# The errors that goldens state\n\n"
      "`morula review golden/*/*.golden --stated` prints this file. Each pair is the error of the time step / of the mesh,\n"
      "? where it is not known, of the cell for which it is largest. Scenes without bodies have no errors. [How they are\n"
      "measured](../runner/measurements/accuracy/README.md).\n\n" +
      units +
      "\n## At rest\n\n"
      "The median over the times without a birth, a death or a first contact within 10 steps. Neighbours are a share over\n"
      "all of these times.";
  if (someOld) text += " Scenarios for which " + std::string(oldErrorNote) + ", are missing here.";
  text += "\n\n" + (atRest.empty() ? "" : errorsAsMarkdown(atRest, true) + "\n");
  text +=
      "## At worst\n\n"
      "The largest over at least 40 times and three more after each birth, death and first contact, times " +
      numberText(worstMargin) +
      ", since\nbetween these times errors are larger. They hold up to the time that stands beside them: the end of the "
      "scene, before\nchaos sets in, or before the first event that differs (other cells, a division across another plane)."
      "\n\n";
  if (someOld)
    text += "Where none is stated at rest, " + std::string(oldErrorNote) +
            "; the factor is not in it, and errors between\n" + "these times are larger.\n\n";
  return text + errorsAsMarkdown(goldens, false) + statisticsAsMarkdown(goldens);
}

}  // namespace morula
