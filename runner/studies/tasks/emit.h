#pragma once
// Files with which other programs run a study: a job array for Slurm, a Snakefile, a script for GNU parallel. All of
// them start `morula study run FOLDER` with a share or a task, and end with `morula study merge FOLDER`.
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

/// Slurm's MaxArraySize is 1001 unless a site has raised it: a job array for Slurm has no more jobs than this.
inline constexpr std::size_t maxArrayJobs = 1000;

struct EmitOptions {
  Site site = Site::slurm;
  std::size_t shares = 0;  // into how many jobs; 0: of about ten minutes each, and no more than tasks
};

/// The text of the file. It names the study's folder as it was given, and finds the program under the name `morula` in
/// PATH, or where the variable MORULA says. Throws InputError for a folder whose name has control characters or, but
/// for Slurm, braces.
std::string emit(const PlannedStudy& study, const EmitOptions& options);

/// Returns the default path of the file: study.sbatch, Snakefile or parallel.sh in the study's folder.
std::filesystem::path siteFile(const PlannedStudy& study, Site site);

/// Returns the command that starts it.
std::string howToStart(const PlannedStudy& study, Site site, const std::filesystem::path& file);

}  // namespace morula
