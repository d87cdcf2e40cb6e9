#include "store/run_tables.h"

#include <mutex>
#include <set>

namespace morula {

const char* lasting(const std::string& text) {
  static std::mutex mutex;
  static std::set<std::string> texts;
  const std::lock_guard lock(mutex);
  return texts.insert(text).first->c_str();
}

const std::vector<const Table*>& runTables() {
  static const std::vector<const Table*> tables{
      &table<StoredRun>(),        &table<StoredText>(),     &table<DocumentUse>(),
      &table<CellRow>(),          &table<WorldMeasures>(),  &table<CellSampleRow>(),
      &table<ContactMeasures>(),  &table<TakenMeasure>(),   &table<CellSurface>(),
      &table<ConnectionRecord>(), &table<DivisionRecord>(), &table<TimeStepRecord>(),
      &table<ChainLink>(),        &table<CellHash>(),       &table<CheckResult>(),
      &table<BulletSampleRow>(),  &table<CheckpointRow>(),  &table<FrameRow>()};
  return tables;
}

}  // namespace morula
