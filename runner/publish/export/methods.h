#pragma once
// The methods of a study as a paragraph for a paper, with the sources that it cites.
#include <filesystem>
#include <string>

#include "analysis/study_comparison.h"

namespace morula {

struct Methods {
  std::string text;        // Markdown; sources are cited as [@holm1979]
  std::string references;  // BibTeX of the sources that the text cites, in its order
};

/// Describes the program, the model, the design, seeds, measures, and the tests and corrections that the comparison has
/// used. `database`: the merged study. Its numbers are the comparison's.
Methods methodsOf(const StudyComparison& comparison, const std::filesystem::path& database);

}  // namespace morula
