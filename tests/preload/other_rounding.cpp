// A library for LD_PRELOAD that changes the processor's rounding before the program begins, as libraries linked with
// -ffast-math do. OTHER_ROUNDING: flush, or up.
#include <cfenv>
#include <cstdlib>
#include <cstring>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace {

__attribute__((constructor)) void change() {
  const char* how = std::getenv("OTHER_ROUNDING");
  if (!how) return;
  if (std::strcmp(how, "up") == 0) std::fesetround(FE_UPWARD);
#ifdef __SSE2__
  constexpr unsigned flushToZero = 0x8000, denormalsAreZero = 0x0040;
  if (std::strcmp(how, "flush") == 0) _mm_setcsr(_mm_getcsr() | flushToZero | denormalsAreZero);
#endif
}

}  // namespace
