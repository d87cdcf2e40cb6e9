#pragma once
// An embryo as the files of a scenario.
#include <string>
#include <vector>

#include "tracks/embryo.h"

namespace morula::tracks {

struct EmbryoFile {
  std::string role;  // "scenario", or as NamedFile::role
  std::string path;  // relative to the scenario's folder
  std::string text;
};

/// The scenario, its DNA, its names where the scenario does not hold them, and a reference for each stage. `stem`: the
/// scenario's file name without ".yaml"; `table`: how the table is called; `heading`: comments with which the scenario
/// begins. All of them can be read.
std::vector<EmbryoFile> writeEmbryo(const Embryo& embryo, const EmbryoOptions& options, const std::string& stem,
                                    const std::string& table, const std::string& heading);

/// Reads a table, named `file` in messages, and writes its embryo. `assumed`: receives sentences for people. Throws
/// InputError with the mistakes of the table, each with its place.
std::vector<EmbryoFile> embryoFromTable(std::string_view text, const std::string& file, const EmbryoOptions& options,
                                        const std::string& stem, std::vector<std::string>& assumed);

}  // namespace morula::tracks
