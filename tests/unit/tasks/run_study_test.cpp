// Tasks are computed once, failures are results, and stopped tasks are computed again.

#include "catch.h"
#include "files/folders.h"
#include "small_study.h"
#include "tasks/status.h"

using namespace morula;
using namespace std::chrono_literals;

TEST_CASE("a study is computed, and computed once") {
  const SmallStudy s;
  const PlannedStudy study = s.open();
  // There are 2 lengths with 3 seeds each, and 2 scenes without variation, whose seeds change nothing.
  REQUIRE(study.plan.replicates.size() == 12);
  REQUIRE(study.plan.tasks.size() == 8);
  CHECK(s.run(study, {1, 4}).computed == 2);
  StudyStatus status = statusOf(study);
  CHECK((status.done == 2 && status.missing.size() == 6 && !status.isComplete()));
  const RunStudyReport rest = s.run(study, {}, 2);
  CHECK((rest.asked == 8 && rest.already == 2 && rest.computed == 6 && rest.isComplete() && rest.failed.empty()));
  CHECK(s.run(study).computed == 0);
  status = statusOf(study);
  CHECK((status.isComplete() && status.done == 8 && !status.isMerged));
  for (std::size_t t = 0; t < 8; ++t) CHECK(TaskFile(fileOf(study, t)).whatIsWrong().empty());
}

TEST_CASE("what its plan keeps is there, and nothing else") {
  const auto rows = [](const std::string& when, const std::string& more, const std::string& sql) {
    std::string text = smallStudy;
    if (!when.empty())
      text.replace(text.rfind("["), std::string::npos, "{names: [cells, generation], when: " + when + "}\n");
    const SmallStudy s(text + more);
    const PlannedStudy study = s.open();
    s.run(study, {0});
    return Database(fileOf(study, 0), Database::Mode::existing, 1s).integer(sql);
  };
  const std::string hashes = "SELECT count(*) FROM step_hash", samples = "SELECT count(*) FROM sample",
                    results = "SELECT count(*) FROM result";
  CHECK(rows("", "keep: {hashes: none}\n", hashes) == 0);
  CHECK(rows("", "keep: {hashes: end}\n", hashes) == 1);
  CHECK(rows("", "keep: {hashes: all}\n", hashes) > 2);
  CHECK(rows("", "", samples) == 2);
  CHECK(rows("", "", results) == 2);
  CHECK(rows("{every: 1}", "", samples) == 2);
  CHECK(rows("{every: 1}", "keep: {samples: all}\n", samples) > 2);
  CHECK(rows("{every: 1}", "", results) == 2 * rows("{every: 1}", "keep: {samples: all}\n", samples));
  CHECK(rows("each-division", "", results) > 4);
}

TEST_CASE("a picture is kept of the first seed of each condition, if asked for") {
  const SmallStudy s(smallStudy + "keep: {pictures: first-seed}\n");
  const PlannedStudy study = s.open();
  s.run(study);
  const auto pictures = filesBelow(study.folder.path(), ".png");
  REQUIRE(pictures.size() == 4);
  for (std::size_t t = 0; t < study.plan.tasks.size(); ++t) {
    const Task& task = study.plan.tasks[t];
    const auto stored = study.folder.storedPicture(task.id);
    CHECK(stored.has_value() == keepsPicture(study.plan, t));
    if (!stored) continue;
    CHECK(*stored == study.folder.picture(study.plan, t));
    std::string name = stored->filename().string();
    for (const std::string& label : study.plan.conditions[task.condition].labels) {
      CHECK(name.starts_with(label));
      name.erase(0, label.size() + 1);
    }
    CHECK(name == "seed-" + std::to_string(task.seed) + "_" + task.id.substr(0, 8) + ".png");
  }
}

TEST_CASE("a failure is a result with its reason") {
  // The cell divides until its memory limit is reached.
  const SmallStudy s(singleStudy + "limits: {memory-per-run: 20M}\n",
                     "morula: 1\nname: tree\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\nstop: {cycles: 40}\n");
  const PlannedStudy study = s.open();
  const RunStudyReport report = s.run(study);
  REQUIRE(report.failed.size() == 1);
  CHECK_THAT(report.failed[0].reason, Catch::Matchers::StartsWith("memory limit: "));
  CHECK(report.isComplete());
  TaskFile file(fileOf(study, 0));
  CHECK((file.task().status == TaskStatus::failed && file.run().status == RunStatus::failed &&
         file.whatIsWrong().empty()));
  CHECK_FALSE(file.task().isComputed());
  CHECK(s.run(study).computed == 0);
  CHECK(s.run(study, {}, 1, true).computed == 1);
  const MergeReport merged = mergeStudy(study, {{}, study.folder.merged()});
  CHECK((merged.failed.size() == 1 && merged.missing.empty()));
}

TEST_CASE("a cell whose name speaks of memory fails as any other") {
  const SmallStudy s(
      singleStudy,
      "morula: 1\nname: tree\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {time: 1}\nnames: {cells: {A: memory-A, B: "
      "memory-B}}\n"
      "cells:\n  - {at: [0, 0, 0], stretch: [1.3, 0.877, 0.877]}\n  - {at: [9, 0, 0], stretch: [1.3, 0.877, 0.877]}\n"
      "physics: {mesh: {icosphere: 2}, cell: {radius: 1, mass: 1}, membrane: {stiffness: 1e5, damping: 0.2}}\n");
  const RunStudyReport report = s.run(s.open());
  REQUIRE(report.failed.size() == 1);
  CHECK_THAT(report.failed[0].reason,
             Catch::Matchers::StartsWith("numerical failure: ") && ContainsSubstring("memory-"));
}

TEST_CASE("CPU time is limited, and a crash is told") {
  const SmallStudy s(singleStudy + "limits: {cpu-per-run: 1}\n",
                     "morula: 1\nname: tree\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {cycles: 1000000000}\n");
  const PlannedStudy study = s.open();
  const RunStudyReport report = s.run(study);
  REQUIRE(report.failed.size() == 1);
  CHECK(report.failed[0].reason == "cpu limit: more than 1 s of CPU time (limits.cpu-per-run)");
  CHECK(TaskFile(fileOf(study, 0)).timing().cpuSeconds > 0);
}

TEST_CASE("a changed study is not mixed with what was planned before") {
  const SmallStudy s;
  const PlannedStudy study = s.open();
  s.run(study);
  writeText(s.folder / "trees.study.yaml", smallStudy + "keep: {hashes: none}\n");
  CHECK_THROWS_WITH(s.open(), ContainsSubstring("--resume continues the existing plan"));
  const StudyChoice choice{.what = (s.folder / "trees.study.yaml").string(), .to = (s.folder / "out").string()};
  StudyChoice resume = choice, update = choice;
  resume.resume = update.update = true;
  CHECK(openStudy(resume, {}).plan.id == study.plan.id);
  const PlannedStudy updated = openStudy(update, {.predict = false});
  CHECK(updated.isNew);
  CHECK(updated.plan.id != study.plan.id);
  CHECK(openStudy(resume, {}).plan.id == study.plan.id);  // until the changed study is kept
  CHECK(openStudy({(s.folder / "out").string(), ""}, {}).plan.id == study.plan.id);
  CHECK_THROWS_AS(openStudy({s.folder.path().string(), ""}, {}), FileError);
}
