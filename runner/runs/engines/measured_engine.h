#pragma once
// The engines that compute the rows of a benchmark or of speed against error.
#include <array>

#include "base/choice.h"
#include "values/baseline.h"

namespace morula {

enum class MeasuredEngine { morula, scalar, bulletB1, bulletB2, bulletB3 };
template <>
inline constexpr auto choices<MeasuredEngine> = std::to_array<Choice<MeasuredEngine>>(
    {{MeasuredEngine::morula, "morula", "this program"},
     {MeasuredEngine::scalar, "scalar", "this program's forces in ordinary code"},
     {MeasuredEngine::bulletB1, "bullet-b1", "Bullet, B1"},
     {MeasuredEngine::bulletB2, "bullet-b2", "Bullet, B2"},
     {MeasuredEngine::bulletB3, "bullet-b3", "Bullet, B3"}});

inline MeasuredEngine measuredEngine(Baseline baseline) {
  return baseline == Baseline::b1   ? MeasuredEngine::bulletB1
         : baseline == Baseline::b2 ? MeasuredEngine::bulletB2
                                    : MeasuredEngine::bulletB3;
}

}  // namespace morula
