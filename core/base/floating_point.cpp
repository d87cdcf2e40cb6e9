#include "base/floating_point.h"

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace morula {

void setFloatingPoint() {
#if defined(__SSE2__)
  constexpr unsigned allExceptionsMasked = 0x1f80;  // and all else 0: to nearest, neither FTZ nor DAZ
  _mm_setcsr(allExceptionsMasked);
#if defined(__x86_64__)
  const unsigned short usual = 0x037f;  // the older unit's, from which libraries read how numbers are rounded
  asm volatile("fldcw %0" : : "m"(usual));
#endif
#elif defined(__aarch64__)
  asm volatile("msr fpcr, %0" : : "r"(0ul));  // to nearest, no FZ
#endif
}

}  // namespace morula
