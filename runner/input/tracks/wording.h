#pragma once
// Names, numbers and lists in messages, and as a person writes them in YAML.
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.h"

namespace morula::tracks {

std::string inQuotes(std::string_view text);

/// Returns true if a comes before b: by letters, and by value where both have digits, so that 9 comes before 10.
bool precedes(std::string_view a, std::string_view b);

/// Adds "What is assumed: AB, MS, E and 2 more" for the cells of which it is; nothing if there are none.
void assume(std::vector<std::string>& sentences, const std::string& what, const std::vector<std::string>& cells);

/// A name in YAML: in quotes only where it would be taken for something else.
std::string word(const std::string& text);

std::string rounded(double a, int decimals = 3);
/// "[1, 0, -0.5]"
std::string triple(const Vector& v);
/// "{a: 1, b: 2}", over several lines where it is long.
std::string flow(const std::vector<std::string>& entries, char open, char close);
/// Lines that begin with '#', and are not too long.
std::string comment(const std::string& text);

}  // namespace morula::tracks
