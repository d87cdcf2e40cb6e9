#include "tasks/emit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "files/text.h"

namespace morula {
namespace {

constexpr double secondsPerJob = 600;

/// Returns a job's time limit [s]: three times the predicted time, for slower machines, and at least ten minutes. If
/// the study limits the CPU time of a run, a job gets no more than its runs together may take.
std::optional<double> secondsFor(const Plan& plan, std::size_t shares) {
  const auto cost = totalCost(plan);
  const double most = std::ceil(double(plan.tasks.size()) / double(shares));
  std::optional<double> seconds;
  if (cost) {
    const double longest = std::ranges::max(plan.costs, {}, &RunCost::seconds).seconds;
    seconds = std::max(3 * (cost->seconds / double(shares) + longest), 600.0);
  }
  if (plan.study.limits.cpu) {
    const double limited = most * (*plan.study.limits.cpu + 1) + 60;
    seconds = seconds ? std::min(*seconds, std::max(limited, 600.0)) : limited;
  }
  return seconds;
}

/// Returns a job's memory [MB]: the runs' limit, or twice the predicted memory, and 512 for the program.
std::optional<std::uint64_t> megabytesFor(const Plan& plan) {
  const auto cost = totalCost(plan);
  double bytes = 0;
  if (plan.study.limits.memory) bytes = static_cast<double>(*plan.study.limits.memory);
  else if (cost) bytes = 2 * cost->memory;
  else return std::nullopt;
  return static_cast<std::uint64_t>(std::ceil(bytes / 1e6)) + 512;
}

std::uint64_t minutes(double seconds) { return static_cast<std::uint64_t>(std::ceil(seconds / 60)); }

/// Returns the study's folder as an argument of a command.
std::string folderOf(const PlannedStudy& study) {
  const std::string folder = study.folder.path().string();
  return folder.starts_with('-') ? "./" + folder : folder;
}

/// Escapes '%', which Slurm replaces by the job's numbers.
std::string slurmFile(const std::string& path) {
  std::string name;
  for (const char c : path) name += c == '%' ? "%%" : std::string(1, c);
  return name;
}

std::string slurm(const PlannedStudy& study, std::size_t shares) {
  const Plan& plan = study.plan;
  const std::string folder = folderOf(study), word = shellWord(folder);
  std::string text = "#!/bin/bash\n#SBATCH --job-name=" + plan.study.name +
                     fmt::format("\n#SBATCH --array=1-{}\n", shares) +
                     "#SBATCH --ntasks=1\n#SBATCH --cpus-per-task=1\n";
  if (const auto megabytes = megabytesFor(plan)) text += fmt::format("#SBATCH --mem={}M\n", *megabytes);
  if (const auto seconds = secondsFor(plan, shares)) text += fmt::format("#SBATCH --time={}\n", minutes(*seconds));
  text += "#SBATCH --output=" + shellWord(slurmFile(folder) + "/slurm-%A_%a.log") + "\n";
  text += "#SBATCH --requeue\n";
  text += fmt::format(
      "#\n# The study {}: {} runs in {} jobs. Start it where `morula study emit` was called:\n"
      "#   sbatch FILE && squeue --me          # FILE: this file; runs with a result are not computed again\n"
      "#   morula study status {}              # shows the progress\n"
      "#   morula study merge {}               # merges the results at the end\n"
      "# Set MORULA to the path of the program if it is not in PATH.\n"
      "set -eu\n"
      "exec \"${{MORULA:-morula}}\" study run {} --shard \"$SLURM_ARRAY_TASK_ID/{}\" \\\n"
      "  --jobs \"${{SLURM_CPUS_PER_TASK:-1}}\" --quiet\n",
      plan.study.name, plan.tasks.size(), shares, word, word, word, shares);
  return text;
}

std::string snakemake(const PlannedStudy& study, std::size_t shares) {
  const Plan& plan = study.plan;
  const std::string folder = jsonText(Json(folderOf(study)));  // a JSON string is also a string of Python
  std::string text = fmt::format(
      "# The study {}: {} runs. Needs Snakemake 7 or later. Start it where `morula study emit` was called:\n"
      "#   snakemake --snakefile FILE --cores 8\n"
      "# On a cluster, --group-components runs={} puts several runs into one job.\n"
      "# Set MORULA to the path of the program if it is not in PATH.\n"
      "import os\n\n"
      "FOLDER = {}\nMORULA = os.environ.get(\"MORULA\", \"morula\")\n",
      plan.study.name, plan.tasks.size(), (plan.tasks.size() + shares - 1) / shares, folder);
  text += "TASKS = [\n";
  for (const Task& task : plan.tasks) text += "    \"" + task.id + "\",\n";
  text += "]\n\n\n";
  text +=
      "localrules: merge\n\n\n"
      "rule merge:\n"
      "    input:\n        expand(os.path.join(FOLDER, \"tasks\", \"{task}.db\"), task=TASKS)\n"
      "    output:\n        os.path.join(FOLDER, \"study.db\")\n"
      "    params:\n        folder=FOLDER, morula=MORULA\n"
      "    shell:\n        \"{params.morula:q} study merge {params.folder:q} --quiet >/dev/null\"\n\n\n"
      "rule task:\n"
      "    output:\n        os.path.join(FOLDER, \"tasks\", \"{task}.db\")\n"
      "    wildcard_constraints:\n        task=\"[0-9a-f]+\"\n"
      "    params:\n        folder=FOLDER, morula=MORULA\n"
      "    group: \"runs\"\n    threads: 1\n";
  std::string resources;
  if (const auto megabytes = megabytesFor(plan)) resources += fmt::format("mem_mb={}", *megabytes);
  if (const auto seconds = secondsFor(plan, plan.tasks.size()))
    resources += fmt::format("{}runtime={}", resources.empty() ? "" : ", ", minutes(*seconds));
  if (!resources.empty()) text += "    resources:\n        " + resources + "\n";
  text +=
      "    shell:\n        \"{params.morula:q} study run {params.folder:q} --task {wildcards.task} --quiet "
      ">/dev/null\"\n";
  return text;
}

std::string parallel(const PlannedStudy& study, std::size_t shares) {
  const std::string folder = folderOf(study), word = shellWord(folder);
  const std::string job = fmt::format("\"$MORULA\" study run {} --shard {{}}/{} --quiet >/dev/null", word, shares);
  return fmt::format(
      "#!/bin/sh\n"
      "# The study {}: {} runs in {} jobs, one for each processor at a time, or four with `sh FILE --jobs 4`.\n"
      "# Start it where `morula study emit` was called. Runs with a result are not computed again.\n"
      "# Set MORULA to the path of the program if it is not in PATH.\n"
      "set -eu\n"
      "export MORULA=\"${{MORULA:-morula}}\"\n"
      "# shellcheck disable=SC2016  # expanded by the shell of each job\n"
      "seq {} | parallel \"$@\" --joblog {} {}\n"
      "exec \"$MORULA\" study merge {}\n",
      study.plan.study.name, study.plan.tasks.size(), shares, shares, shellWord(folder + "/parallel.log"),
      shellWord(job), word);
}

/// Returns a number of jobs that makes none much shorter than ten minutes, since a scheduler takes seconds for each.
std::size_t sharesFor(const Plan& plan) {
  const std::size_t tasks = std::max<std::size_t>(plan.tasks.size(), 1);
  const auto cost = totalCost(plan);
  const double jobs = cost ? std::ceil(cost->seconds / secondsPerJob) : 100;
  return std::min({static_cast<std::size_t>(std::clamp(jobs, 1.0, double(maxArrayJobs))), tasks, maxArrayJobs});
}

}  // namespace

std::string emit(const PlannedStudy& study, const EmitOptions& options) {
  for (const unsigned char c : study.folder.path().string())
    if (c < 0x20 || c == 0x7F)  // a line feed would begin a new line of the script
      throw InputError("the study's folder '" + study.folder.path().string() +
                       "' has a line end or another control character in its name; rename the folder");
  if (options.site != Site::slurm && study.folder.path().string().find_first_of("{}") != std::string::npos)
    throw InputError("the study's folder '" + study.folder.path().string() +
                     "' has a brace in its name, and Snakemake and GNU parallel would replace it; rename the folder");
  const std::size_t tasks = std::max<std::size_t>(study.plan.tasks.size(), 1);
  const std::size_t shares = options.shares ? std::min(options.shares, tasks) : sharesFor(study.plan);
  if (options.site == Site::slurm) return slurm(study, std::min(shares, maxArrayJobs));
  if (options.site == Site::snakemake) return snakemake(study, shares);
  // Jobs on one machine cost little. With 200 of them, if there are as many runs, all processors end at about one time.
  return parallel(study, options.shares ? shares : std::min<std::size_t>(tasks, std::max<std::size_t>(shares, 200)));
}

std::filesystem::path siteFile(const PlannedStudy& study, Site site) {
  static constexpr const char* names[] = {"study.sbatch", "Snakefile", "parallel.sh"};
  return study.folder.path() / names[static_cast<int>(site)];
}

std::string howToStart(const PlannedStudy& study, Site site, const std::filesystem::path& file) {
  const std::string name = shellWord(file.string());
  if (site == Site::slurm) return "sbatch " + name + "; afterwards: morula study merge " + shellWord(folderOf(study));
  return site == Site::snakemake ? "snakemake --snakefile " + name + " --cores 8" : "sh " + name;
}

}  // namespace morula
