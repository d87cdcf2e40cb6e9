#pragma once
// Settings by hand that a scenario of tracked cells gets beside what its table gives.
#include <string>
#include <vector>

#include "tracks/embryo.h"
#include "yaml/problems.h"

namespace morula::tracks {

/// Returns the text of a scenario, of sections with at most one line a member, with the settings in it: each replaces
/// the line of its member, or stands at the end of its section. Other lines stay as they are. A setting that is no YAML
/// is a problem.
std::string withSettings(const std::string& text, const std::vector<std::string>& settings,
                         scenario::Problems& problems);

/// Returns the command that makes `stem`.yaml from `table`, one option a line, as a YAML comment.
std::string commandComment(const EmbryoOptions& options, const std::string& stem, const std::string& table);

}  // namespace morula::tracks
