#pragma once
// Suggestions for messages that end in "did you mean …?".
#include <span>
#include <string>
#include <string_view>

namespace morula {

/// The number of letters to insert, delete, replace or swap with their neighbour to turn one word into the
/// other (optimal string alignment). Case counts.
int editDistance(std::string_view a, std::string_view b);

/// True if the words differ at most in the case of ASCII letters.
bool equalButForCase(std::string_view a, std::string_view b);

/// The candidate that was probably meant: equal but for case, or closest by edits and no farther than a third
/// of the word. Digits must agree: a10 and a11 are two names, not a misspelling. Ties go to the earlier candidate.
/// Empty if none is near.
std::string closest(std::string_view word, std::span<const std::string> candidates);

}  // namespace morula
