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

const std::vector<const SqlTable*>& runTables() {
  static const std::vector<const SqlTable*> tables{
      &sqlTable<StoredRun>(),        &sqlTable<StoredText>(),      &sqlTable<DocumentUse>(),
      &sqlTable<CellRow>(),          &sqlTable<WorldMeasures>(),   &sqlTable<CellSampleRow>(),
      &sqlTable<ContactMeasures>(),  &sqlTable<TakenMeasure>(),    &sqlTable<CellSurface>(),
      &sqlTable<ConnectionRecord>(), &sqlTable<DivisionRecord>(),  &sqlTable<TimeStepRecord>(),
      &sqlTable<SettlingRecord>(),   &sqlTable<ChainLink>(),       &sqlTable<CellHash>(),
      &sqlTable<CheckResult>(),      &sqlTable<BulletSampleRow>(), &sqlTable<CheckpointRow>(),
      &sqlTable<FrameRow>(),         &sqlTable<SealedTable>()};
  return tables;
}

}  // namespace morula
