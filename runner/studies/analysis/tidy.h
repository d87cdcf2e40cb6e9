#pragma once
// A study's values for pandas, R and similar programs: one value a row, after the labels of all axes.
#include <filesystem>
#include <functional>
#include <string_view>

#include "base/choice.h"

namespace morula {

enum class TidyRows { runs, cells };
template <>
inline constexpr auto choices<TidyRows> = std::to_array<Choice<TidyRows>>({
    {TidyRows::runs, "runs", "a row for each run, time and measure"},
    {TidyRows::cells, "cells", "a row for each run, time, cell and measure, of the samples that were kept"},
});

/// Hands on a merged study's values as CSV [RFC 4180], a line at a time; lines end in a line feed. Columns: a label for
/// each axis, seed, time, with `cells` the cell's path (or egg), name and substances, then measure, value and the
/// value's unit, the scene's. Conditions that share a run each have its values; runs without a result have none. Throws
/// StoreError if the file is no merged study.
void writeTidy(const std::filesystem::path& file, TidyRows rows,
               const std::function<void(std::string_view line)>& write);

}  // namespace morula
