// morula study emit: files with which a cluster, a workflow or GNU parallel runs a study.

#include <fmt/format.h>

#include "files/folders.h"
#include "files/write_file.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "study_verbs/study_verbs.h"
#include "system/console.h"
#include "tasks/emit.h"

namespace morula::cli {
namespace {

struct EmitCommand {
  EmitOptions emit;
  StudyOptions of;
  std::string output;
  bool force = false, resume = false;
};

int act(const EmitCommand& command) {
  const PlannedStudy study = openStudy({.what = command.of.study,
                                        .to = command.of.out,
                                        .allowOutside = command.of.input.allowOutside,
                                        .resume = command.resume},
                                       {});
  const std::filesystem::path out =
      command.output.empty() ? siteFile(study, command.emit.site) : std::filesystem::path(command.output);
  const std::string text = emit(study, command.emit);
  if (!command.output.empty() && !(command.force && fileExists(out))) requireNewFile(out);
  keepPlan(study);
  // A file in the study's own folder was written by an earlier call, and may be replaced.
  if (command.output.empty() || command.force) overwriteFile(out, text);
  else writeNewFile(out, text);
  if (command.emit.site == Site::slurm && command.emit.shares > maxArrayJobs && study.plan.tasks.size() > maxArrayJobs)
    tell(fmt::format(
             "--jobs {}: the file asks for {} jobs, which is what Slurm takes in one array unless a site has raised "
             "MaxArraySize",
             command.emit.shares, maxArrayJobs),
         command.of.output.quiet);
  const std::string start = howToStart(study, command.emit.site, out);
  printEither(command.of.output,
              {{"study", study.plan.study.name},
               {"folder", study.folder.path().string()},
               {"file", out.string()},
               {"start", start}},
              out.string() + "\n");
  tell("start it with: " + start, command.of.output.quiet || command.of.output.json);
  return fine;
}

}  // namespace

void addStudyEmit(CLI::App& study, Action& action) {
  Verb verb(study, action, "emit",
            "Write a file with which Slurm, Snakemake or GNU parallel runs the study, and print its path");
  auto& command = verb.does<EmitCommand>(act);
  verb.needs("site", command.emit.site, "SITE", parseChoice<Site>, namesOf<Site>());
  add(verb, command.of);
  verb.takes("-o,--output", command.output, "FILE",
             "File to write; default: study.sbatch, Snakefile or parallel.sh in the study's folder");
  verb.takes("--force", command.force, "Replace the file that -o names");
  verb.onlyWith({"--force"}, {"--output"});
  verb.takes("--jobs", command.emit.shares, "N", natural(1, 1'000'000),
             "Number of jobs for all runs; default: jobs of about ten minutes each");
  verb.showDefault("--jobs", "");
  verb.takes("--resume", command.resume, "Use the plan in the folder, even if the study file has changed since");
}

}  // namespace morula::cli
