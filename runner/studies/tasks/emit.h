#pragma once
// Files with which other programs run a study: a job array for Slurm, a Snakefile, a script for GNU parallel. All start
// `morula study run FOLDER` with a share or a task, and end with `morula study merge FOLDER`.
#include <array>
#include <filesystem>
#include <string>

#include "base/choice.h"
#include "tasks/study_folder.h"

namespace morula {

enum class Site { slurm, snakemake, parallel };
template <>
inline constexpr auto choices<Site> =
    std::to_array<Choice<Site>>({{Site::slurm, "slurm", "a job array for Slurm's sbatch"},
                                 {Site::snakemake, "snakemake", "a Snakefile, for Snakemake 7 and later"},
                                 {Site::parallel, "parallel", "a script that starts GNU parallel"}});

/// Max jobs of an array for Slurm: its MaxArraySize is 1001 unless a site has raised the limit.
inline constexpr std::size_t maxArrayJobs = 1000;

struct EmitOptions {
  Site site = Site::slurm;
  std::size_t shares = 0;  // number of jobs; 0: jobs of about ten minutes, and no more than tasks
};

/// Returns the text of the file. The text names the study's folder as given, and starts the program as `morula` from
/// PATH, or by the variable MORULA. Throws InputError for a folder whose name has control characters or, but for Slurm,
/// braces.
std::string emit(const PlannedStudy& study, const EmitOptions& options);

/// Returns the default path of the file: study.sbatch, Snakefile or parallel.sh in the study's folder.
std::filesystem::path siteFile(const PlannedStudy& study, Site site);

/// Returns the command that starts the file.
std::string howToStart(const PlannedStudy& study, Site site, const std::filesystem::path& file);

}  // namespace morula
