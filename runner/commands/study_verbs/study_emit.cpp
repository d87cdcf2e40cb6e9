// morula study emit: what a cluster, a workflow or GNU parallel runs a study with.
#include <memory>

#include "base/did_you_mean.h"
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
  std::string site, study, to, output, jobs;
  InputOptions input;
  OutputOptions messages;
  bool force = false, resume = false;
};

Site siteNamed(const std::string& name) {
  std::vector<std::string> names;
  for (const auto& choice : choices<Site>) {
    if (name == choice.name) return choice.value;
    names.push_back(choice.name);
  }
  const auto near = closest(name, names);
  throw UsageError("emit: '" + name + "' is not known; " +
                   (near.empty() ? "needs " + namesOf<Site>() : "did you mean " + near + "?"));
}

int act(const EmitCommand& command) {
  EmitOptions options{siteNamed(command.site), 0};
  if (!command.jobs.empty()) options.shares = naturalOption("--jobs", command.jobs, 1, 1'000'000);
  const PlannedStudy study =
      openStudy({command.study, command.to, command.input.allowOutside, command.resume, false}, {});
  keepPlan(study);
  const std::filesystem::path out =
      command.output.empty() ? siteFile(study, options.site) : std::filesystem::path(command.output);
  const std::string text = emit(study, options);
  // In the study's own folder stands what an earlier call has written.
  if (command.output.empty() || command.force) overwriteFile(out, text);
  else writeNewFile(out, text);
  const std::string start = howToStart(study, options.site, out);
  if (command.messages.json)
    printJson({{"study", study.plan.study.name},
               {"folder", study.folder.path().string()},
               {"file", out.string()},
               {"start", start}});
  else print(out.string() + "\n");
  tell("start it with: " + start, command.messages.quiet || command.messages.json);
  return fine;
}

}  // namespace

void addStudyEmit(CLI::App& study, Action& action) {
  auto command = std::make_shared<EmitCommand>();
  Verb verb(study, action, "emit",
            "Write what Slurm, Snakemake or GNU parallel runs the study with; prints its path");
  verb.needs("site", command->site, "SITE", "slurm, snakemake or parallel");
  verb.needs("study", command->study, "FILE|DIR", "A study file, or the folder of a study");
  verb.takes("--to", command->to, "DIR", "The study's folder; default: results/studies/NAME");
  verb.takes("-o,--output", command->output, "FILE",
             "Where to; default: study.sbatch, Snakefile or parallel.sh in the study's folder");
  verb.takes("--force", command->force, "Replace the file that -o names");
  verb.takes("--jobs", command->jobs, "N",
             "Into how many jobs the runs are packed; default: of about ten minutes each");
  verb.takes("--resume", command->resume,
             "Take the plan in the folder, also if the study file has changed since");
  add(verb, command->input);
  add(verb, command->messages);
  verb.does([command] { return act(*command); });
}

}  // namespace morula::cli
