#include "base/floating_point.h"

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace morula {

void setFloatingPoint() {
#if defined(__SSE2__)
  constexpr unsigned allExceptionsMasked = 0x1f80;  // all other bits are 0: rounding to nearest, neither FTZ nor DAZ
  _mm_setcsr(allExceptionsMasked);
#if defined(__x86_64__)
  const unsigned short usual = 0x037f;  // for the x87 unit, from which libraries read the rounding mode
  asm volatile("fldcw %0" : : "m"(usual));
#endif
#elif defined(__aarch64__)
  asm volatile("msr fpcr, %0" : : "r"(0ul));  // to nearest, no FZ
#endif
}

FloatingPointMode::FloatingPointMode() {
#if defined(__SSE2__)
  control_ = _mm_getcsr();
#if defined(__x86_64__)
  asm volatile("fnstcw %0" : "=m"(x87Control_));
#endif
#elif defined(__aarch64__)
  asm volatile("mrs %0, fpcr" : "=r"(control_));
#endif
  setFloatingPoint();
}

FloatingPointMode::~FloatingPointMode() {
#if defined(__SSE2__)
  _mm_setcsr(static_cast<unsigned>(control_));
#if defined(__x86_64__)
  asm volatile("fldcw %0" : : "m"(x87Control_));
#endif
#elif defined(__aarch64__)
  asm volatile("msr fpcr, %0" : : "r"(control_));
#endif
}

}  // namespace morula
