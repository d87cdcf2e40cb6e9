#pragma once
// Formats names, numbers and lists for messages and for YAML.
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.h"

namespace morula::tracks {

std::string inQuotes(std::string_view text);

/// Returns true if `a` comes before `b`: by letters, and by value where both have numbers, so that 9 comes before 10.
bool precedes(std::string_view a, std::string_view b);

/// Adds the sentence "WHAT: AB, MS, E and 2 more", which lists the cells to which an assumption applies. Adds nothing
/// if there are no cells.
void assume(std::vector<std::string>& sentences, const std::string& what, const std::vector<std::string>& cells);

/// Returns a name in YAML, in quotes only if YAML would read it as something else.
std::string word(const std::string& text);

std::string rounded(double a, int decimals = 3);
/// Returns "[1, 0, -0.5]".
std::string triple(const Vector& v);
/// Returns "{a: 1, b: 2}", in several lines if it is long.
std::string flow(const std::vector<std::string>& entries, char open, char close);
/// Returns the text as a YAML comment: short lines that begin with '#'.
std::string comment(const std::string& text);

}  // namespace morula::tracks
