// Results of rows together: orders, speeds at equal error, and the cheapest settings.
#include <algorithm>
#include <cmath>

#include "accuracy/accuracy.h"
#include "physics/integrator.h"

namespace morula {
namespace {

bool counts(const AccuracyRow& row) { return row.error && row.resolved && !row.partedAt; }

/// Returns the rows by series, in the order of their first rows.
std::vector<std::vector<const AccuracyRow*>> bySeries(const std::vector<AccuracyRow>& rows) {
  std::vector<std::vector<const AccuracyRow*>> groups;
  for (const AccuracyRow& row : rows) {
    const auto group = std::ranges::find(groups, row.series, [](const auto& g) { return g.front()->series; });
    if (group == groups.end()) groups.push_back({&row});
    else group->push_back(&row);
  }
  return groups;
}

std::vector<WorkPoint> work(const std::vector<const AccuracyRow*>& series, bool seconds) {
  std::vector<WorkPoint> points;
  // A row that does not count gets error 0, which breaks the line: nothing is interpolated across it.
  for (const AccuracyRow* row : series)
    points.push_back({seconds ? row->cpuSeconds : double(row->forceEvaluations), counts(*row) ? *row->error : 0});
  return points;
}

/// Returns the least CPU time for the error: between neighbouring runs, or of a run that is more exact and not dearer.
std::optional<double> minSeconds(const std::vector<const AccuracyRow*>& series, double error) {
  std::optional<double> least = costAtError(work(series, true), error);
  for (const AccuracyRow* row : series)
    if (row->error && !row->partedAt && *row->error <= error && (!least || row->cpuSeconds < *least))
      least = row->cpuSeconds;
  return least;
}

}  // namespace

std::vector<const AccuracyRow*> thatHold(const AccuracyReport& report, double target, bool ours) {
  std::vector<const AccuracyRow*> rows;
  for (const AccuracyRow& row : report.rows)
    if ((row.engine == MeasuredEngine::morula) == ours && row.failure.empty() && row.error && !row.partedAt &&
        *row.error + report.reference.left.error <= target)
      rows.push_back(&row);
  std::ranges::stable_sort(rows, {}, &AccuracyRow::cpuSeconds);
  return rows;
}

double ErrorParts::sum() const {
  return time.value_or(0) + mesh.value_or(0) + precision.value_or(0) + model.value_or(0);
}

std::optional<Rival> findRival(const AccuracyRow& own, const std::vector<AccuracyRow>& rows) {
  std::optional<Rival> best;
  const auto offer = [&](const std::string& series, double seconds) {
    if (!best || seconds < best->cpuSeconds) best = {series, seconds, own.cpuSeconds / seconds};
  };
  if (!own.error || own.partedAt || !(own.cpuSeconds > 0)) return best;  // no error, or too short to be timed
  for (const auto& series : bySeries(rows)) {
    const auto seconds = minSeconds(series, *own.error);
    if (seconds && *seconds > 0 && series.front()->engine == MeasuredEngine::morula)
      offer(series.front()->series, *seconds);
  }
  return best;
}

std::vector<BulletSpeed> compareSpeeds(const std::vector<AccuracyRow>& rows) {
  std::vector<BulletSpeed> speeds;
  const auto groups = bySeries(rows);
  for (int decade = -1; decade >= -12; --decade) {
    BulletSpeed s;
    s.error = std::pow(10.0, decade);
    for (const auto& series : groups) {
      const auto seconds = minSeconds(series, s.error);
      if (!seconds) continue;
      const bool own = series.front()->engine == MeasuredEngine::morula;
      if (!own) s.bulletMostSeconds = std::max(s.bulletMostSeconds, *seconds);
      double& least = own ? s.ourSeconds : s.bulletSeconds;
      if (least > 0 && least <= *seconds) continue;
      least = *seconds;
      (own ? s.ours : s.bullets) = series.front()->series;
    }
    if (s.ourSeconds > 0 && s.bulletSeconds > 0) speeds.push_back(s);
  }
  return speeds;
}

std::vector<SeriesOrder> findOrders(const std::vector<AccuracyRow>& rows) {
  std::vector<SeriesOrder> orders;
  for (const auto& series : bySeries(rows)) {
    std::vector<XY> points;
    for (const AccuracyRow* row : series)
      if (counts(*row)) points.push_back({row->setting.timeStep, *row->error});
    orders.push_back(
        {series.front()->series, double(kindOf(series.front()->setting.integrator).order), fitPowerLaw(points)});
  }
  return orders;
}

std::vector<SpeedAtError> findSpeeds(const std::vector<AccuracyRow>& rows, const std::string& usual) {
  std::vector<SpeedAtError> speeds;
  const auto groups = bySeries(rows);
  for (int decade = -1; decade >= -12; --decade) {
    const double error = std::pow(10.0, decade);
    std::optional<double> own;
    for (const auto& series : groups)
      if (series.front()->series == usual) own = costAtError(work(series, true), error);
    for (const auto& series : groups) {
      const auto seconds = costAtError(work(series, true), error),
                 evaluations = costAtError(work(series, false), error);
      if (!seconds || !evaluations || !(*seconds > 0)) continue;
      speeds.push_back({error, series.front()->series, *seconds, *evaluations,
                        own && *own > 0 ? std::optional(*own / *seconds) : std::nullopt});
    }
  }
  return speeds;
}

}  // namespace morula
