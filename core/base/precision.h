#pragma once
// The format of the numbers that physics keeps and computes with.
#include "base/choice.h"

namespace morula {

enum class Precision { binary64, binary32 };
template <>
inline constexpr auto choices<Precision> = std::to_array<Choice<Precision>>({
    {Precision::binary64, "double", "16 digits"},
    {Precision::binary32, "single", "7 digits at half the memory and up to twice the speed"},
});

}  // namespace morula
