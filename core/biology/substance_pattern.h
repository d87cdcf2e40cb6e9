#pragma once
// Patterns that stand for substances: a name, or its beginning and '*'.
#include <string_view>

namespace morula {

/// True if the pattern stands for this substance. A beginning with '*' never stands for a reserved substance
/// [biology/substances.h]; '*' alone stands for all.
bool fits(std::string_view pattern, std::string_view substance);

/// Returns true if the pattern stands for any of `substances`: names with single spaces between them, as
/// CellContext::substances gives them.
bool fitsAny(std::string_view pattern, std::string_view substances);

/// Returns true if `wide` stands for every substance that `narrow` stands for.
bool includes(std::string_view wide, std::string_view narrow);

}  // namespace morula
