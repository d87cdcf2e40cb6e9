#include "cli/verbs.h"

#include "study_verbs/study_verbs.h"

namespace morula::cli {

void addVerbs(CLI::App& app, Action& action) {
  addRun(app, action);
  addParts(app, action);
  addCheck(app, action);
  addExplain(app, action);
  addReview(app, action);
  addValidate(app, action);
  addSchema(app, action);
  addInit(app, action);
  addRender(app, action);
  addChart(app, action);
  addLineage(app, action);
  addReplay(app, action);
  addExport(app, action);
  addReport(app, action);
  addAccuracy(app, action);
  addBench(app, action);
  addStudy(app, action);
  addCompare(app, action);
  addTrail(app, action);
  addEngineWorker(app, action);
}

}  // namespace morula::cli
