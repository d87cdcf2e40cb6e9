#include "store/run_tables.h"

namespace morula {

const std::vector<const SqlTable*>& runTables() {
  static const std::vector<const SqlTable*> tables{
      &sqlTable<StoredRun>(),        &sqlTable<StoredText>(),      &sqlTable<DocumentUse>(),
      &sqlTable<CellRow>(),          &sqlTable<WorldMeasures>(),   &sqlTable<CellSampleRow>(),
      &sqlTable<ContactMeasures>(),  &sqlTable<TakenMeasure>(),    &sqlTable<CellSurface>(),
      &sqlTable<ConnectionRecord>(), &sqlTable<DivisionRecord>(),  &sqlTable<TimeStepRecord>(),
      &sqlTable<SettlingRecord>(), &sqlTable<ExperimentRecord>(),   &sqlTable<ChainLink>(),       &sqlTable<CellHash>(),
      &sqlTable<CheckResult>(),      &sqlTable<AgainstStage>(), &sqlTable<AgainstCell>(), &sqlTable<BulletSampleRow>(), &sqlTable<CheckpointRow>(),
      &sqlTable<FrameRow>(),         &sqlTable<SealedTable>()};
  return tables;
}

}  // namespace morula
