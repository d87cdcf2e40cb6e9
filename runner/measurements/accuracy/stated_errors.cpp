#include "accuracy/stated_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "accuracy/accuracy.h"
#include "base/number_text.h"

namespace morula {
namespace {

constexpr double rounding = 1e-12;  // smaller errors count as none

/// Rounds an error to two digits, since it is measured and no result.
double twoDigits(double a) { return std::stod(fmt::format("{:.1e}", a)); }

std::optional<double> atRest(const std::optional<StateError>& errors, const ErrorQuantity& q) {
  return errors ? std::optional(twoDigits((*errors).*q.of)) : std::nullopt;
}

double atWorst(const StateError& measured, const ErrorQuantity& q) {
  const double error = measured.*q.of * worstMargin;
  return twoDigits(q.of == &StateError::neighbours ? std::min(error, 1.0) : error);  // a share is at most 1
}

/// Returns the reason why the comparison ended before the last time.
std::string whyShorter(double until, bool parted, const std::string& otherwise) {
  return fmt::format("after {}: {}", numberText(until, 3), parted ? "other cells live" : otherwise);
}

}  // namespace

/// Returns a failure without the figures and advice at its end.
std::string shortly(const std::string& why) { return why.substr(0, std::min(why.find("; "), why.find(", and "))); }

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

StatedErrors stateErrors(const AccuracyReport& report, const RunDistance& own, const std::vector<double>& times) {
  const std::vector<SceneEvent>& events = report.horizon->events;
  StatedErrors stated;
  stated.times = times.size(), stated.events = events.size();
  for (const double time : times) stated.quietTimes += isQuiet(events, time);
  if (const std::string why = whyNoError(report); !why.empty()) {
    stated.unstated.push_back({"time", {shortly(why)}});
    return stated;
  }
  const MeshError& mesh = report.mesh;
  const LevelError* const level = mesh.error() ? mesh.find(mesh.own) : nullptr;
  for (const ErrorQuantity& q : errorQuantities) {
    if (q.ofPairs && !own.touch && !mesh.touch) continue;
    if (q.of == &StateError::pressure && mesh.none) continue;  // spheres have no pressure
    GoldenError e{q.name, atRest(own.atRest, q), atWorst(own.worst, q), own.until, {}, {}, {}};
    if (mesh.none) e.meshRest = 0, e.meshWorst = 0, e.meshUntil = own.until;
    if (level) e.meshRest = atRest(level->atRest, q), e.meshWorst = atWorst(level->worst, q), e.meshUntil = mesh.until;
    stated.errors.push_back(e);
  }
  const std::string plane = "a cell divides across another plane";
  if (own.until < times.back())
    stated.unstated.push_back({"time", {whyShorter(own.until, own.partedAt.has_value(), plane)}});
  if (!mesh.none && !level)
    stated.unstated.push_back({"mesh", {shortly(mesh.unknown.empty() ? mesh.limit : mesh.unknown)}});
  else if (level && mesh.until < own.until)
    stated.unstated.push_back(
        {"mesh", {whyShorter(mesh.until, mesh.partedAt.has_value(), mesh.cut ? plane : shortly(mesh.limit))}});
  return stated;
}

}  // namespace morula
